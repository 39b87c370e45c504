// SPDX-License-Identifier: GPL-3.0-or-later
// The text of the case; what is typed is written to the file when it rests, what others write appears.

import { ask, send } from "./api.js";
import {
  Annotation, EditorState, EditorView, HighlightStyle, StreamLanguage, defaultKeymap, drawSelection, highlightActiveLine, indentWithTab, keymap, lineNumbers, lintGutter,
  searchKeymap, setDiagnostics, syntaxHighlighting, tags, toml,
} from "./codemirror/codemirror.min.js";
import { completion } from "./completion.js";
import { element, kept, say } from "./dom.js";
import { inTurn, model, on, takeCase } from "./model.js";
import { word } from "./words.js";

const fromFile = Annotation.define();
const style = HighlightStyle.define([
  { tag: tags.comment, color: "var(--soft)" }, { tag: tags.string, color: "var(--good)" }, { tag: tags.number, color: "var(--accent)" },
  { tag: tags.atom, color: "var(--accent)" }, { tag: tags.propertyName, color: "var(--ink)" }, { tag: tags.keyword, color: "var(--warn)" },
]);

/** The smallest change from one text to another: what is between their equal begins and ends. */
function difference(from, to) {
  let begin = 0, a = from.length, b = to.length;
  while (begin < a && begin < b && from[begin] === to[begin]) ++begin;
  while (a > begin && b > begin && from[a - 1] === to[b - 1]) --a, --b;
  return { from: begin, to: a, insert: to.slice(begin, b) };
}

/** Both versions, of which one is to stay. */
function choose(theirs, mine) {
  return new Promise((resolve) => {
    const side = (title, text) => element("div", {}, element("h3", {}, title), element("pre", { tabindex: 0 }, text));
    const end = (kept) => (dialog.remove(), resolve(kept));
    const dialog = element("dialog", { id: "conflict" }, element("p", {}, word("conflict")), element("div", { class: "sides" }, side(word("theirs"), theirs), side(word("mine"), mine)),
      element("div", { class: "bar" }, element("button", { onclick: () => end(theirs) }, word("keepTheirs")), element("button", { class: "main", onclick: () => end(mine) }, word("keepMine"))));
    dialog.addEventListener("cancel", (event) => event.preventDefault());
    document.body.append(dialog);
    dialog.showModal();
  });
}

export function caseEditor(place) {
  let pause = 0, typed = false, sending = false, name = "", storage = "", view = null;
  let base = 0, baseText = ""; // the version that the text was typed into: the model may be newer

  /** The browser keeps what was typed and is not in the file yet: it outlives the tab and the server. */
  const keep = () => kept(storage, typed ? JSON.stringify({ base: baseText, text: view.state.doc.toString() }) : null);

  /** Types again what a tab or a server that was killed has not written. */
  async function recover() {
    const left = JSON.parse(kept(storage) || "null"), of = name;
    if (!left || left.text === baseText || model.bundled) return kept(storage, null);
    const text = left.base === baseText ? left.text : await choose(baseText, left.text);
    if (of !== name) return;
    if (text === left.text) view.dispatch({ changes: difference(view.state.doc.toString(), text) });
    else keep();
  }

  /** Writes what was typed; where the file has changed meanwhile the user says which text stays. */
  async function write() {
    if (sending) return;
    sending = true;
    let again = typed;
    while (again) {
      again = false; // what is typed meanwhile has its own rest
      typed = false;
      const text = view.state.doc.toString();
      try {
        const answer = await ask("text", { case: name, version: base, text });
        base = answer.version;
        baseText = text;
        if (name === model.name) takeCase(answer);
        say("");
      } catch (error) {
        typed = true;
        if (error.status !== 422) break; // the next key, or the next look, tries again
        const now = await ask("case", { case: name }).catch(() => null);
        if (!now) break;
        const stays = now.text === text ? text : await choose(now.text, text);
        again = typed = stays === text && view.state.doc.toString() !== now.text;
        base = now.version;
        baseText = now.text;
        if (!typed && name === model.name) takeCase(now);
      }
    }
    sending = false;
    keep();
    take();
  }

  function take() {
    if (!view || typed || sending || !place.isConnected) return;
    if (name !== model.name) start();
    base = model.version;
    baseText = model.text;
    const now = view.state.doc.toString();
    if (now !== model.text) view.dispatch({ changes: difference(now, model.text), annotations: fromFile.of(true) });
    mark();
  }

  function mark() {
    const problem = model.broken || (model.check && model.check.problem), marks = [];
    if (problem && problem.line > 0 && problem.line <= view.state.doc.lines) {
      const line = view.state.doc.line(problem.line), last = view.state.doc.line(Math.min(view.state.doc.lines, problem.end_line || problem.line));
      const from = Math.min(line.to, problem.column ? line.from + problem.column - 1 : line.from);
      marks.push({ from, to: Math.max(from, Math.min(last.to, problem.end_column ? last.from + problem.end_column - 1 : line.to)), severity: "error", message: problem.sentence });
    }
    view.dispatch(setDiagnostics(view.state, marks));
  }

  const changed = EditorView.updateListener.of((update) => {
    if (!update.docChanged || update.transactions.some((one) => one.annotation(fromFile))) return;
    typed = true;
    keep();
    clearTimeout(pause);
    pause = setTimeout(() => inTurn(write), 400);
  });

  function start() {
    name = model.name;
    base = model.version;
    baseText = model.text;
    storage = `typed ${model.file}`;
    if (view) view.destroy();
    view = new EditorView({ parent: place, state: EditorState.create({ doc: model.text, extensions: [
      lineNumbers(), highlightActiveLine(), drawSelection(), lintGutter(), StreamLanguage.define(toml), syntaxHighlighting(style), EditorState.readOnly.of(Boolean(model.bundled)),
      completion, keymap.of([...defaultKeymap, ...searchKeymap, indentWithTab]), EditorView.contentAttributes.of({ "aria-label": word("text") }), changed] }) });
    recover();
  }

  model.flush = write;
  model.leave = () => typed && send("text", { case: name, version: base, text: view.state.doc.toString() });
  on("check", () => view && !typed && mark());
  return {
    take: () => (view ? take() : (start(), mark())),
    goTo: (problem) => {
      if (!view) return;
      const line = view.state.doc.line(Math.min(view.state.doc.lines, problem.line || 1));
      view.dispatch({ selection: { anchor: line.from + Math.max(0, (problem.column || 1) - 1) }, effects: EditorView.scrollIntoView(line.from, { y: "center" }) });
      view.focus();
    },
  };
}
