// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of the sector: where a plane meets its closed surface.

/** The closed lines in which the surface of a frame meets a plane; `distance` is that of each node from it. Each is a list
 * of {x, y, z, wall, side}: a point, and the side of the piece that leads to the next one. */
function cutSurface(frame, distance) {
  const pieces = new Map(); // by the edge of the mesh at either end
  const wall = frame.values("thickness");
  const add = (edge, piece) => (pieces.has(edge) ? pieces.get(edge).push(piece) : pieces.set(edge, [piece]));
  frame.mesh.triangles.forEach((triangles, side) => {
    for (let i = 0; i < triangles.length; i += 3) {
      const ends = [];
      for (let k = 0; k < 3; ++k) {
        const [a, b] = [triangles[i + k], triangles[i + ((k + 1) % 3)]];
        if (distance[a] < 0 !== distance[b] < 0) ends.push(a < b ? a * 65536 + b : b * 65536 + a);
      }
      if (ends.length < 2) continue;
      const piece = { ends, side };
      ends.forEach((edge) => add(edge, piece));
    }
  });
  return chains(pieces).map((chain) =>
    chain.map(({ edge, side }) => {
      const [a, b] = [Math.floor(edge / 65536), edge % 65536],
        share = distance[a] / (distance[a] - distance[b]),
        between = (list) => list[a] + share * (list[b] - list[a]);
      return { x: between(frame.x), y: between(frame.y), z: between(frame.z), wall: wall ? between(wall) : NaN, side };
    }),
  );
}

/** Pieces end to end: lists of {edge, side}. */
function chains(pieces) {
  const used = new Set(),
    found = [];
  for (const [start, [first]] of pieces) {
    if (used.has(first)) continue;
    const chain = [];
    let [edge, piece] = [start, first];
    while (piece && !used.has(piece)) {
      used.add(piece);
      chain.push({ edge, side: piece.side });
      edge = piece.ends[0] === edge ? piece.ends[1] : piece.ends[0];
      piece = pieces.get(edge).find((one) => !used.has(one));
    }
    found.push(chain);
  }
  return found;
}

/** The section at a height above the lowest place, in the sector. */
function cutAtHeight(frame, height) {
  const at = frame.bottom + Math.max(1e-3, Math.min(frame.top - frame.bottom - 1e-3, height));
  return cutSurface(
    frame,
    frame.z.map((z) => z - at),
  );
}

/** The section of the half plane at an angle of the case, rad: points as {r, z, wall, side}. */
function cutAtAngle(frame, angle) {
  const { film } = frame,
    folded = film.copies > 1 ? Math.max(1e-5, Math.min(film.sector - 1e-5, film.folded(angle))) : angle + 1e-5,
    [cos, sin] = [Math.cos(folded), film.up * Math.sin(folded)];
  const cuts = cutSurface(
    frame,
    frame.x.map((x, i) => cos * frame.y[i] - sin * x),
  );
  const along = cuts.map((cut) => cut.map((point) => ({ ...point, r: cos * point.x + sin * point.y })));
  // Of a whole turn the plane meets the other half too.
  return film.copies > 1 ? along : along.map((cut) => cut.filter((point) => point.r > -0.05));
}

/** At each height the wall of the outermost place of the outer side in a section; NaN where it has none. */
function wallOverHeights(cuts, bottom, heights) {
  const walls = new Float32Array(heights.length).fill(NaN),
    reach = new Float32Array(heights.length).fill(-Infinity);
  for (const cut of cuts)
    cut.forEach((from, i) => {
      if (from.side !== outsideFaces) return;
      const to = cut[(i + 1) % cut.length];
      eachCrossing(from.z - bottom, to.z - bottom, heights, (k, share) => {
        const r = from.r + share * (to.r - from.r);
        if (r > reach[k]) ((reach[k] = r), (walls[k] = from.wall + share * (to.wall - from.wall)));
      });
    });
  return walls;
}

/** The thinnest wall around at each height, base and side. */
function thinnestOverHeights(frame, heights) {
  const wall = frame.values("thickness"),
    walls = new Float32Array(heights.length).fill(NaN),
    triangles = frame.mesh.triangles[outsideFaces];
  triangles.forEach((from, i) => {
    const to = triangles[i % 3 === 2 ? i - 2 : i + 1];
    eachCrossing(frame.z[from] - frame.bottom, frame.z[to] - frame.bottom, heights, (k, share) => {
      const value = wall[from] + share * (wall[to] - wall[from]);
      if (!(walls[k] <= value)) walls[k] = value;
    });
  });
  return walls;
}

/** The even heights between two, with the share of the way. */
function eachCrossing(from, to, heights, visit) {
  const step = heights[1] - heights[0],
    first = Math.max(0, Math.ceil((Math.min(from, to) - heights[0]) / step)),
    last = Math.min(heights.length - 1, Math.floor((Math.max(from, to) - heights[0]) / step));
  for (let k = first; k <= last; ++k) visit(k, to === from ? 0 : (heights[k] - from) / (to - from));
}

/** The smallest angle, rad, at which a section that is not round reaches out furthest, where that is inside the sector:
 * its corner; nothing of a round one, or where it is in a plane of symmetry. */
function cornerAngle(frame) {
  const { film } = frame,
    cut = cutAtHeight(frame, 0.5 * (frame.top - frame.bottom)).flat(),
    outer = cut.filter((point) => point.side === outsideFaces);
  if (outer.length < 3) return null;
  const radii = outer.map((point) => Math.hypot(point.x, point.y)),
    most = Math.max(...radii),
    angles = outer.map((point) => film.folded((frame.angleOf(point.x, point.y) * Math.PI) / 180)),
    angle = Math.min(...angles.filter((_, i) => radii[i] > 0.999 * most));
  const inside = angle > 0.03 && angle < film.sector - 0.03;
  return inside && most > 1.02 * Math.min(...radii) ? angle : null;
}
