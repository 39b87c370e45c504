// SPDX-License-Identifier: GPL-3.0-or-later
// Elements and figures. Every text enters the page as a text node, never as markup: names come from cases.

function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties))
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name === "style") Object.assign(made.style, value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value != null) made.setAttribute(name, value);
  made.append(...children.filter((child) => child != null));
  return made;
}

function drawn(tag, properties = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(properties)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/** A number with so many digits as are worth reading. */
function figure(value, digits = 4) {
  if (typeof value !== "number" || !Number.isFinite(value)) return "-";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(Math.max(0, digits - 2));
  return String(Number(value.toPrecision(digits)));
}

/** So many places behind the point, and no sign of a zero. */
function fixed(value, places) {
  const text = value.toFixed(places);
  return Number(text) === 0 ? (0).toFixed(places) : text;
}

/** A value with its error, rounded where the error begins. */
function withError(value, error) {
  if (typeof value !== "number" || !Number.isFinite(value)) return "-";
  if (!(error > 0)) return figure(value);
  const places = Math.min(8, Math.max(0, 1 - Math.floor(Math.log10(error))));
  return `${fixed(value, places)} ± ${error.toFixed(places)}`;
}

const words = (name) => name.replace(/_/g, " ");

/** A heading that may go on in the next line behind a point or underscore of a name. */
const heading = (text) => String(text).split(/(?<=[._])/).flatMap((piece, i) => (i ? [element("wbr"), piece] : [piece]));

/** A table; a cell is a text, an element, or {number: text}. */
function table(headings, rows) {
  const cell = (tag, content) => {
    const number = content !== null && typeof content === "object" && "number" in content;
    const shown = number ? content.number : content;
    return element(tag, { class: number ? "number" : null }, ...(tag === "th" ? heading(shown) : [shown]));
  };
  return element(
    "div",
    { class: "wide" },
    element(
      "table",
      { class: "figures" },
      element("thead", {}, element("tr", {}, ...headings.map((text) => cell("th", text)))),
      element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map((content) => cell("td", content))))),
    ),
  );
}

const number = (text) => ({ number: text });

/** A part of the report with its heading; nothing where it has no content. */
function part(id, title, ...children) {
  const content = children.filter((child) => child != null);
  return content.length ? element("section", { id }, element("h2", {}, title), ...content) : null;
}

const cssColour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
