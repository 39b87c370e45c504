// SPDX-License-Identifier: GPL-3.0-or-later
// What can be dragged: each named dimension along the way in which it moves its tool, and corners of straight sides.

import { drawn, shown } from "./dom.js";
import { change, model, preview, stopPreview } from "./model.js";
import { word } from "./words.js";

const coarse = 0.1, fine = 0.01; // mm
const rounded = (value, step) => Number((Math.round(value / step) * step).toFixed(4));

/** Follows the pointer: `asked(event)` is what to set there; null where nothing changes. `ended` is called before the change. */
export function followPointer(drawing, event, asked, ended = () => null) {
  event.preventDefault();
  event.stopPropagation();
  const target = drawing.svg;
  target.setPointerCapture(event.pointerId);
  drawing.held = true;
  let last = null;
  const move = (at) => {
    last = asked(at);
    if (last) preview(last);
  };
  const end = (at) => {
    target.removeEventListener("pointermove", move);
    for (const name of ["pointerup", "pointercancel"]) target.removeEventListener(name, end);
    drawing.held = false;
    ended();
    stopPreview();
    if (last && at.type === "pointerup") change("set", last);
    else preview({});
  };
  target.addEventListener("pointermove", move);
  target.addEventListener("pointerup", end);
  target.addEventListener("pointercancel", end);
}

let pressed = 0,
  pending = null;

/** Keys change the number at once and write it when they rest. */
export function press(event, number, step, asked) {
  const by = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
  if (!by) return;
  event.preventDefault();
  clearTimeout(pressed);
  const from = pending && pending.name === event.currentTarget.dataset.name ? pending.number : number;
  pending = { name: event.currentTarget.dataset.name, number: rounded(from + by * step, step) };
  const last = asked(pending.number);
  preview(last);
  pressed = setTimeout(() => {
    pending = null;
    stopPreview();
    change("set", last);
  }, 400);
}


/** A handle where it is now: the numbers of the file may be newer than it. */
function present(handle) {
  const value = (model.values || []).find(([key]) => key === `dimension.${handle.name}`), number = value ? Number.parseFloat(value[1]) : NaN;
  const moved = Number.isFinite(number) ? (number - handle.number) * handle.unit_mm : 0;
  return { ...handle, number: handle.number + moved / handle.unit_mm, r_mm: handle.r_mm + moved * handle.dr, z_mm: handle.z_mm + moved * handle.dz };
}

/** The name of a handle, seen where it is pointed at or has the focus. */
export const nameOf = (label, x, y, before) => drawn("text", { class: "handle-name", x, y, "text-anchor": before ? "end" : "start" }, label);

function dimensionHandle(drawing, handle) {
  const [x0, y0] = drawing.place(handle.r_mm, handle.z_mm), size = Math.hypot(handle.dr, handle.dz);
  const way = [handle.dr / size, (-drawing.up * handle.dz) / size], from = 9, to = 30;
  const at = (d) => [x0 + way[0] * d, y0 + way[1] * d].map((x) => x.toFixed(1)).join(" ");
  const set = (number) => ({ set: [`dimension.${handle.name}=${number} ${handle.unit}`] });
  const label = `${handle.name}: ${shown(handle.number, 4)} ${handle.unit}`;
  const begin = (event) => {
    const start = drawing.back(event);
    followPointer(drawing, event, (now) => {
      const place = drawing.back(now);
      const along = ((place[0] - start[0]) * handle.dr + (place[1] - start[1]) * handle.dz) / (size * size);
      const number = rounded(handle.number + along / handle.unit_mm, (now.shiftKey ? fine : coarse) / handle.unit_mm);
      return number === handle.number ? null : set(number);
    });
  };
  const tip = [x0 + way[0] * to, y0 + way[1] * to], across = [-way[1], way[0]];
  const head = [[0, 0], [-9, 5], [-9, -5]].map(([a, b]) => `${(tip[0] + a * way[0] + b * across[0]).toFixed(1)} ${(tip[1] + a * way[1] + b * across[1]).toFixed(1)}`).join("L");
  return drawn("g", { class: "handle", tabindex: 0, role: "slider", "aria-label": label, "aria-valuenow": handle.number, "data-name": handle.name, onpointerdown: begin,
      onkeydown: (event) => press(event, handle.number, (event.shiftKey ? fine : coarse) / handle.unit_mm, set) },
    drawn("title", {}, `${label}. ${word("handleHint")}`), drawn("circle", { cx: x0, cy: y0, r: 2.5 }), drawn("path", { class: "grab", d: `M${at(0)}L${at(to)}` }),
    drawn("path", { d: `M${at(from)}L${at(to - 6)}` }), drawn("path", { class: "tip", d: `M${head}Z` }), nameOf(label, tip[0] + (way[0] < 0 ? -6 : 6), tip[1] - 5, way[0] < 0));
}

function cornerHandle(drawing, corner, number) {
  const [x, y] = drawing.place(corner.r_mm, corner.z_mm), size = 3.5;
  const asked = (r, z) => ({ corner: { number, r_mm: r, z_mm: z } });
  const label = `${corner.tool} ${number}: (${shown(corner.r_mm)}, ${shown(corner.z_mm)}) mm`;
  const begin = (event) => {
    const start = drawing.back(event);
    followPointer(drawing, event, (now) => {
      const place = drawing.back(now), step = now.shiftKey ? fine : coarse;
      const r = rounded(Math.max(0, corner.r_mm + place[0] - start[0]), step), z = rounded(corner.z_mm + place[1] - start[1], step);
      return Math.hypot(r - corner.r_mm, z - corner.z_mm) < step / 2 ? null : asked(r, z);
    });
  };
  const keys = (event) => {
    const across = event.key === "ArrowLeft" || event.key === "ArrowRight", step = event.shiftKey ? fine : coarse;
    press(event, across ? corner.r_mm : corner.z_mm, step, (value) => (across ? asked(Math.max(0, value), corner.z_mm) : asked(corner.r_mm, value)));
  };
  return drawn("g", { class: "handle corner", tabindex: 0, role: "slider", "aria-label": label, "aria-valuenow": corner.r_mm, "data-name": `${corner.tool}-${number}`, onpointerdown: begin, onkeydown: keys },
    drawn("title", {}, `${label}. ${word("handleHint")}`), drawn("rect", { class: "grab", x: x - 8, y: y - 8, width: 16, height: 16 }),
    drawn("rect", { x: x - size, y: y - size, width: 2 * size, height: 2 * size }), nameOf(label, x + 8, y - 6, false));
}

export const dimensionHandles = (drawing, active) =>
  model.handles.handles.filter((one) => active.includes(one.tool)).map((one) => dimensionHandle(drawing, present(one)));

export const cornerHandles = (drawing, active) =>
  (model.handles.version === model.version ? model.handles.corners : []).map((one, i) => (active.includes(one.tool) ? cornerHandle(drawing, one, i) : null)).filter((one) => one);
