// SPDX-License-Identifier: GPL-3.0-or-later
// The start: a new container, bundled cases, cases and results of the folder.

import { ask, tryAsk } from "./api.js";
import { drawn, element } from "./dom.js";
import { word } from "./words.js";

const open = (name) => (location.hash = `case=${encodeURIComponent(name)}`);

const free = (name, taken) => {
  for (let i = 1; ; ++i) {
    const tried = i === 1 ? name : `${name}_${i}`;
    if (!taken.some((one) => one === `${tried}/case.toml`)) return tried;
  }
};

function field(label, properties) {
  const input = element(properties.choices ? "select" : "input", { ...properties, choices: null });
  for (const choice of properties.choices || []) input.append(element("option", { value: choice }, word(choice)));
  return [element("label", {}, element("span", {}, label), input), input];
}

/** Makes a case and opens it. */
async function make(asked, button) {
  button.disabled = true;
  const made = await tryAsk("new", asked);
  button.disabled = false;
  if (made) open(made.case);
}

const ordinary = {
  nnpb: { weight: "180 g", capacity: "330 ml", height: "220 mm", finish: "26 mm" },
  press_and_blow: { weight: "220 g", capacity: "430 ml", height: "130 mm", finish: "66 mm" },
  blow_and_blow: { weight: "450 g", capacity: "770 ml", height: "300 mm", finish: "29 mm" },
  pressed: { weight: "230 g", capacity: "250 ml", height: "100 mm", finish: "73 mm" },
  tubing: { weight: "1.3 g", capacity: "2.7 ml", height: "44 mm", finish: "5.7 mm" },
};

function newForm(taken) {
  const [processLabel, process] = field(word("process"), { name: "process", choices: Object.keys(ordinary) });
  const inputs = { weight: "weight", capacity: "capacityToRim", height: "height", finish: "finish" };
  const fields = Object.entries(inputs).map(([name, label]) => field(word(label), { name, required: true, size: 8 }));
  const [nameLabel, name] = field(word("name"), {
    name: "name", required: true, pattern: "[A-Za-z0-9_\\-]{1,100}", value: free("my_bottle", taken),
  });
  const fill = () => fields.forEach(([, input]) => !input.dataset.own && (input.value = ordinary[process.value][input.name]));
  fields.forEach(([, input]) => input.addEventListener("input", () => (input.dataset.own = "true"))); // what was written stays
  process.addEventListener("change", fill);
  fill();
  const button = element("button", { class: "main" }, word("create"));
  const sent = (event) => {
    event.preventDefault();
    make(Object.fromEntries([process, name, ...fields.map((one) => one[1])].map((one) => [one.name, one.value])), button);
  };
  return element(
    "section", { id: "new" },
    element("h2", {}, word("newCase")), element("p", { class: "soft" }, word("newHint")),
    element("form", { onsubmit: sent }, processLabel, ...fields.map((one) => one[0]), nameLabel, button),
  );
}

function bundledCard(one, taken) {
  const [label, name] = field(word("copyName"), { value: free(`my_${one.name}`, taken), pattern: "[A-Za-z0-9_\\-]{1,100}", required: true });
  const button = element("button", { class: "main" }, word("copy"));
  return element(
    "article", { class: "card", "data-case": one.name },
    one.picture ? element("img", { src: `bundled/${one.name}.png`, alt: "", loading: "lazy" }) : element("div", { class: "no-picture" }),
    element("h3", {}, one.name), element("p", { class: "soft" }, one.title),
    element("form", { onsubmit: (event) => (event.preventDefault(), make({ name: name.value, like: one.name }, button)) },
      label, button, element("button", { type: "button", onclick: () => open(`bundled:${one.name}`) }, word("look"))),
  );
}

/** The finished glass as a small picture. */
export function thumbnail(outlines) {
  const points = outlines.flat(), r = Math.max(...points.filter((_, i) => i % 2 === 0)), z = points.filter((_, i) => i % 2);
  const low = Math.min(...z), high = Math.max(...z);
  const path = (side) => outlines.map((line) => line.map((x, i) => (i % 2 ? x : `${i ? "L" : "M"}${side * x} `)).join(" ")).join(" ");
  return drawn("svg", { viewBox: `${-1.1 * r} ${low} ${2.2 * r} ${high - low}`, class: "thumb", "aria-hidden": "true" },
    drawn("path", { d: `${path(1)} ${path(-1)}`, "vector-effect": "non-scaling-stroke" }));
}

function resultLine(name) {
  const picture = element("span", { class: "thumb-place" });
  ask("outline", { results: name }).then((answer) => answer.outlines_mm && picture.append(thumbnail(answer.outlines_mm)), () => null);
  return element("li", {}, element("a", { href: `result/${encodeURIComponent(name)}/`, target: "_blank", rel: "noopener" }, picture, name));
}

/** Another folder has a workbench of its own. */
async function openFolder(folder) {
  const answer = await tryAsk("open", { folder });
  if (answer) location.href = answer.address;
}

export async function startScreen(main) {
  const start = await ask("start"), others = start.recent.filter((folder) => folder !== start.folder);
  const list = (items, line) => (items.length ? element("ul", { class: "list" }, ...items.map(line)) : element("p", { class: "soft" }, word("none")));
  main.className = "start";
  main.replaceChildren(
    newForm(start.cases),
    element("section", { id: "folder" },
      element("h2", {}, word("yourCases")), element("p", { class: "soft" }, start.folder),
      list(start.cases, (name) => element("li", {}, element("a", { href: `#case=${encodeURIComponent(name)}` }, name))),
      element("h2", {}, word("yourResults")), list(start.results.slice(0, 30), resultLine),
      ...(others.length ? [element("h2", {}, word("recentFolders")), list(others, (folder) => element("li", {}, element("button", { class: "link", onclick: () => openFolder(folder) }, folder)))] : [])),
    element("section", { id: "bundled" }, element("h2", {}, word("bundled")),
      element("div", { class: "cards" }, ...start.bundled.map((one) => bundledCard(one, start.cases)))),
  );
}
