// SPDX-License-Identifier: GPL-3.0-or-later
// The wall of the finished glass over the height, beside the section, and the wanted one from a table beside the case.

import { ask, tryAsk } from "./api.js";
import { drawn, element, shown } from "./dom.js";
import { model, on, wantWall } from "./model.js";
import { word } from "./words.js";

const wide = 84, left = 8; // px

/** The choice of the table, and a button that brings one. */
export function wantedWall() {
  const choice = element("select", { id: "wanted", "aria-label": word("wantedWall"), onchange: () => wantWall(choice.value) });
  const list = async (chosen) => {
    const { tables } = await ask("drawings", { case: model.name }).catch(() => ({ tables: [] }));
    choice.replaceChildren(element("option", { value: "" }, word("wantedWall")), ...tables.map((one) => element("option", { value: one, selected: one === chosen }, one)));
  };
  const file = element("input", { type: "file", accept: ".csv", id: "wanted-file", hidden: true, onchange: () => file.files[0] && take(file.files[0]) });
  const take = (one) => {
    const reader = new FileReader();
    reader.onload = async () => {
      const taken = await tryAsk("wanted", { case: model.name, wanted: one.name, text: reader.result });
      if (taken) await wantWall(one.name);
      await list(model.wanted);
    };
    reader.readAsText(one, "latin1");
  };
  let caseName = "";
  on("case", () => {
    if (caseName !== model.name) list(model.wanted);
    caseName = model.name;
  });
  return element("span", { class: "bar", title: word("wantedHelp"), ondragover: (event) => event.preventDefault(), ondrop: (event) => (event.preventDefault(), event.dataTransfer.files[0] && take(event.dataTransfer.files[0])) },
    choice, element("button", { id: "wanted-open", onclick: () => file.click() }, "CSV …"), file);
}

/** The thickness as a line, the wanted band as an area, red where the one is outside the other. */
export function wallChart(drawing) {
  const wall = model.sketch && model.sketch.wall;
  if (!wall || !wall.length) return [];
  const hasBand = wall[0].length > 2, most = Math.max(...wall.map((one) => Math.max(...one.slice(1)))), size = wide / most;
  const at = (z, thickness) => `${(left + size * Math.max(0, thickness)).toFixed(1)} ${drawing.place(0, z)[1].toFixed(1)}`;
  const line = (rows, column) => rows.map((row, i) => `${i ? "L" : "M"}${at(row[0], row[column])}`).join("");
  const isOutside = ([, thickness, low, high]) => thickness < low || thickness > high;
  const wrong = wall.map((row, i) => (hasBand && i && (isOutside(row) || isOutside(wall[i - 1])) ? line([wall[i - 1], row], 1) : "")).join("");
  return [drawn("g", { class: "wall-chart", role: "img", "aria-label": word("wallTitle") }, drawn("title", {}, word("wallTitle")), drawn("path", { class: "base", d: `M${left} 20V${drawing.height - 6}` }),
    hasBand ? drawn("path", { class: "band", d: `${line(wall, 2)}${line([...wall].reverse(), 3).replace("M", "L")}Z` }) : null, drawn("path", { class: "line", d: line(wall, 1) }),
    wrong ? drawn("path", { class: "wrong", d: wrong }) : null, drawn("text", { x: left, y: 14 }, `${word("wallUpTo")} ${shown(most, 1)} mm`))];
}
