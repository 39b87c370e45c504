// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing: its layers, the clicks that place it, and the part of it that a boundary of a tool gets.

import { tryAsk } from "./api.js";
import { drawn, element, shown } from "./dom.js";
import { change, model, on } from "./model.js";
import { word } from "./words.js";

const clicks = ["axisClick", "planeClick", "fromClick", "toClick", "viaClick"]; // in the order in which they follow each other
const ends = { fromClick: "from", viaClick: "via", toClick: "to" };
const axes = { sheet: ["", "-y", "x", "-x"], step: ["", "x", "-x", "y", "-y", "z", "-z"] }; // "" is what the reader takes without one
const colours = 6;

/** The boundaries of the tools as [key, tool, label], those that the glass may touch and the others. */
function boundaries() {
  const values = Object.fromEntries((model.values || []).map(([key, value]) => [key, value])), touched = [], others = [];
  for (const found of Object.keys(values).map((key) => key.match(/^(tool\.\d+)\.boundary\.\d+\.name$/)).filter((one) => one)) {
    const key = found[0].replace(/name$/, ""), tool = values[`${found[1]}.name`];
    (values[`${key}condition`] === "contact" ? touched : others).push([`${key}path`, tool, `${tool}: ${values[found[0]]}`]);
  }
  return { touched, others };
}

export function dxfPart() {
  const state = { name: "", unit: "", axis: "", turn: "", origin: [0, 0], click: "axisClick", hidden: new Set(), from: null, via: null, to: null, answer: null, zoom: 1, shift: [0, 0] };
  const files = element("select", { "aria-label": word("chooseDrawing"), onchange: () => load(files.value) });
  const input = element("input", { type: "file", accept: ".dxf,.step,.stp", id: "dxf-file", onchange: () => input.files[0] && take(input.files[0]) });
  const unit = element("select", { id: "dxf-unit", onchange: () => ((state.unit = unit.value), load()) }, ...["", "mm", "cm", "in"].map((one) => element("option", { value: one }, one || word("unitOfFile"))));
  const axis = element("select", { id: "dxf-axis", onchange: () => ((state.axis = axis.value), forgetPlaces(), load()) });
  const turn = element("input", { id: "dxf-turn", type: "number", step: "any", onchange: () => ((state.turn = turn.value && `${turn.value} deg`), forgetPlaces(), load()) });
  const target = element("select", { id: "dxf-target", "aria-label": word("tool"), onchange: () => show() });
  const thickness = element("input", { type: "number", step: "any", min: 0, id: "dxf-thickness" });
  const level = element("input", { type: "number", step: "any", value: 0, id: "dxf-level" });
  const layers = element("div", { class: "bar", id: "dxf-layers" });
  const picks = element("div", { class: "bar", role: "radiogroup" });
  const next = element("p", { class: "note", id: "dxf-next", role: "status" });
  const told = element("p", { class: "bad" }), notes = element("p", { class: "soft" }), where = element("span", { class: "number", id: "dxf-where", role: "status" });
  const svg = drawn("svg", { class: "dxf", role: "group", tabindex: 0, "aria-label": word("drawing"), onclick: (event) => click(event), onkeydown: (event) => key(event), onpointerdown: (event) => grip(event) });
  svg.addEventListener("wheel", (event) => wheel(event), { passive: false });
  const whole = element("button", { onclick: () => (Object.assign(state, { zoom: 1, shift: [0, 0] }), draw()) }, word("whole"));
  const give = element("button", { class: "main", id: "dxf-give", onclick: () => assign() }, word("give"));

  const asPoints = element("input", { type: "checkbox", id: "dxf-points" }), sections = element("input", { type: "checkbox", id: "dxf-sections" });
  const tick = (label, ...parts) => element("label", { class: "tick" }, label, ...parts);
  const unitLabel = tick(word("unit"), unit), axisName = element("span"), axisLabel = tick(axisName, axis), turnLabel = tick(word("turnOfCut"), turn, "°"), sectionsLabel = tick(sections, word("withSections"));

  const originText = () => `(${shown(state.origin[0], 4)}, ${shown(state.origin[1], 4)}) mm`;
  const forgetPlaces = () => Object.assign(state, { from: null, via: null, to: null });
  const load = (...asked) => (state.loading = read(...asked));
  async function read(name = state.name, text = "") {
    if (!name) return;
    if (name !== state.name) {
      Object.assign(state, { hidden: new Set(), zoom: 1, shift: [0, 0], click: "axisClick", unit: "", axis: "", turn: "", origin: [0, 0], given: "" }), forgetPlaces();
      unit.value = turn.value = "";
      sections.checked = false;
    }
    state.name = name;
    const asked = { case: model.name, name, text, unit: state.unit, axis: state.axis, turn: state.turn, origin: originText() };
    const answer = await tryAsk("drawing", asked);
    if (answer) state.answer = answer;
    if (answer && answer.cut && state.click === "axisClick") state.click = "planeClick"; // a section of a solid has its axis
    svg.dataset.axis = asked.axis;
    show();
    if (answer && text) await list();
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

  /** The places of a curve that a click takes: its ends, where it crosses the axis; for the axis its middle too. */
  function placesOf(curve) {
    const places = [curve.slice(0, 2), curve.slice(-2)], n = curve.length;
    for (let i = 0; i + 3 < n; i += 2) {
      const [r0, z0, r1, z1] = curve.slice(i, i + 4);
      if (r0 * r1 < 0) places.push([0, z0 + ((z1 - z0) * r0) / (r0 - r1)]);
    }
    if (state.click === "axisClick") places.push(n === 4 ? [(curve[0] + curve[2]) / 2, (curve[1] + curve[3]) / 2] : curve.slice(2 * Math.floor(n / 4), 2 * Math.floor(n / 4) + 2));
    return places;
  }
  /** The place next to one in mm of the case, and the layers that have it; of those that are wanted. */
  function nearest(x, z, wanted = () => true) {
    let best = null, least = Infinity;
    for (const layer of visible())
      for (const at of layer.curves_mm.flatMap(placesOf).filter(wanted)) {
        const distance = Math.hypot(at[0] - x, at[1] - z);
        if (best && Math.hypot(at[0] - best.at[0], at[1] - best.at[1]) < 1e-6) best.layers.push(layer.name);
        else if (distance < least) [best, least] = [{ at, layers: [layer.name] }, distance];
      }
    return best;
  }
  /** The direction of z in the frame of the drawing; the section of a solid is in that of its axis. */
  const way = () => (state.answer.cut || state.axis === "y" ? "" : state.axis);
  /** From the frame of the case to that of the drawing. */
  const inDrawing = ([r, z]) => {
    const [x, y] = { "": [r, z], "-y": [-r, -z], x: [z, -r], "-x": [-z, r] }[way()];
    return [x + state.origin[0], y + state.origin[1]];
  };
  async function click(event) {
    if (state.dragged) return;
    await state.loading; // of the click before
    const box = svg.getBoundingClientRect();
    pick(nearest((event.clientX - box.left) / state.scale + state.left, state.top - (event.clientY - box.top) / state.scale));
  }
  /** Arrow keys lead to the next place in their direction, Enter takes it. */
  async function key(event) {
    const way = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!way && event.key !== "Enter") return;
    event.preventDefault();
    await state.loading;
    const [x, z] = state.cursor || [state.left, state.top], isAhead = ([r, y]) => {
      const along = (r - x) * way[0] + (y - z) * way[1], across = Math.abs((r - x) * way[1]) + Math.abs((y - z) * way[0]);
      return along > 1e-6 && across <= along;
    };
    if (!way) return state.cursor && pick(nearest(x, z));
    const found = state.cursor ? nearest(x, z, isAhead) : nearest(x, z);
    if (found) state.cursor = found.at;
    show();
  }
  function pick(end) {
    if (!end) return;
    const place = inDrawing(end.at), along = way().endsWith("x") ? 0 : 1, click = state.click;
    if (click === "axisClick") state.origin[1 - along] = place[1 - along];
    else if (click === "planeClick") state.origin[along] = place[along] - (way().startsWith("-") ? -1 : 1) * (level.valueAsNumber || 0);
    else state[ends[click]] = end.at;
    if (click === "fromClick") Object.assign(state, { via: null, to: null, layers: end.layers });
    if (click === "toClick") {
      state.layer = state.layers.find((one) => end.layers.includes(one)) || ""; // of all layers where it leads from one to another
      guess();
    }
    state.given = "";
    state.click = clicks[Math.min(clicks.indexOf(click) + 1, clicks.length - 1)];
    if (click === "axisClick" || click === "planeClick") (state.cursor = null), forgetPlaces(), load();
    else show();
  }
  /** The tool that is called as the layer or the file. */
  function guess() {
    const layer = (state.layer || state.name).toLowerCase(), found = layer && boundaries().touched.find(([, tool]) => layer.includes(tool.toLowerCase()) || tool.toLowerCase().includes(layer));
    if (found) target.value = found[0];
  }
  const point = (place) => (place ? `(${shown(Math.abs(place[0]), 4)}, ${shown(place[1], 4)}) mm` : "");
  async function assign() {
    const label = target.selectedOptions[0].text;
    const contour = { key: target.value, file: state.name, unit: state.unit, layer: state.layer, from: point(state.from), via: point(state.via), to: point(state.to),
      origin: state.origin.some((x) => x) ? originText() : "", axis: state.axis, turn: state.turn, thickness: thickness.value && `${thickness.value} mm`, as_points: asPoints.checked, with_sections: state.answer.cut && sections.checked };
    if (!(await change("set", { contour }))) return;
    forgetPlaces();
    Object.assign(state, { click: "fromClick", given: label });
    show();
  }

  function wheel(event) {
    event.preventDefault();
    const box = svg.getBoundingClientRect(), x = event.clientX - box.left - box.width / 2, y = event.clientY - box.top - box.height / 2;
    const zoom = Math.min(100, Math.max(0.5, state.zoom * Math.exp(-0.0015 * event.deltaY))), by = zoom / state.zoom;
    state.shift = [x - by * (x - state.shift[0]), y - by * (y - state.shift[1])];
    state.zoom = zoom;
    draw();
  }
  function grip(event) {
    if (event.button !== 0) return;
    const from = [event.clientX, event.clientY], shift = state.shift;
    state.dragged = false;
    const move = (at) => {
      const by = [at.clientX - from[0], at.clientY - from[1]];
      if (!state.dragged && Math.hypot(...by) < 5) return; // a click of a hand that is not still
      state.dragged = true;
      state.shift = [shift[0] + by[0], shift[1] + by[1]];
      draw();
    };
    addEventListener("pointermove", move);
    addEventListener("pointerup", () => removeEventListener("pointermove", move), { once: true });
  }

  const isReady = () => state.from && state.to && target.value && !model.bundled;
  const nextStep = () => state.given ? word("given", state.given) : word(!state.answer ? "dxfHint" : isReady() ? "nextGive" : `next_${state.click}`);
  /** What a kind of drawing has: a STEP file says its unit, a solid is cut along its axis at an angle. */
  function showKind() {
    const { step, cut, problem } = state.answer || {}, kind = step ? "step" : "sheet";
    unitLabel.hidden = step;
    turnLabel.hidden = !(cut || (step && problem));
    sectionsLabel.hidden = !cut;
    axisName.textContent = word(`axis_${kind}`);
    axis.replaceChildren(...axes[kind].map((one) => element("option", { value: one, selected: one === state.axis }, step && one ? one : word(`axis_${kind}_${one}`))));
  }
  function show() {
    const answer = state.answer;
    showKind();
    told.textContent = (answer && answer.problem) || "";
    notes.textContent = answer ? answer.notes.join(" ") : "";
    next.textContent = nextStep();
    picks.replaceChildren(...clicks.map((one) => element("button", { role: "radio", id: `dxf-${one}`, "aria-checked": String(one === state.click), onclick: () => ((state.click = one), show()) }, word(one))), element("label", { class: "tick" }, word("planeLevel"), level, "mm"), whole);
    layers.replaceChildren(...(answer ? answer.layers : []).map((layer, i) => {
      const box = element("input", { type: "checkbox", checked: !state.hidden.has(layer.name), "data-layer": layer.name, onchange: () => (state.hidden[box.checked ? "delete" : "add"](layer.name), show()) });
      return element("label", { class: `tick layer layer${i % colours}` }, box, `${layer.name || state.name} (${layer.curves_mm.length})`);
    }));
    where.textContent = [state.cursor && word("cursorAt", point(state.cursor)), word("originAt", originText()), ...Object.entries(ends).map(([click, name]) => state[name] && `${word(click)} ${point(state[name])}`)].filter((one) => one).join(", ");
    give.disabled = !isReady();
    draw();
  }
  function draw() {
    const all = visible().flatMap((layer) => layer.curves_mm).flat(), width = svg.clientWidth || 300, height = svg.clientHeight || 300;
    if (!all.length) return svg.replaceChildren();
    const r = all.filter((_, i) => i % 2 === 0), z = all.filter((_, i) => i % 2), span = (list) => [list.reduce((a, b) => Math.min(a, b)), list.reduce((a, b) => Math.max(a, b))];
    const [left, right] = span(r), [low, high] = span(z);
    state.scale = state.zoom * Math.min((width - 30) / (right - left || 1), (height - 30) / (high - low || 1));
    state.left = (left + right) / 2 - (width / 2 + state.shift[0]) / state.scale;
    state.top = (low + high) / 2 + (height / 2 + state.shift[1]) / state.scale;
    const at = (x, y) => [(x - state.left) * state.scale, (state.top - y) * state.scale];
    const path = (curve) => curve.map((_, i) => (i % 2 ? "" : `${i ? "L" : "M"}${at(curve[i], curve[i + 1]).map((x) => x.toFixed(1)).join(" ")}`)).join("");
    const mark = (place, kind) => (place ? [drawn("circle", { class: kind, cx: at(...place)[0], cy: at(...place)[1], r: 5 })] : []);
    const [ox, oy] = at(0, 0), class_ = (layer) => `layer${state.answer.layers.indexOf(layer) % colours}`;
    svg.replaceChildren(...visible().flatMap((layer) => layer.curves_mm.map((curve) => drawn("path", { class: class_(layer), d: path(curve) }))),
      drawn("path", { class: "axis", d: `M${ox} 0V${height}M0 ${oy}H${width}` }), ...mark(state.from, "from"), ...mark(state.via, "via"), ...mark(state.to, "to"), ...mark(state.cursor, "cursor"));
  }

  const panel = element("div", { class: "dxf-tab", ondragover: (event) => event.preventDefault(), ondrop: (event) => (event.preventDefault(), event.dataTransfer.files[0] && take(event.dataTransfer.files[0])) },
    element("div", { class: "bar" }, input, files, unitLabel, axisLabel, turnLabel),
    layers, picks, next, svg, where, element("div", { class: "bar" }, target, give, tick(word("thicknessOfWall"), thickness, "mm"), tick(asPoints, word("asPoints")), sectionsLabel), told, notes);
  let caseName = "";
  on("case", () => {
    const chosen = target.value, { touched, others } = boundaries();
    const group = (label, list) => element("optgroup", { label: word(label) }, ...list.map(([key, , name]) => element("option", { value: key, selected: key === chosen }, name)));
    target.replaceChildren(group("touchesGlass", touched), group("others", others));
    if (caseName !== model.name) list();
    caseName = model.name;
    show();
  });
  new ResizeObserver(draw).observe(svg);
  return panel;
}
