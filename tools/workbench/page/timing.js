// SPDX-License-Identifier: GPL-3.0-or-later
// The timing: stages as bars whose ends are dragged, tools that are in use, and what acts over time as curves whose points are dragged.

import { drawn, element, shown } from "./dom.js";
import { followPointer, nameOf, press } from "./handles.js";
import { change, model, on } from "./model.js";
import { word } from "./words.js";

const left = 130, right = 14, bar = 24, line = 15, plot = 62, gap = 12; // px
const curveKey = /^stage\.(\d+)\.((?:pressure\.[^.]+|motion\.[^.]+|cooling\.[^.]+(?:\.[^.]+)?|air|inner_air)(?:\.(?:force|speed_limit|offset|h|temperature|ambient))?)(?:\.(\d+)\.([01]))?$/;

/** A number with its unit as it stands in the file, and the size of the unit in SI; null for what is none. */
function quantity(key) {
  const found = (model.values || []).find(([one]) => one === key), parts = found && found[3] !== undefined && found[1].match(/^\s*(\S+)\s*(.*)$/);
  return parts ? { key, number: Number(parts[1]), unit: parts[2], size: found[3] } : null;
}
/** The same, or the named dimension that alone stands there. */
function lengthOfTime(key) {
  const found = (model.values || []).find(([one]) => one === key);
  return found && (quantity(key) || quantity(`dimension.${found[1].trim()}`));
}
const rounded = (value, step) => Number((Math.round(value / step) * step).toPrecision(6));
/** A power of ten some hundred times smaller than a range. */
const stepFor = (range) => 10 ** Math.floor(Math.log10(range / 60 || 1));

/** What is set so that a stage ends at a time, s since its start; null where the file says it otherwise. */
function ending(i, stage) {
  const duration = lengthOfTime(`stage.${i}.duration`), event = stage.until && quantity(`timing.event.${stage.until}`);
  if (event) {
    const degrees = 360 / model.check.cycle_s, about = (x) => ((x % 360) + 360) % 360;
    return { name: event.key, text: `${event.number} ${event.unit}`, step: 0.5 / degrees, set: (s, step) => [`${event.key}=${about(rounded(event.number + (s - stage.duration_s) * degrees, step * degrees))} ${event.unit}`] };
  }
  if (!duration) return null;
  return { name: duration.key, text: `${duration.number} ${duration.unit}`, step: 0.01, set: (s, step) => [`${duration.key}=${rounded(Math.max(s, step) / duration.size, step / duration.size)} ${duration.unit}`] };
}

/** Writes the points of a curve anew, one value where one is left: a point more behind those up to a time, s, or one taken away. */
function write(key, list, at, taken) {
  const text = (one, s) => [`${one.time ? `${one.time.number} ${one.time.unit}` : `${s} s`}`, `${one.value.number} ${one.value.unit}`], points = list.map((one) => text(one, 0));
  const behind = list.filter((one) => !one.time || one.time.number * one.time.size < at).length, like = list[Math.max(0, behind - 1)];
  if (taken === undefined) points.splice(behind, 0, [`${rounded(at, 0.001)} s`, text(like, 0)[1]]);
  else points.splice(taken, 1);
  const value = points.length > 1 ? `[${points.map((one) => `["${one.join('", "')}"]`).join(", ")}]` : `"${points[0][1]}"`;
  change("set", { set: [`${key}=${value}`] });
}

/** The curves by what they are of: of each stage that has one its points [time in s, number], with their quantities. */
function curves() {
  const found = new Map();
  for (const [key] of model.values || []) {
    const parts = key.match(curveKey), value = parts && quantity(key);
    if (!value) continue;
    const [, stage, of, point, column] = parts;
    if (!found.has(of)) found.set(of, new Map());
    const points = found.get(of);
    if (!points.has(stage)) points.set(stage, []);
    const list = points.get(stage);
    if (point === undefined) list.push({ value });
    else (list[point] ||= {})[column === "0" ? "time" : "value"] = value;
  }
  const isWhole = (list) => list.every((one) => one && one.value && one.value.unit === list[0].value.unit && (list.length === 1 || one.time));
  for (const [of, stages] of found) {
    for (const [stage, list] of stages) if (!isWhole(list)) stages.delete(stage);
    if (!stages.size) found.delete(of);
  }
  return found;
}

export function timingPart() {
  const svg = drawn("svg", { class: "timing", role: "group", "aria-label": word("timing") });
  const panel = element("div", { class: "timing-tab" }, element("p", { class: "soft" }, word("timingHint")), svg);
  const chart = { svg, held: false, moved: null }; // what is dragged stands where the pointer is
  const at = (s) => left + s * chart.scale;
  const time = (event) => (event.clientX - svg.getBoundingClientRect().left - left) / chart.scale;

  function endHandle(i, stage, y) {
    const end = ending(i, stage);
    if (!end || model.bundled) return null;
    const x = at(stage.end), label = `${stage.name}: ${end.name.replace(/^.*\./, "")} ${end.text}`;
    const set = (s, step) => ({ set: end.set(s, step) });
    const begin = (event) => followPointer(chart, event, (now) => {
      const s = stage.duration_s + time(now) - time(event);
      return Math.abs(s - stage.duration_s) < end.step / 2 ? null : set(s, now.shiftKey ? end.step / 10 : end.step);
    });
    const keys = (event) => press(event, stage.duration_s, event.shiftKey ? end.step / 10 : end.step, (s) => set(s, event.shiftKey ? end.step / 10 : end.step));
    return drawn("g", { class: "handle", tabindex: 0, role: "slider", "aria-label": label, "aria-valuenow": shown(stage.duration_s, 4), "data-name": `stage.${i}`, onpointerdown: begin, onkeydown: keys },
      drawn("title", {}, `${label}. ${word("handleHint")}`), drawn("rect", { class: "grab", x: x - 7, y, width: 14, height: bar }), drawn("rect", { x: x - 1.5, y: y + 3, width: 3, height: bar - 6 }), nameOf(label, x - 4, y + bar + 10, x > chart.width / 2));
  }

  function pointHandle(key, name, stage, list, index, place, steps) {
    const one = list[index], { value, time: when } = one, [x, y] = place.at(one), s0 = when ? when.number * when.size : 0;
    const label = `${name}, ${stage.name}: ${when ? `${when.number} ${when.unit}, ` : ""}${value.number} ${value.unit}`;
    const texts = (s, v, fine) => ({ set: [when && `${when.key}=${rounded(Math.max(0, s) / when.size, (fine ? 0.001 : 0.01) / when.size)} ${when.unit}`, `${value.key}=${rounded(v, fine ? steps / 10 : steps)} ${value.unit}`].filter((text) => text) });
    const begin = (event) => followPointer(chart, event, (now) => {
      const s = s0 + time(now) - time(event), v = value.number + place.value(now) - place.value(event);
      chart.moved = { key: value.key, x: when ? Math.max(at(stage.begin), at(stage.begin + s)) : x, v };
      return texts(s, v, now.shiftKey);
    }, () => (chart.moved = null));
    const keys = (event) => {
      if (event.key === "Insert") return write(key, list, when && list[index + 1] ? (s0 + list[index + 1].time.number * list[index + 1].time.size) / 2 : (s0 + stage.duration_s) / 2);
      if (event.key === "Delete") return list.length > 1 && write(key, list, 0, index);
      const across = event.key === "ArrowLeft" || event.key === "ArrowRight";
      if (across && !when) return;
      press(event, across ? s0 : value.number, across ? (event.shiftKey ? 0.001 : 0.01) : event.shiftKey ? steps / 10 : steps, (number) => (across ? texts(number, value.number, event.shiftKey) : texts(s0, number, event.shiftKey)));
    };
    return drawn("g", { class: "handle", tabindex: 0, role: "slider", "aria-label": label, "aria-valuenow": value.number, "data-name": value.key, onpointerdown: begin, onkeydown: keys },
      drawn("title", {}, `${label}. ${word("handleHint")}`), drawn("circle", { class: "grab", cx: x, cy: y, r: 9 }), drawn("circle", { cx: x, cy: y, r: 3.5 }), nameOf(`${when ? `${when.number} ${when.unit}, ` : ""}${value.number} ${value.unit}`, x + (x > chart.width / 2 ? -8 : 8), y - 6, x > chart.width / 2));
  }

  function curveRow(of, stages, all, top) {
    const lists = [...stages.entries()].filter(([i]) => all[i]), numbers = lists.flatMap(([, list]) => list.map((one) => one.value.number));
    if (!lists.length) return [];
    if (!chart.held || !chart.ranges[of]) chart.ranges[of] = [Math.min(0, ...numbers), Math.max(...numbers) + 0.15 * Math.max(Math.max(...numbers) - Math.min(0, ...numbers), 1e-9)];
    const [low, high] = chart.ranges[of], height = (v) => top + plot - ((v - low) / (high - low)) * plot;
    const words = of.replace(/_/g, " ").split("."), name = words.join(" "), unit = lists[0][1][0].value.unit, steps = stepFor(high - low), shapes = [];
    for (const [i, list] of lists) {
      const stage = all[i];
      const place = {
        at: (one) => (chart.moved && chart.moved.key === one.value.key ? [chart.moved.x, height(chart.moved.v)] : [one.time ? at(stage.begin + one.time.number * one.time.size) : (at(stage.begin) + at(stage.end)) / 2, height(one.value.number)]),
        value: (event) => low + ((top + plot - (event.clientY - svg.getBoundingClientRect().top)) / plot) * (high - low),
      };
      const points = list.map((one) => place.at(one)), inside = (x) => Math.min(at(stage.end), Math.max(at(stage.begin), x));
      const way = [[at(stage.begin), points[0][1]], ...points, [Math.max(at(stage.end), points.at(-1)[0]), points.at(-1)[1]]];
      const key = `stage.${i}.${of}`, d = way.map(([x, y], k) => `${k ? "L" : "M"}${(list.length > 1 ? x : inside(x)).toFixed(1)} ${y.toFixed(1)}`).join("");
      shapes.push(drawn("path", { class: "curve", d }));
      if (!model.bundled) shapes.push(drawn("path", { class: "near-curve", d, ondblclick: (event) => write(key, list, time(event) - stage.begin) }), ...list.map((_, k) => pointHandle(key, name, stage, list, k, place, steps)));
    }
    const label = (y, text, soft) => drawn("text", { x: left - 8, y, "text-anchor": "end", class: soft ? "soft" : null }, text);
    return [drawn("path", { class: "base", d: `M${left} ${height(0).toFixed(1)}H${at(all.at(-1).end).toFixed(1)}` }), label(top + 14, words.slice(0, 2).join(" ")), label(top + 30, [words.slice(2).join(" "), unit].filter((one) => one).join(", "), true), ...shapes];
  }

  function draw() {
    const check = model.check && model.check.stages ? model.check : null, width = svg.clientWidth;
    if (!check || !width) return;
    let sum = 0;
    const all = check.stages.map((stage) => ({ ...stage, begin: sum, end: (sum += stage.duration_s) })), own = curves();
    if (!chart.held) Object.assign(chart, { width, scale: (width - left - right) / (sum || 1), ranges: {} });
    const focused = document.activeElement && svg.contains(document.activeElement) ? document.activeElement.dataset.name : "", shapes = [], step = 10 ** Math.floor(Math.log10(sum)) / (sum / 10 ** Math.floor(Math.log10(sum)) > 4 ? 1 : 2);
    for (let s = 0; s <= sum * 1.0001; s += step) shapes.push(drawn("path", { class: "base", d: `M${at(s)} 16v5` }), drawn("text", { x: at(s), y: 12, "text-anchor": "middle" }, `${shown(s, 3)} s`));
    let y = 22;
    all.forEach((stage, i) => {
      const wide = at(stage.end) - at(stage.begin);
      shapes.push(drawn("rect", { class: `stage tool${i % 6}`, x: at(stage.begin), y, width: Math.max(0, wide), height: bar }, drawn("title", {}, `${stage.name}: ${shown(stage.begin, 3)} … ${shown(stage.end, 3)} s`)),
        ...(wide > 8 * stage.name.length ? [drawn("text", { class: "inside", x: at(stage.begin) + wide / 2, y: y + 16, "text-anchor": "middle" }, stage.name)] : []));
    });
    const handles = all.map((stage, i) => endHandle(i, stage, y));
    y += bar + gap;
    for (const tool of [...new Set(all.flatMap((stage) => stage.tools))]) {
      shapes.push(drawn("text", { x: left - 8, y: y + 10, "text-anchor": "end" }, tool), ...all.filter((stage) => stage.tools.includes(tool)).map((stage) => drawn("rect", { class: "used", x: at(stage.begin), y: y + 2, width: at(stage.end) - at(stage.begin), height: line - 6 })));
      y += line;
    }
    y += gap;
    for (const [of, stages] of own) {
      const row = curveRow(of, stages, all, y);
      if (!row.length) continue;
      shapes.push(...row);
      y += plot + gap;
    }
    svg.setAttribute("height", y + gap);
    svg.replaceChildren(...shapes, ...handles.filter((one) => one));
    if (focused) [...svg.querySelectorAll("[tabindex]")].find((one) => one.dataset.name === focused)?.focus({ preventScroll: true });
  }
  for (const event of ["case", "check"]) on(event, draw);
  new ResizeObserver(draw).observe(panel);
  return panel;
}
