// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles with values at their corners as pixels: each pixel keeps its body and its value, for colours and for reading.

class Raster {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.values = new Float32Array(width * height);
    this.bodies = new Uint8Array(width * height);
  }

  /** Fills the pixels whose centres lie inside; the value is linear between the corners. */
  triangle(x0, y0, v0, x1, y1, v1, x2, y2, v2, body) {
    const area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
    if (!(Math.abs(area) > 1e-9)) return;
    const slopeX = ((v1 - v0) * (y2 - y0) - (v2 - v0) * (y1 - y0)) / area;
    const slopeY = ((v2 - v0) * (x1 - x0) - (v1 - v0) * (x2 - x0)) / area;
    const first = Math.max(0, Math.ceil(Math.min(y0, y1, y2) - 0.5));
    const last = Math.min(this.height - 1, Math.ceil(Math.max(y0, y1, y2) - 0.5) - 1);
    for (let row = first; row <= last; ++row) {
      const y = row + 0.5;
      let left = Infinity,
        right = -Infinity;
      const cross = (xa, ya, xb, yb) => {
        if (ya <= y === yb <= y) return;
        const x = xa + ((y - ya) / (yb - ya)) * (xb - xa);
        ((left = Math.min(left, x)), (right = Math.max(right, x)));
      };
      (cross(x0, y0, x1, y1), cross(x1, y1, x2, y2), cross(x2, y2, x0, y0));
      const from = Math.max(0, Math.ceil(left - 0.5)),
        to = Math.min(this.width, Math.ceil(right - 0.5));
      let value = v0 + slopeX * (from + 0.5 - x0) + slopeY * (y - y0),
        at = row * this.width + from;
      for (let i = from; i < to; ++i, ++at, value += slopeX) ((this.values[at] = value), (this.bodies[at] = body));
    }
  }

  /** A body of quadratic triangles, each as four; `x` and `y` are pixels of its nodes. */
  body(cells, x, y, values, number) {
    for (let c = 0; c < cells.length; c += 6)
      for (const [i, j, k] of subTriangles) {
        const a = cells[c + i],
          b = cells[c + j],
          d = cells[c + k];
        this.triangle(
          x[a],
          y[a],
          values ? values[a] : NaN,
          x[b],
          y[b],
          values ? values[b] : NaN,
          x[d],
          y[d],
          values ? values[d] : NaN,
          number,
        );
      }
  }

  /** The pixels as an image: a colour table and a range for each body, or a plain colour. */
  image(paints) {
    const image = new ImageData(this.width, this.height),
      pixels = new Uint32Array(image.data.buffer);
    for (let at = 0; at < pixels.length; ++at) {
      const body = this.bodies[at];
      if (!body) continue;
      const { colours, low, high, plain } = paints[body],
        value = this.values[at];
      pixels[at] =
        value === value && colours
          ? colours[Math.max(0, Math.min(255, Math.round((255 * (value - low)) / (high - low))))]
          : plain;
    }
    return image;
  }
}

const subTriangles = [
  [0, 3, 5],
  [3, 1, 4],
  [5, 4, 2],
  [3, 4, 5],
];

/** Edges of a mesh as first, last, mid-side node; those of one cell only are its outline. */
function edgesOf(mesh) {
  if (mesh.edges) return mesh.edges;
  const seen = new Map();
  for (let c = 0; c < mesh.cells.length; c += 6)
    for (let k = 0; k < 3; ++k) {
      const mid = mesh.cells[c + 3 + k],
        edge = seen.get(mid);
      if (edge) edge.shared = true;
      else seen.set(mid, { nodes: [mesh.cells[c + k], mesh.cells[c + ((k + 1) % 3)], mid], shared: false });
    }
  const edges = [...seen.values()];
  return (mesh.edges = {
    all: edges.map((edge) => edge.nodes),
    outline: edges.filter((edge) => !edge.shared).map((edge) => edge.nodes),
  });
}
