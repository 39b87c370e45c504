// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the case, and the live report of a result.

import { ask, tryAsk } from "./api.js";
import { element, say, shown } from "./dom.js";
import { groups } from "./fields.js";
import { model, news, on, showResult, tell } from "./model.js";
import { word } from "./words.js";

const accuracies = { "draft coarser 2": "sketchAccuracy", draft: "draft", standard: "standard", fine: "fine" };

/** Whether a run has something to look at: a what-if has it when it is through. */
const hasResult = (run) => run.time_s || (run.study && run.state === "completed");

/** Seconds for people. */
const time = (s) => (s < 100 ? `${Math.max(1, Number(s.toPrecision(2)))} s` : s < 6000 ? `${Math.round(s / 60)} min` : `${shown(s / 3600, 1)} h`);
const span = (from, to) => (time(from) === time(to) ? time(from) : `${time(from)} … ${time(to)}`);

function progress(run) {
  const longest = model.check && model.check.stages ? model.check.stages.reduce((sum, one) => sum + one.duration_s, 0) : NaN;
  const at = run.time_s || 0, last = (run.log || "").trim().split("\n").pop(); // a study prints what it has done
  return [element("progress", { max: longest || 1, value: run.state === "completed" ? longest || 1 : at, "aria-label": word("run") }),
    element("p", { class: "number" }, run.time_s ? word("time", shown(at, 3), shown(longest, 2), run.stage || "–") : run.state === "running" ? last : "")];
}

/** Choices that write a line into a text: a value of the case, and `suggested` of what it is now. */
function lineChooser(id, lines, suggested = (value) => value) {
  const to = element("input", { id: `${id}-to`, size: 17, "aria-label": word("newValue") });
  const now = () => suggested(what.selectedOptions[0]?.dataset.value ?? "");
  const what = element("select", { id, "aria-label": word("valueToChange"), onchange: () => (to.value = now()) });
  const add = () => {
    const named = Object.fromEntries(model.values.map(([key, value]) => [key, value]));
    const key = what.value.replace(/^(stage|tool|probe)\.\d+/, (entry) => `${entry.split(".")[0]}.${named[`${entry}.name`]}`);
    lines.value = [lines.value.trim(), `${key}=${to.value}`].filter((line) => line).join("\n");
  };
  on("case", () => {
    const chosen = what.value, written = to.value;
    what.replaceChildren(...groups(model.values || []).map(([, one]) => element("optgroup", { label: one.title },
      ...one.fields.map(([key, label, value]) => element("option", { value: key, "data-value": value }, `${one.title}: ${label.replace(/_/g, " ")}`)))));
    what.value = chosen;
    if (what.value !== chosen || !chosen) what.selectedIndex = 0;
    to.value = what.value === chosen ? written : now();
  });
  return element("div", { class: "bar" }, what, to, element("button", { id: `${id}-add`, onclick: add }, word("addChange")));
}

/** A text of some lines, and those that say something. */
const linesField = (id, label, placeholder) => element("textarea", { id, rows: 3, spellcheck: "false", "aria-label": word(label), placeholder });
const linesOf = (field) => field.value.split("\n").map((line) => line.trim()).filter((line) => line);

/** Bounds around a value: a tenth to either side, of temperatures, whose zero is elsewhere, so many degrees. Assumed: to begin with. */
function boundsOf(value) {
  const number = Number.parseFloat(value), unit = value.replace(/^[-\d.e+]+\s*/i, ""), reach = unit === "degC" ? 20 : 0.1 * Math.abs(number);
  const text = (at) => `${Number(at.toPrecision(4))} ${unit}`.trim();
  return Number.isFinite(number) ? `${text(number - reach)} to ${text(number + reach)}` : value;
}

/** What gives the wall that is wanted: bounds, a goal, and a search, which tells all corners of the bounds that the case refuses before its first run. */
function searchPart(begin) {
  const bounds = linesField("bounds", "bounds", "dimension.blank_end_radius=26 mm to 29 mm\nstage.reheat.duration=1 s to 2 s");
  const wall = element("input", { id: "search-wall", size: 8, value: "even" }), from = element("input", { id: "search-from", size: 8, placeholder: "14 mm" });
  on("sketch", () => (wall.disabled = Boolean(model.wanted)));
  const search = () => linesOf(bounds).length && begin("search", { wall: wall.value, wanted: model.wanted, from: from.value, bounds: linesOf(bounds) });
  return [element("h3", {}, word("search")), element("p", { class: "soft" }, word("searchHint")), lineChooser("bound", bounds, boundsOf), bounds,
    element("div", { class: "bar" }, element("label", { title: word("wallSoughtHelp") }, element("span", {}, word("wallSought")), wall), element("label", {}, element("span", {}, word("countsFrom")), from),
      element("button", { id: "search", onclick: search }, word("startSearch")))];
}

export function runPart(openResult) {
  const select = element("select", { id: "accuracy" }, ...Object.entries(accuracies).map(([value, label]) => element("option", { value, selected: value === "draft" }, word(label))));
  const expected = element("p", { class: "soft", id: "expected" });
  let all = null;
  const showExpected = () => {
    if (!all) return;
    for (const [i, option] of [...select.options].entries()) {
      const one = all[i], cost = one.cpu_to_s ? `, ${word("about")} ${span(one.cpu_from_s, one.cpu_to_s)}` : "";
      option.textContent = `${word(accuracies[option.value])}${cost}, ± ${shown(100 * one.error, 1)} %`;
    }
    const { by } = all[select.selectedIndex];
    expected.textContent = word("expected", word(by === "sketch" ? "bySketch" : by ? "byRun" : by === "" ? "byBundled" : "byNothing", by));
  };
  const state = element("div", { id: "run-state", role: "status" });
  const list = element("ul", { class: "list" });
  const act = async (question) => {
    await tryAsk(question, { results: model.results });
    await news();
  };
  const begin = async (question, asked) => {
    const made = await tryAsk(question, { case: model.name, accuracy: select.value, ...asked });
    if (made) follow(made.results);
    await news();
  };
  const changes = linesField("changes", "changes", "stage.reheat.duration=1.9 s\ntool.blank.temperature=440 degC");
  const compare = () => linesOf(changes).length && begin("what-if", { set: linesOf(changes) });
  const follow = (results) => {
    model.results = results;
    model.run = null;
    tell("results");
  };
  const show = () => {
    const run = model.run;
    if (!run) return state.replaceChildren(element("p", { class: "soft" }, word("noRun")));
    const button = (name, question, main) => element("button", { id: `run-${question}`, class: main ? "main" : null, onclick: () => act(question) }, word(name));
    const resumable = !run.ours && (run.goes_on || (run.study === undefined && ["stopped", "ended", "failed"].includes(run.state)));
    state.replaceChildren(...[element("h3", {}, run.results, " ", element("span", { class: `state ${run.state}` }, word(`state_${run.state}`))), ...progress(run),
      element("div", { class: "bar" }, run.ours ? button("stopRun", "stop") : null, resumable ? button("resumeRun", "resume", true) : null,
        hasResult(run) ? element("button", { id: "run-look", class: run.state === "completed" ? "main" : null, onclick: openResult }, word("openResult")) : null,
        run.state === "completed" && !run.study ? element("button", { id: "run-draw", onclick: () => showResult(model.results).catch((error) => say(error.message)) }, word("drawResult")) : null,
        run.case ? element("a", { id: "run-found", href: `#case=${encodeURIComponent(run.case)}` }, word("openFound")) : null),
      run.told ? element("p", {}, run.told) : null, run.log ? element("details", { open: run.state === "failed" }, element("summary", {}, `${run.results}.log`), element("pre", {}, run.log.replace(/; (?=(and )?at )/g, "\n\n"))) : null].filter((one) => one));
  };
  let seen = "",
    caseName = null;
  on("run", () => {
    const now = JSON.stringify([model.run, model.version]);
    if (now !== seen) show();
    if (!seen || JSON.parse(seen)[0]?.state !== model.run.state) listResults();
    seen = now;
  });
  const listResults = async () => {
    const { results: names, expected: told } = await ask("results", { case: model.name, accuracies: Object.keys(accuracies) }).catch(() => ({ results: [] }));
    all = told;
    showExpected();
    if (!model.results && names.length) follow(names[0]);
    list.replaceChildren(...names.map((name) => element("li", {}, element("button", { class: "link", onclick: () => (follow(name), news()) }, name))));
  };
  on("case", () => {
    if (model.name === caseName) return;
    caseName = model.name;
    model.results = "";
    model.run = null;
    show();
    listResults();
  });
  select.addEventListener("change", showExpected);
  on("handles", listResults);
  on("sketch", () => model.sketch.running || listResults());
  show();
  return element("div", { class: "run" }, element("div", { class: "bar" }, element("label", {}, element("span", {}, word("accuracy")), select), element("button", { class: "main", id: "run-start", onclick: () => begin("run") }, word("startRun"))),
    expected, state, element("h3", {}, word("whatIf")), element("p", { class: "soft" }, word("whatIfHint")), lineChooser("what", changes), changes, element("div", { class: "bar" }, element("button", { id: "compare", onclick: compare }, word("compare"))),
    ...searchPart(begin), element("h3", {}, word("yourResults")), list);
}

/** Buttons that bring the container of a result to other programs. */
function exportBar(results) {
  const own = results.split("/").pop();
  const bring = async (file, name) => {
    const response = await fetch(`export/${encodeURIComponent(`${results}/${file}`)}`).catch(() => null);
    if (!response || !response.ok) return say(response ? (await response.json()).error : word("serverAway"));
    say("");
    const link = element("a", { href: URL.createObjectURL(await response.blob()), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };
  const button = (id, file, name) => element("button", { id: `export-${id}`, title: word(`export_${id}`), onclick: () => bring(file, name) }, word(id));
  return element("span", { class: "bar" }, button("step", "container.step", `${own}.step`), button("stl", "container.stl", `${own}.stl`),
    button("shell", "container.inp", `${own}.inp`), button("wallTable", "thickness.csv", `${own}_wall.csv`));
}

export function resultPart() {
  const empty = element("p", { class: "soft" }, word("noResult"));
  const panel = element("div", { class: "result" }, empty);
  let shownName = "";
  on("run", () => {
    if (!model.run || !hasResult(model.run) || shownName === model.results) return;
    shownName = model.results;
    const address = `result/${encodeURIComponent(model.results)}/${model.run.study ? "#differences" : ""}`;
    panel.replaceChildren(element("p", { class: "bar" }, element("a", { href: address, target: "_blank", rel: "noopener" }, model.results), model.run.study ? null : exportBar(model.results)), element("iframe", { src: address, title: word("result"), loading: "lazy" }));
  });
  return panel;
}
