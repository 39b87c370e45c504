// SPDX-License-Identifier: GPL-3.0-or-later
// The section of glass and tools in mm, both halves, with handles, clearances and the sketch.

import { drawn, element, shown } from "./dom.js";
import { cornerHandles, dimensionHandles } from "./handles.js";
import { model, on, sketch, tell } from "./model.js";
import { wallChart, wantedWall } from "./wall.js";
import { word } from "./words.js";

const pairs = (flat) => flat.reduce((all, x, i) => (i % 2 ? (all[all.length - 1].push(x), all) : (all.push([x]), all)), []);

/** What is to be seen at first: the glass and all tools but the long shank of the plunger. */
function extentOf(check) {
  const plunger = check.container && check.container.press && check.container.press.tool;
  const seen = check.bodies.filter((body) => body.name !== plunger).flatMap((body) => pairs(body.outline_mm).map(([r, z]) => [r, z + body.position_mm]));
  const r = Math.max(...seen.map((x) => x[0])), z = seen.map((x) => x[1]);
  return { left: check.axisymmetric ? -r : Math.min(...seen.map((x) => x[0])), right: r, low: Math.min(...z), high: Math.max(...z) };
}

export class Drawing {
  constructor() {
    this.zoom = 1;
    this.shift = [0, 0];
    this.stage = 0;
    this.turned = true;
    this.corners = true;
    this.svg = drawn("svg", { class: "section", role: "group", "aria-label": word("section") });
    this.stages = element("div", { class: "stages", role: "group" });
    this.reading = element("span", { class: "soft reading" });
    this.sketchLine = element("span", { class: "soft sketch-line", role: "status" });
    this.element = element("section", { class: "drawing" }, element("div", { class: "bar" }, this.stages, ...this.controls()), this.svg,
      element("div", { class: "bar" }, this.sketchControls(), wantedWall(), this.sketchLine, this.reading));
    this.svg.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.svg.addEventListener("pointerdown", (event) => this.grip(event));
    this.svg.addEventListener("pointermove", (event) => this.point(event));
    new ResizeObserver(() => this.draw()).observe(this.svg);
    for (const event of ["check", "handles", "sketch"]) on(event, () => this.draw());
  }

  controls() {
    const button = (text, title, action) => element("button", { title, "aria-label": title, onclick: () => (action(), this.draw()) }, text);
    const tick = (name, label) => {
      const box = element("input", { type: "checkbox", checked: this[name], onchange: () => ((this[name] = box.checked), this.draw()) });
      return element("label", { class: "tick" }, box, word(label));
    };
    return [tick("turned", "turned"), tick("corners", "corners"), button("+", word("closer"), () => (this.zoom *= 1.4)),
      button("−", word("farther"), () => (this.zoom = Math.max(0.5, this.zoom / 1.4))), button(word("whole"), word("whole"), () => ((this.zoom = 1), (this.shift = [0, 0])))];
  }

  sketchControls() {
    const box = element("input", { type: "checkbox", checked: Boolean(model.follows), onchange: () => ((model.follows = box.checked), box.checked && sketch()) });
    return element("span", {}, element("button", { id: "sketch", onclick: () => sketch() }, word("sketch")), " ", element("label", { class: "tick" }, box, word("sketchFollows")));
  }

  /** Pixels of a place in mm; `side` -1 is the mirrored half. */
  place(r, z, side = 1) {
    return [this.scale * (side * r - this.middle[0]) + this.width / 2 + this.shift[0], -this.up * this.scale * (z - this.middle[1]) + this.height / 2 + this.shift[1]];
  }
  /** Place in mm of pixels of the window. */
  back(event) {
    const box = this.svg.getBoundingClientRect();
    return [(event.clientX - box.left - this.width / 2 - this.shift[0]) / this.scale + this.middle[0],
      (event.clientY - box.top - this.height / 2 - this.shift[1]) / (-this.up * this.scale) + this.middle[1]];
  }

  draw() {
    const check = model.check;
    this.tellSketch();
    if (check && check.bodies) this.last = check;
    if (!this.last) return;
    this.width = this.svg.clientWidth;
    this.height = this.svg.clientHeight;
    if (this.name !== model.name) Object.assign(this, { name: model.name, zoom: 1, shift: [0, 0], stage: 0 });
    this.stage = Math.min(this.stage, this.last.stages.length - 1);
    if (!this.extent || !this.held) this.extent = extentOf(this.last);
    const { left, right, low, high } = this.extent, chart = this.last.clearance && this.last.clearance.length ? 70 : 0;
    this.up = this.turned && !this.last.stages[this.stage].upright ? -1 : 1;
    this.middle = [(left + right) / 2, (low + high) / 2];
    this.scale = this.zoom * Math.min((this.width - 2 * chart - 20) / (right - left), (this.height - 24) / (high - low));
    this.showStages();
    this.svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    const focused = document.activeElement && this.svg.contains(document.activeElement) ? document.activeElement.getAttribute("aria-label").split(":")[0] : "";
    this.svg.replaceChildren(...this.bodies(), ...this.sketchShapes(), this.axis(), ...this.clearances(), ...(this.isLast() ? wallChart(this) : []), ...this.handles());
    if (focused) [...this.svg.querySelectorAll("[tabindex]")].find((one) => one.getAttribute("aria-label").split(":")[0] === focused)?.focus({ preventScroll: true });
  }

  showStages() {
    const names = this.last.stages.map((stage, i) =>
      element("button", { "aria-pressed": String(i === this.stage), onclick: () => ((this.stage = i), this.draw()) }, stage.name));
    if (this.stages.textContent !== this.last.stages.map((stage) => stage.name).join("") || !this.stages.querySelector(`button:nth-child(${this.stage + 1})[aria-pressed=true]`))
      this.stages.replaceChildren(...names);
  }

  path(points, shift, closed) {
    const half = (side) => points.map(([r, z], i) => `${i ? "L" : "M"}${this.place(r, z + shift, side).map((x) => x.toFixed(1)).join(" ")}`).join("") + (closed ? "Z" : "");
    return half(1) + (this.last.axisymmetric ? half(-1) : "");
  }

  bodies() {
    const stage = this.last.stages[this.stage], press = this.last.container && this.last.container.press;
    const shapes = [];
    this.last.bodies.forEach((body, i) => {
      const isGlass = i === 0, first = this.stage === 0;
      if (isGlass ? !first : !stage.tools.includes(body.name)) return;
      const atStop = press && press.tool === body.name && press.stage === stage.name;
      const title = drawn("title", {}, body.name);
      shapes.push(drawn("path", { class: isGlass ? "glass" : `tool tool${i % 6}`, d: this.path(pairs(body.outline_mm), body.position_mm, true), "data-body": body.name }, title));
      if (atStop) shapes.push(drawn("path", { class: "at-stop", d: this.path(pairs(body.outline_mm), press.stop_mm, true) }));
    });
    return shapes;
  }

  isLast() {
    return this.stage === this.last.stages.length - 1;
  }

  sketchShapes() {
    const outlines = model.sketch && model.sketch.outlines_mm;
    if (!outlines || !this.isLast()) return [];
    const old = model.sketch.running || model.sketch.version !== model.version;
    return outlines.map((line) => drawn("path", { class: old ? "wall old" : "wall", d: this.path(pairs(line), 0, false) }));
  }

  axis() {
    const [x, low] = this.place(0, this.extent.low), high = this.place(0, this.extent.high)[1];
    return drawn("path", { class: "axis", d: `M${x} ${low}V${high}` });
  }

  /** A bar for each place of the outside of the parison: green as long as its clearance, red where it stands in the mould. */
  clearances() {
    const all = this.last.clearance || [];
    if (!all.length) return [];
    const most = Math.max(5, ...all.map((one) => Math.abs(one[2]))), x = this.width - 62, size = 54 / most;
    const bars = all.map(([, z, c]) => {
      const y = this.place(0, z)[1];
      return drawn("path", { class: c < -1e-6 ? "bad-bar" : "good-bar", d: `M${x} ${y}h${Math.max(1.5, size * Math.abs(c))}` });
    });
    const label = drawn("text", { x: this.width - 4, y: 14, "text-anchor": "end" }, `${word("clearanceTitle")} ${shown(most, 0)} mm`);
    return [drawn("g", { class: "clearance", role: "img", "aria-label": word("clearanceHelp") }, drawn("title", {}, word("clearanceHelp")), drawn("path", { class: "base", d: `M${x} 20V${this.height - 6}` }), ...bars, label)];
  }

  handles() {
    if (!model.handles || model.bundled || !this.last.axisymmetric) return [];
    const active = this.last.stages[this.stage].tools;
    return [...(this.corners ? cornerHandles(this, active) : []), ...dimensionHandles(this, active)];
  }

  tellSketch() {
    const now = model.sketch;
    let text = "";
    if (now && now.running) text = word("sketchRuns");
    else if (now && now.problem) text = word("sketchFailed", now.problem);
    else if (now && now.outlines_mm && now.version !== model.version) text = now.results ? word("resultOld", now.results) : word("sketchOld");
    else if (now && now.outlines_mm) text = word(now.results ? "resultThere" : "sketchThere", shown(now.thickness_min_mm), shown(now.thickness_mean_mm), now.results);
    if (now && now.wanted_problem) text = now.wanted_problem;
    else if (now && now.outside >= 0 && !now.running) text += `; ${now.outside ? word("outsideBand", shown(100 * now.outside, 0), shown(Math.abs(now.worst_mm)), word(now.worst_mm > 0 ? "tooThick" : "tooThin"), shown(now.worst_z_mm, 0)) : word("insideBand")}`;
    this.sketchLine.textContent = text;
    if (now && now.outlines_mm && !now.running && now !== this.seen && this.last) {
      this.seen = now;
      this.stage = this.last.stages.length - 1;
    }
  }

  wheel(event) {
    event.preventDefault();
    const before = this.back(event);
    this.zoom = Math.min(60, Math.max(0.5, this.zoom * Math.exp(-0.0015 * event.deltaY)));
    this.draw();
    const after = this.back(event);
    this.shift[0] += (after[0] - before[0]) * this.scale;
    this.shift[1] += (after[1] - before[1]) * -this.up * this.scale;
    this.draw();
  }

  grip(event) {
    if (event.target.closest(".handle") || event.button !== 0) return;
    const from = [event.clientX - this.shift[0], event.clientY - this.shift[1]];
    this.svg.setPointerCapture(event.pointerId);
    const move = (at) => ((this.shift = [at.clientX - from[0], at.clientY - from[1]]), this.draw());
    this.svg.addEventListener("pointermove", move);
    this.svg.addEventListener("pointerup", () => this.svg.removeEventListener("pointermove", move), { once: true });
  }

  point(event) {
    if (!this.scale) return;
    const [r, z] = this.back(event), body = event.target.dataset && event.target.dataset.body;
    this.reading.textContent = `${body ? body + ", " : ""}r ${shown(Math.abs(r), 1)} mm, z ${shown(z, 1)} mm`;
  }
}
