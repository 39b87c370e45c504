// SPDX-License-Identifier: GPL-3.0-or-later
// The values of the case as fields; what the reader refuses stands beside the field that it is about.

import { element } from "./dom.js";
import { change, model, on, preview, stopPreview } from "./model.js";
import { word } from "./words.js";

const groupNames = { dimension: "dimensions", glass: "glass", stage: "stage", tool: "tool", interface: "interface", air: "air", inner_air: "air", probe: "probe" };
const order = ["dimensions", "glass", "stage", "tool", "interface", "air", "probe", "others", "unused"];
const isEntry = /^(stage|tool|interface|probe)\.\d+/;
const hidden = /(^case|^geometry|\.path(\.\d+)*|\.tools\.\d+|^(stage|tool|probe)\.\d+\.name|\.boundary\.\d+\.(name|condition))$/;

const plain = (key) => key.split(".").filter((one) => !/^\d+$/.test(one)).join(".");

/** The key of the value that a problem of the reader is about, or of the first in the table that it is about. */
function wrongKey() {
  const problem = model.check && model.check.problem;
  if (!problem || !model.values) return "";
  const inLine = model.values.filter(([key, , line]) => line === problem.line && !hidden.test(key)), is = (name) => name === problem.key;
  const found = inLine.find(([key]) => is(plain(key))) || inLine.find(([key]) => plain(key).startsWith(`${problem.key}.`));
  return found ? found[0] : "";
}

/** The groups of the values: of each a title, and its fields as [key, label, value, line, whether it is a number, with a unit or without]. */
export function groups(values) {
  const found = new Map(), names = Object.fromEntries(values.map(([key, value]) => [key, value]));
  for (const [key, value, line, unit] of [...values].sort((a, b) => a[2] - b[2])) {
    if (hidden.test(key)) continue;
    const entry = key.match(isEntry), group = model.unused.includes(key) ? "unused" : groupNames[key.split(".")[0]] || "others", id = entry ? entry[0] : group;
    const about = entry ? names[`${entry[0]}.name`] || values.filter(([one]) => one.startsWith(`${entry[0]}.tools.`)).map((one) => one[1]).join(", ") : "";
    if (!found.has(id)) found.set(id, { group, title: about ? `${word(group)} ${about}` : word(group), fields: [] });
    let label = entry ? key.slice(entry[0].length + 1) : group === "others" || group === "air" ? key : key.slice(key.indexOf(".") + 1);
    label = label.replace(/boundary\.(\d+)\.condition/, (_, i) => names[`${entry && entry[0]}.boundary.${i}.name`] || i);
    found.get(id).fields.push([key, label, value, line, unit !== undefined || /^-?[\d.e+-]+$/i.test(value)]);
  }
  return [...found.entries()].sort((a, b) => order.indexOf(a[1].group) - order.indexOf(b[1].group));
}

/** How far a slider goes to either side: half of a value, and so many kelvins, or degrees, of what has no zero of its own. Assumed: what is tried in one go. */
const share = 0.5, degrees = 50;
/** Of that way, what is nearer than a place of the pointer to where the slider began. */
const pixel = 0.02;

let slides = false; // the fields stay as they are meanwhile

/** A slider of a number, which shows what would be and writes it when it is let go; null where there is nothing to slide. */
function sliderOf(key, label, value, input) {
  const [number, rest] = [Number.parseFloat(value), value.replace(/^[-\d.e+]+/i, "")], reach = rest.trim() === "degC" ? degrees : share * Math.abs(number);
  if (!reach) return null;
  const places = Math.max(0, 2 - Math.floor(Math.log10(reach)));
  const asked = () => ({ set: [`${key}=${input.value}`] });
  const slider = element("input", { type: "range", min: number - reach, max: number + reach, step: "any", value: number, tabindex: -1, disabled: model.bundled, "aria-label": label, "data-key": key });
  const end = () => ((slides = false), stopPreview());
  slider.addEventListener("input", () => {
    slides = true;
    const isBack = Math.abs(slider.valueAsNumber - number) < pixel * reach;
    input.value = isBack ? value : Number(slider.valueAsNumber.toFixed(places)) + rest;
    preview(asked());
  });
  const letGo = () => slides && (end(), input.value === value ? ((slider.value = number), preview({})) : change("set", asked()));
  slider.addEventListener("change", letGo);
  slider.addEventListener("pointerup", () => setTimeout(letGo)); // where it was there is no change event
  return slider;
}

function fieldOf([key, label, value, line, isNumber], wrongOne, goTo) {
  const id = `value-${key}`, problem = model.check && model.check.problem, wrong = key === wrongOne;
  const input = element("input", { id, value, spellcheck: "false", disabled: model.bundled, "aria-invalid": wrong ? "true" : null, "aria-describedby": wrong ? `${id}-wrong` : null });
  const send = () => input.value !== value && change("set", { set: [`${key}=${input.value}`] }).then((done) => !done && (input.value = value));
  input.addEventListener("change", send);
  input.addEventListener("keydown", (event) => (event.key === "Enter" ? send() : event.key === "Escape" && (input.value = value))); // no change event follows what was put back
  const slider = isNumber ? sliderOf(key, label, value, input) : null;
  return element("div", { class: slider ? "field slides" : "field" }, element("label", { for: id, title: key }, label.replace(/_/g, " ")), input, slider,
    wrong ? element("p", { class: "bad", id: `${id}-wrong` }, problem.sentence, " ", element("button", { class: "link", onclick: () => goTo(problem) }, `${word("line")} ${line}`)) : null);
}

export function valueFields(goTo) {
  const panel = element("div", { class: "fields" }), open = new Map();
  const show = () => {
    if (slides) return;
    const focused = panel.contains(document.activeElement) && document.activeElement.matches("input:not([type=range])") ? document.activeElement : null;
    const selection = focused && [focused.selectionStart, focused.selectionEnd];
    if (!model.values) return panel.replaceChildren(element("p", { class: "bad" }, word("brokenText")));
    const top = panel.scrollTop, wrongOne = wrongKey();
    panel.replaceChildren(...groups(model.values).map(([id, one]) => {
      const wrong = one.fields.some(([key]) => key === wrongOne);
      const details = element("details", { open: wrong || (open.get(id) ?? ["dimensions", "glass", "stage"].includes(one.group)) },
        element("summary", {}, one.title), ...one.fields.map((field) => fieldOf(field, wrongOne, goTo)));
      details.addEventListener("toggle", () => open.set(id, details.open));
      return details;
    }));
    panel.scrollTop = top;
    const again = focused && document.getElementById(focused.id);
    if (!again) return;
    again.focus({ preventScroll: true });
    const isAll = selection[0] === 0 && selection[1] === focused.value.length;
    if (focused.value !== focused.defaultValue) again.value = focused.value; // it is being typed in
    again.setSelectionRange(...(isAll ? [0, again.value.length] : selection)); // what is typed next goes where it was to go
  };
  on("case", show);
  let before = "";
  on("check", () => {
    const now = JSON.stringify((model.check && model.check.problem) || null);
    if (now !== before) show();
    before = now;
  });
  return panel;
}
