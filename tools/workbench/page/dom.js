// SPDX-License-Identifier: GPL-3.0-or-later
// Elements. Every text enters the page as a text node, never as markup: names come from cases and folders.

function filled(made, properties, children) {
  for (const [name, value] of Object.entries(properties))
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value != null) made.setAttribute(name, value);
  made.append(...children.flat().filter((child) => child != null));
  return made;
}

export const element = (tag, properties = {}, ...children) => filled(document.createElement(tag), properties, children);

export const drawn = (tag, properties = {}, ...children) =>
  filled(document.createElementNS("http://www.w3.org/2000/svg", tag), properties, children);

/** A number with so many places, without zeros at its end. */
export const shown = (value, places = 2) => (Number.isFinite(value) ? String(Number(value.toFixed(places))) : "–");

/** A sentence above the page; empty takes it away. */
export function say(sentence, kind = "bad") {
  const line = document.getElementById("said");
  line.textContent = sentence;
  line.className = kind;
  line.hidden = !sentence;
}

/** What the browser keeps for the next time: sets it where a value is given, null takes it away; null where it keeps nothing. */
export function kept(name, value) {
  try {
    if (value === null) localStorage.removeItem(name);
    else if (value !== undefined) localStorage.setItem(name, value);
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}
