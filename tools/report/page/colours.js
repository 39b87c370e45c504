// SPDX-License-Identifier: GPL-3.0-or-later
// Colours: scales of matplotlib by some of their points (`wall`, from thin to thick, as in wall.svg), and series that can be told apart also by colour-blind eyes.

const scalePoints = {
  inferno: "000004 110a30 320a5e 57106e 781c6d 9a2865 bc3754 d84c3e ed6925 f98e09 fbb61a f4df53 fcffa4",
  cividis: "00224e 003170 2a3f6d 434e6c 575d6d 6a6c71 7d7c78 918b78 a59c74 bcae6c d2c060 e9d34e fee838",
  viridis: "440154 481f70 443983 3b528b 31688e 287c8e 21918c 20a486 35b779 5ec962 90d743 c8e020 fde725",
  wall: "a50026 f46d43 ffffbf 74add1 313695",
  magma: "000004 100b2d 2c115f 51127c 721f81 932b80 b73779 d8456c f1605d fc8961 feb078 fed799 fcfdbf",
};

const rgb = (hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16));

/** 256 colours as 32-bit words of an image. */
function colourTable(name) {
  const points = scalePoints[name].split(" ").map(rgb);
  const words = new Uint32Array(256);
  for (let i = 0; i < 256; ++i) {
    const place = (i / 255) * (points.length - 1),
      low = Math.min(Math.floor(place), points.length - 2),
      share = place - low;
    const mixed = points[low].map((value, k) => Math.round(value + share * (points[low + 1][k] - value)));
    words[i] = 0xff000000 | (mixed[2] << 16) | (mixed[1] << 8) | mixed[0];
  }
  return words;
}

const colourTables = Object.fromEntries(Object.keys(scalePoints).map((name) => [name, colourTable(name)]));
const gradient = (name) =>
  `linear-gradient(to right, ${scalePoints[name]
    .split(" ")
    .map((hex) => "#" + hex)
    .join(", ")})`;

function cssOfWord(word) {
  return `rgb(${word & 255}, ${(word >> 8) & 255}, ${(word >> 16) & 255})`;
}

const seriesLight = ["#0068b0", "#c24a00", "#00805c", "#a8407f", "#806000", "#4a5fc1", "#6b6b6b"];
const seriesDark = ["#5db2ee", "#ff9257", "#3ecba0", "#eda0cd", "#e0bd55", "#a3b1ff", "#bdbdbd"];
const isDark = () => document.documentElement.dataset.theme === "dark";
const seriesColour = (i) => (isDark() ? seriesDark : seriesLight)[i % seriesLight.length];
const dashes = [[], [8, 4], [2, 3], [10, 3, 2, 3], [5, 5], [14, 4]];
