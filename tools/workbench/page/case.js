// SPDX-License-Identifier: GPL-3.0-or-later
// The screen of a case: section and numbers to the left, values, text, runs and results to the right.

import { tryAsk } from "./api.js";
import { element } from "./dom.js";
import { Drawing } from "./drawing.js";
import { dxfPart } from "./dxf.js";
import { caseEditor } from "./editor.js";
import { valueFields } from "./fields.js";
import { model, on, openCase } from "./model.js";
import { numbersPart } from "./numbers.js";
import { resultPart, runPart } from "./run.js";
import { timingPart } from "./timing.js";
import { word } from "./words.js";

/** Parts of which one is shown, chosen by buttons or arrow keys. */
function tabs(parts) {
  const list = element("div", { role: "tablist", class: "tabs" });
  const body = element("div", { class: "tab-body" });
  const choose = (name) => {
    for (const [one, button, panel] of made) {
      button.setAttribute("aria-selected", one === name);
      button.tabIndex = one === name ? 0 : -1;
      panel.hidden = one !== name;
    }
    list.closest("main")?.classList.toggle("wide", ["drawing", "result", "timing"].includes(name));
  };
  const step = (event, i) => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    const [name, button] = made[(i + by + made.length) % made.length];
    choose(name);
    button.focus();
  };
  const made = Object.entries(parts).map(([name, panel], i) => {
    const button = element("button", { role: "tab", id: `tab-${name}`, onclick: () => choose(name), onkeydown: (event) => step(event, i) }, word(name));
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", button.id);
    list.append(button);
    body.append(panel);
    return [name, button, panel];
  });
  return { element: element("div", { class: "side" }, list, body), choose };
}

function bundledNote() {
  const copy = async () => {
    const like = model.name.replace("bundled:", "");
    for (let i = 1; i < 100; ++i) {
      const name = i === 1 ? `my_${like}` : `my_${like}_${i}`;
      const made = await tryAsk("new", { name, like });
      if (made) return void (location.hash = `case=${encodeURIComponent(made.case)}`);
      if (!document.getElementById("said").textContent.includes("exists")) return;
    }
  };
  return element("p", { class: "note" }, word("bundledHint"), " ", element("button", { onclick: copy }, word("copy")));
}

export async function caseScreen(main, name) {
  const drawing = new Drawing();
  const side = tabs({ values: valueFields((line) => (side.choose("text"), editor.goTo(line))), timing: timingPart(), text: element("div", { class: "text-tab" }), drawing: dxfPart(),
    run: runPart(() => side.choose("result")), result: resultPart() });
  const editor = caseEditor(side.element.querySelector(".text-tab"));
  main.className = "case";
  main.replaceChildren(element("div", { class: "left" }, drawing.element, numbersPart((line) => (side.choose("text"), editor.goTo(line)))), side.element);
  side.choose("values");
  on("case", () => editor.take());
  await openCase(name);
  if (model.bundled) main.querySelector(".left").prepend(bundledNote());
}
