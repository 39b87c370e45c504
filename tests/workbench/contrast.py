# SPDX-License-Identifier: GPL-3.0-or-later
"""The contrast of all texts that a page shows, after WCAG 2.1, 1.4.3 (AA)."""

FAINT = """
const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
canvas.canvas.width = canvas.canvas.height = 1;
const over = (below, colour, opacity = 1) => {  // a colour over another, as the browser mixes them
  canvas.globalAlpha = 1;
  canvas.fillStyle = `rgb(${below.join(" ")})`;
  canvas.fillRect(0, 0, 1, 1);
  canvas.globalAlpha = opacity;
  canvas.fillStyle = colour;
  canvas.fillRect(0, 0, 1, 1);
  return [...canvas.getImageData(0, 0, 1, 1).data].slice(0, 3);
};
const light = (colour) => colour.map((x) => x / 255).map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4)).reduce((sum, x, i) => sum + x * [0.2126, 0.7152, 0.0722][i], 0);
const contrast = (a, b) => (Math.max(light(a), light(b)) + 0.05) / (Math.min(light(a), light(b)) + 0.05);
const lineage = (one) => (one ? [...lineage(one.parentElement), one] : []);
const found = [], walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
let count = 0;
const judge = (one, text, part = null) => {
  const style = getComputedStyle(one, part), box = one.getBoundingClientRect();
  if (!text.trim() || !box.width || !box.height || style.visibility === "hidden" || one.closest(":disabled, title, script, option")) return;
  let below = [255, 255, 255], opacity = 1;
  for (const each of lineage(one)) {
    const own = getComputedStyle(each);
    opacity *= Number(own.opacity);
    below = over(below, own.backgroundColor, opacity);
  }
  const shown = over(below, one instanceof SVGElement ? style.fill : style.color, opacity), size = parseFloat(style.fontSize);
  const wanted = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700) ? 3 : 4.5, has = contrast(shown, below);
  ++count;
  if (has < wanted) found.push(`${has.toFixed(2)}: ${text.trim().slice(0, 40)} (${one.tagName} ${one.getAttribute("class") || ""})`);
};
while (walker.nextNode()) judge(walker.currentNode.parentElement, walker.currentNode.textContent);
for (const one of document.querySelectorAll("input, select, textarea")) judge(one, one.value || one.placeholder || "", one.value ? null : "::placeholder");
return [count, [...new Set(found)]];
"""


def faint_texts(page):
    """How many texts are shown, and those with too little contrast."""
    return page.script(FAINT)
