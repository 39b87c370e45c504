// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of the page: head, the screens, keys, what is new.

import { element, kept, say } from "./dom.js";
import { change, forget, model, news, on } from "./model.js";
import { startScreen } from "./start.js";
import { caseScreen } from "./case.js";
import { languageName, otherLanguage, setLanguage, word } from "./words.js";

function applyTheme(theme) {
  document.documentElement.dataset.theme =
    theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
}

function showHead() {
  const dark = document.documentElement.dataset.theme === "dark";
  const history = (name, key) =>
    element("button", { id: name, title: key, disabled: !model[name], onclick: () => change(name) }, word(name));
  const other = (text, action) => element("button", { class: "quiet", onclick: action }, text);
  document.getElementById("head").replaceChildren(
    element("h1", {}, element("a", { href: "#" }, word("title"))),
    element("span", { class: "case", title: model.file }, model.name),
    ...(model.name ? [history("undo", "Ctrl+Z"), history("redo", "Ctrl+Y")] : []),
    element("span", { class: "space" }),
    other(word("language"), () => {
      setLanguage(kept("language", otherLanguage()));
      show();
    }),
    other(word(dark ? "light" : "dark"), () => {
      applyTheme(kept("theme", dark ? "light" : "dark"));
      showHead();
    }),
  );
  document.title = model.name ? `${model.name} – ${word("title")}` : word("title");
}

/** The screen that the address asks for: of a case behind "#case=", else the start. */
async function show() {
  forget();
  say("");
  const name = decodeURIComponent(location.hash.replace(/^#case=?/, "").replace(/^#/, ""));
  on("case", showHead);
  const main = document.getElementById("main");
  try {
    if (name) await caseScreen(main, name);
    else {
      model.name = "";
      model.flush = model.leave = null;
      await startScreen(main);
    }
  } catch (error) {
    say(error.message);
  }
  showHead();
}

function keyPressed(event) {
  if (!(event.ctrlKey || event.metaKey) || !model.name || event.altKey) return;
  const key = event.key.toLowerCase();
  const name = key === "y" || (key === "z" && event.shiftKey) ? "redo" : key === "z" ? "undo" : "";
  if (!name || event.target.matches("input")) return;
  event.preventDefault();
  event.stopPropagation();
  change(name);
}

async function follow() {
  for (;;) {
    await new Promise((resolve) => setTimeout(resolve, document.hidden ? 3000 : 700));
    await news().catch((error) => error.away || say(error.message));
  }
}

setLanguage(kept("language") || (navigator.language.startsWith("de") ? "de" : languageName()));
applyTheme(kept("theme"));
addEventListener("hashchange", show);
addEventListener("pagehide", () => model.leave && model.leave());
addEventListener("keydown", keyPressed, true);
show();
follow();
