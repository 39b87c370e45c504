// SPDX-License-Identifier: GPL-3.0-or-later
// How glass in space is seen: the camera, which copies of the sector are shown, pictures, and what is under a pixel.

/** The neighbour of a copy beyond its first or last plane of symmetry. */
function neighbourOf(film, copy, side) {
  const forwards = (side === lastPlane) !== (copy % 2 === 1);
  return (copy + (forwards ? 1 : film.copies - 1)) % film.copies;
}

/** Whether a side of a copy is seen: a plane of symmetry where the sector beyond it is cut away. */
const isSeen = (film, side, copy, copies) => side < firstPlane || !copies.includes(neighbourOf(film, copy, side));

/** What may be cut away: [share of the whole, its words]. */
const cutChoices = (film) =>
  [
    [0, "whole"],
    [0.25, "quarter cut out"],
    [0.5, "cut in half"],
  ].filter(([share]) => share === 0 || (film.copies > 1 && Number.isInteger(share * film.copies)));

/** The copies that are left where a share is cut away towards the viewer. */
function copiesLeft(film, share, azimuth) {
  const all = Array.from({ length: film.copies }, (_, copy) => copy),
    count = Math.round(share * film.copies);
  if (!count) return all;
  const viewer = film.up * (-Math.PI / 2 - azimuth);
  const off = (first) => Math.cos((first + count / 2) * film.sector - viewer);
  const first = all.reduce((best, one) => (off(one) > off(best) + 1e-9 ? one : best));
  return all.filter((copy) => (copy - first + film.copies) % film.copies >= count);
}

/** A camera without perspective: `turn` by rows, pixels for each mm, the middle in mm, the shift in pixels. */
class SpaceView {
  constructor(extent, { width, height, azimuth, tilt, zoom = 1, shift = [0, 0], pixels }) {
    const [, radius, bottom, top] = extent,
      [ca, sa, ct, st] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(tilt), Math.sin(tilt)];
    Object.assign(this, { width: Math.round(width), height: Math.round(height), shift });
    this.turn = [ca, -sa, 0, sa * st, ca * st, ct, -sa * ct, -ca * ct, st];
    this.middle = [0, 0, (bottom + top) / 2];
    this.reach = Math.hypot(radius, (top - bottom) / 2);
    const tall = (top - bottom) * ct + 2 * radius * Math.abs(st);
    this.pixels = pixels ?? 0.9 * zoom * Math.min(width / (2 * radius), height / tall);
  }

  /** Pixels to the right and down, and mm towards the viewer. */
  seen(x, y, z) {
    const [a, b, c] = [x - this.middle[0], y - this.middle[1], z - this.middle[2]],
      t = this.turn;
    return [
      this.width / 2 + this.pixels * (t[0] * a + t[1] * b + t[2] * c) + this.shift[0],
      this.height / 2 - this.pixels * (t[3] * a + t[4] * b + t[5] * c) + this.shift[1],
      t[6] * a + t[7] * b + t[8] * c,
    ];
  }
}

/** The nodes of a frame in one copy as they are seen: pixels and depth. */
function seenNodes(frame, view, copy) {
  const [a, b, c, d] = frame.film.copy(copy),
    seen = new Float32Array(3 * frame.mesh.nodes);
  for (let i = 0; i < frame.mesh.nodes; ++i) {
    const [x, y] = [frame.x[i], frame.y[i]];
    seen.set(view.seen(a * x + b * y, c * x + d * y, frame.z[i]), 3 * i);
  }
  return seen;
}

/** All triangles that are seen, as `visit(seen nodes, node, node, node, side, copy)`. */
function eachTriangle(frame, view, copies, visit) {
  for (const copy of copies) {
    const seen = seenNodes(frame, view, copy);
    frame.mesh.triangles.forEach((triangles, side) => {
      if (!isSeen(frame.film, side, copy, copies)) return;
      for (let i = 0; i < triangles.length; i += 3)
        visit(seen, triangles[i], triangles[i + 1], triangles[i + 2], side, copy);
    });
  }
}

/** The place under a pixel: {side, copy, nodes, shares}; nothing beside the glass. */
function pointedAt(frame, view, copies, px, py) {
  let best = null;
  eachTriangle(frame, view, copies, (seen, i, j, k, side, copy) => {
    const ax = seen[3 * i] - px,
      ay = seen[3 * i + 1] - py,
      bx = seen[3 * j] - px,
      by = seen[3 * j + 1] - py,
      cx = seen[3 * k] - px,
      cy = seen[3 * k + 1] - py;
    const u = bx * cy - cx * by,
      v = cx * ay - ax * cy,
      w = ax * by - bx * ay,
      area = u + v + w;
    if (!(Math.abs(area) > 1e-9) || Math.min(u / area, v / area, w / area) < -1e-6) return;
    const depth = (u * seen[3 * i + 2] + v * seen[3 * j + 2] + w * seen[3 * k + 2]) / area;
    if (!best || depth > best.depth)
      best = { depth, side, copy, nodes: [i, j, k], shares: [u / area, v / area, w / area] };
  });
  return best;
}

/** The words for a place: its side, values and where it is. */
function spaceReading(frame, found) {
  if (!found) return "";
  const mean = (list) => found.nodes.reduce((sum, node, k) => sum + found.shares[k] * list[node], 0),
    [a, b, c, d] = frame.film.copy(found.copy),
    [x, y] = [mean(frame.x), mean(frame.y)];
  return placeText(frame, {
    side: found.side,
    values: (name) => (frame.values(name) ? mean(frame.values(name)) : null),
    x: a * x + b * y,
    y: c * x + d * y,
    z: mean(frame.z),
  });
}

/** "outside, wall 2.43 mm, 643 °C (angle 45.0°, height 14.2 mm; x 26.5, y 26.5, z 80.7 mm)". */
function placeText(frame, { side, values, x, y, z }) {
  const { up } = frame.film,
    [wall, temperature, contact] = Object.keys(spaceFields).map(values);
  const told = [
    sideNames[side],
    wall == null ? null : `wall ${spaceFields.thickness.text(wall)}`,
    temperature == null ? null : spaceFields.temperature.text(temperature),
    contact > 0.005 ? spaceFields.contact.text(contact) : null,
  ].filter((text) => text);
  const at = [`x ${fixed(x, 1)}`, `y ${fixed(up * y, 1)}`, `z ${fixed(up * z, 1)} mm`].join(", ");
  return `${told.join(", ")} (angle ${fixed(frame.angleOf(x, y), 1)}°, height ${fixed(z - frame.bottom, 1)} mm; ${at})`;
}

/** Draws without a display card: triangles from far to near, each pixel with its value and its light. */
function paintPlainly(context, frame, view, options) {
  const { turn } = view,
    values = frame.values(options.field) || new Float32Array(frame.mesh.nodes),
    list = [];
  eachTriangle(frame, view, options.copies, (seen, i, j, k) =>
    list.push({ seen, nodes: [i, j, k], depth: seen[3 * i + 2] + seen[3 * j + 2] + seen[3 * k + 2] }),
  );
  list.sort((a, b) => a.depth - b.depth);
  const raster = new Raster(view.width, view.height),
    light = new Raster(view.width, view.height);
  for (const { seen, nodes } of list) {
    const [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = nodes.map((node) => seen.subarray(3 * node, 3 * node + 3));
    const scale = view.pixels,
      n = [
        (by - ay) * scale * (cz - az) - scale * (bz - az) * (cy - ay),
        scale * (bz - az) * (cx - ax) - (bx - ax) * scale * (cz - az),
        (bx - ax) * (cy - ay) - (by - ay) * (cx - ax),
      ],
      lit = 0.6 + (0.4 * Math.abs(-0.25 * n[0] - 0.45 * n[1] + n[2])) / (1.125 * (Math.hypot(...n) || 1));
    const corners = (of) => nodes.flatMap((node, c) => [[ax, bx, cx][c], [ay, by, cy][c], of(node)]);
    raster.triangle(...corners((node) => values[node]), 1);
    light.triangle(...corners(() => Math.min(1, lit)), 1);
  }
  const colours = colourTables[spaceFields[options.field].colours],
    image = raster.image([null, { colours, low: options.range[0], high: options.range[1] }]);
  light.values.forEach((lit, at) => {
    for (let k = 0; light.bodies[at] && k < 3; ++k) image.data[4 * at + k] *= lit;
  });
  context.putImageData(image, 0, 0);
}

/** Paints by the display card where the browser can, else plainly; `why` then says so. */
const spacePainter = {
  paint(context, frame, view, options) {
    if (this.gl === undefined)
      try {
        this.gl = new GlPainter();
      } catch (error) {
        this.give(error);
      }
    try {
      if (this.gl) return this.gl.paint(context, frame, view, options);
    } catch (error) {
      this.give(error);
    }
    return paintPlainly(context, frame, view, options);
  },
  give(error) {
    this.gl = null;
    this.why = `This browser draws without WebGL 2 (${error.message}): pictures are slower and show no mesh.`;
  },
};
