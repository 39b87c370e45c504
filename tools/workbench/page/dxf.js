// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing: its layers, the clicks that place it, and the part of it that a boundary of a tool gets.

import { tryAsk } from "./api.js";
import { drawn, element, shown } from "./dom.js";
import { change, model, on } from "./model.js";
import { word } from "./words.js";

const clicks = ["axisClick", "planeClick", "fromClick", "viaClick", "toClick"];
const ends = { fromClick: "from", viaClick: "via", toClick: "to" };

/** The boundaries of the tools as [key, label]. */
function boundaries() {
  const names = Object.fromEntries((model.values || []).map(([key, value]) => [key, value]));
  const found = Object.keys(names).map((key) => key.match(/^tool\.(\d+)\.boundary\.(\d+)\.name$/)).filter((one) => one);
  return found.map(([key, tool, boundary]) => [`tool.${tool}.boundary.${boundary}.path`, `${names[`tool.${tool}.name`]}: ${names[key]}`]);
}

export function dxfPart() {
  const state = { name: "", unit: "", axis: "y", origin: [0, 0], click: "axisClick", hidden: new Set(), from: null, via: null, to: null, answer: null };
  const files = element("select", { onchange: () => load(files.value) });
  const input = element("input", { type: "file", accept: ".dxf", id: "dxf-file", onchange: () => input.files[0] && take(input.files[0]) });
  const choice = (id, values, action) => element("select", { id, onchange: (event) => action(event.target.value) }, ...values.map((one) => element("option", { value: one }, one)));
  const unit = choice("dxf-unit", ["", "mm", "cm", "in"], (value) => ((state.unit = value), load()));
  const axis = choice("dxf-axis", ["y", "-y", "x", "-x"], (value) => ((state.axis = value), load()));
  const target = element("select", { id: "dxf-target" });
  const layers = element("div", { class: "bar", id: "dxf-layers" });
  const picks = element("div", { class: "bar", role: "radiogroup" });
  const told = element("p", { class: "bad" }), notes = element("p", { class: "soft" }), where = element("p", { class: "number", id: "dxf-where" });
  const svg = drawn("svg", { class: "dxf", role: "img", "aria-label": word("drawing"), onclick: (event) => pick(event) });
  const give = element("button", { class: "main", id: "dxf-give", onclick: () => assign() }, word("give"));

  const originText = () => `(${shown(state.origin[0], 4)}, ${shown(state.origin[1], 4)}) mm`;
  async function load(name = state.name, text = "") {
    if (!name) return;
    state.name = name;
    const asked = { case: model.name, name, text, unit: state.unit, axis: state.axis, origin: originText() };
    const answer = await tryAsk("drawing", asked);
    if (answer) state.answer = answer;
    if (answer && text) await list();
    show();
  }
  const take = (file) => {
    const reader = new FileReader();
    reader.onload = () => load(file.name, reader.result);
    reader.readAsText(file, "latin1"); // a byte is a letter: drawings have code pages of their own
  };
  async function list() {
    const answer = await tryAsk("drawings", { case: model.name });
    if (answer) files.replaceChildren(element("option", { value: "" }, word("chooseDrawing")), ...answer.drawings.map((one) => element("option", { value: one, selected: one === state.name }, one)));
  }
  const visible = () => (state.answer ? state.answer.layers.filter((one) => !state.hidden.has(one.name)) : []);

  /** The end of a curve next to a click, in mm of the case. */
  function nearest(event) {
    const box = svg.getBoundingClientRect(), x = (event.clientX - box.left) / state.scale + state.left, z = state.top - (event.clientY - box.top) / state.scale;
    let best = null, least = Infinity;
    for (const layer of visible())
      for (const curve of layer.curves_mm)
        for (const end of [curve.slice(0, 2), curve.slice(-2)]) {
          const distance = Math.hypot(end[0] - x, end[1] - z);
          if (distance < least) [best, least] = [{ at: end, layer: layer.name }, distance];
        }
    return best;
  }
  /** From the frame of the case to that of the drawing. */
  const inDrawing = ([r, z]) => {
    const [x, y] = { y: [r, z], "-y": [-r, -z], x: [z, -r], "-x": [-z, r] }[state.axis];
    return [x + state.origin[0], y + state.origin[1]];
  };
  function pick(event) {
    const end = nearest(event);
    if (!end) return;
    const place = inDrawing(end.at), along = state.axis.endsWith("y") ? 1 : 0, click = state.click;
    if (click === "axisClick") state.origin[1 - along] = place[1 - along];
    else if (click === "planeClick") state.origin[along] = place[along];
    else Object.assign(state, { [ends[click]]: end.at, layer: end.layer });
    state.click = clicks[(clicks.indexOf(click) + 1) % clicks.length];
    if (click === "axisClick" || click === "planeClick") Object.assign(state, { from: null, via: null, to: null }), load();
    else show();
  }
  const point = ([r, z]) => `"(${shown(Math.abs(r), 4)}, ${shown(z, 4)}) mm"`;
  async function assign() {
    const parts = [`file = "${state.name}"`, state.unit ? `unit = "${state.unit}"` : "", `layer = ${JSON.stringify(state.layer)}`, `from = ${point(state.from)}`, state.via ? `via = ${point(state.via)}` : "", `to = ${point(state.to)}`,
      state.origin.some((x) => x) ? `origin = "${originText()}"` : "", state.axis === "y" ? "" : `axis = "${state.axis}"`].filter((one) => one);
    await change("set", { set: [`${target.value}={ ${parts.join(", ")} }`] });
  }

  function show() {
    const answer = state.answer;
    told.textContent = (answer && answer.problem) || "";
    notes.textContent = answer ? answer.notes.join(" ") : "";
    picks.replaceChildren(...clicks.map((one) => element("button", { role: "radio", "aria-checked": String(one === state.click), onclick: () => ((state.click = one), show()) }, word(one))));
    layers.replaceChildren(...(answer ? answer.layers : []).map((layer) => {
      const box = element("input", { type: "checkbox", checked: !state.hidden.has(layer.name), onchange: () => (state.hidden[box.checked ? "delete" : "add"](layer.name), show()) });
      return element("label", { class: "tick" }, box, `${layer.name} (${layer.curves_mm.length})`);
    }));
    where.textContent = [word("originAt", originText()), ...Object.entries(ends).map(([click, name]) => state[name] && `${word(click)} ${point(state[name])}`)].filter((one) => one).join(", ");
    give.disabled = !(state.from && state.to && target.value) || model.bundled;
    draw();
  }
  function draw() {
    const curves = visible().flatMap((layer) => layer.curves_mm), all = curves.flat(), width = svg.clientWidth || 300, height = svg.clientHeight || 300;
    if (!all.length) return svg.replaceChildren();
    const r = all.filter((_, i) => i % 2 === 0), z = all.filter((_, i) => i % 2), span = (list) => [Math.min(...list), Math.max(...list)];
    const [left, right] = span(r), [low, high] = span(z);
    state.scale = Math.min((width - 30) / (right - left || 1), (height - 30) / (high - low || 1));
    state.left = left - (width / state.scale - right + left) / 2;
    state.top = high + 15 / state.scale;
    const at = (x, y) => [(x - state.left) * state.scale, (state.top - y) * state.scale];
    const path = (curve) => curve.map((_, i) => (i % 2 ? "" : `${i ? "L" : "M"}${at(curve[i], curve[i + 1]).map((x) => x.toFixed(1)).join(" ")}`)).join("");
    const mark = (place, kind) => (place ? [drawn("circle", { class: kind, cx: at(...place)[0], cy: at(...place)[1], r: 5 })] : []);
    const [ox, oy] = at(0, 0);
    svg.replaceChildren(...curves.map((curve) => drawn("path", { d: path(curve) })), drawn("path", { class: "axis", d: `M${ox} 0V${height}M0 ${oy}H${width}` }), ...mark(state.from, "from"), ...mark(state.via, "via"), ...mark(state.to, "to"));
  }

  const panel = element("div", { class: "dxf-tab", ondragover: (event) => event.preventDefault(), ondrop: (event) => (event.preventDefault(), event.dataTransfer.files[0] && take(event.dataTransfer.files[0])) },
    element("p", { class: "soft" }, word("dxfHint")), element("div", { class: "bar" }, input, files),
    element("div", { class: "bar" }, element("label", { class: "tick" }, word("unit"), unit), element("label", { class: "tick" }, word("axisDirection"), axis)),
    layers, picks, svg, where, element("div", { class: "bar" }, target, give), told, notes);
  let caseName = "";
  on("case", () => {
    const chosen = target.value;
    target.replaceChildren(...boundaries().map(([key, label]) => element("option", { value: key, selected: key === chosen }, label)));
    if (caseName !== model.name) list();
    caseName = model.name;
    show();
  });
  new ResizeObserver(draw).observe(svg);
  return panel;
}
