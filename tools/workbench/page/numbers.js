// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of `parison check` and what it finds.

import { element, shown } from "./dom.js";
import { model, on } from "./model.js";
import { word } from "./words.js";

function tiles(check) {
  const plan = check.container || {}, press = plan.press || {};
  const along = check.clearance || [];
  const least = along.length ? Math.min(...along.map((one) => one[2])) : NaN;
  const base = along.length ? along[along.length - 1][2] : NaN; // farthest from the finish
  const all = [
    ["glassWeight", check.weight_g, "g", 1],
    ["stop", press.stop_mm, "mm", 2],
    ["cavity", press.cavity_cm3, "cm³", 2],
    ["capacity", plan.capacity_ml, "ml", 1],
    ["filled", plan.filled_ml, "ml", 1],
    ["ullage", plan.ullage_ml, "ml", 1],
    least < -1e-6 ? ["overlap", -least, "mm", 2] : ["clearance", base, "mm", 1],
  ];
  return all
    .filter(([, value]) => Number.isFinite(value))
    .map(([name, value, unit, places]) =>
      element("div", { id: `number-${name}`, class: name === "overlap" ? "bad" : null },
        element("dt", {}, word(name)), element("dd", {}, `${shown(value, places)} ${unit}`)));
}

function notes(check, goTo) {
  const list = [];
  if (check.problem) {
    const where = check.problem.line ? element("button", { class: "link", onclick: () => goTo(check.problem) }, `${word("line")} ${check.problem.line}`) : null;
    list.push(element("p", { class: "bad", role: "alert", id: "problem" }, where, where ? ": " : null, check.problem.key ? `${check.problem.key}: ` : null, check.problem.sentence));
  }
  if (check.cannot_begin) list.push(element("p", { class: "bad" }, `${word("cannotBegin")}: ${check.cannot_begin}`));
  if (check.container && check.container.misfit) list.push(element("p", { class: "bad" }, check.container.misfit));
  const found = check.findings || [];
  if (found.length) list.push(element("p", { class: "warn" }, word("findings")), element("ul", {}, ...found.map((one) => element("li", {}, one))));
  else if (!check.problem) list.push(element("p", { class: "soft" }, word("noFindings")));
  return list;
}

export function numbersPart(goTo) {
  const numbers = element("dl", { class: "tiles", id: "numbers" }), told = element("div", { class: "told" });
  on("check", () => {
    if (model.check.bodies) numbers.replaceChildren(...tiles(model.check));
    numbers.classList.toggle("old", !model.check.bodies);
    told.replaceChildren(...notes(model.check, goTo));
  });
  return element("section", { class: "numbers" }, numbers, told);
}
