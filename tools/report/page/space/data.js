// SPDX-License-Identifier: GPL-3.0-or-later
// Glass in space at the outputs of a run: the closed surface of a sector, and its copies around the axis.

const spaceFields = {
  thickness: { label: "Wall thickness", unit: "mm", colours: "wall", text: (value) => `${value.toFixed(2)} mm` },
  temperature: { label: "Temperature", unit: "°C", colours: "inferno", text: (value) => `${fixed(value, 0)} °C` },
  contact: {
    label: "Contact with tools",
    unit: "%",
    colours: "viridis",
    text: (value) => `${fixed(100 * value, 0)} % in contact`,
  },
};

const sideNames = ["inside", "outside", "rim", "cut", "cut"];
const [insideFaces, outsideFaces, rimFaces, firstPlane, lastPlane] = [0, 1, 2, 3, 4];

/** Beyond so many nodes faces are fine enough as they are. */
const mostRefined = 8000;

/** Shares of the three nodes of a quadratic line at its quarters. */
const quarterShares = [
  [1, 0, 0],
  [0.375, 0.75, -0.125],
  [0, 1, 0],
  [-0.125, 0.75, 0.375],
  [0, 0, 1],
];

/** The faces of one surface by their side as triangles. A face of nine nodes is quadratic: that its roundings show, it
 * gets the places at its quarters as further nodes, whose values lie between those beside them. */
class SpaceMesh {
  constructor(json, buffer) {
    this.nodes = this.own = json.nodes;
    this.faces = new Uint16Array(buffer, json.at, 9 * json.faces);
    this.sides = new Uint16Array(buffer, json.sides, json.faces);
    this.added = []; // {nodes of a face, shares, nodes beside}
    this.across = this.own <= mostRefined ? 5 : 3;
    const known = new Map();
    this.grids = Array.from(this.sides, (_, face) => this.gridOf(this.faces.subarray(9 * face, 9 * face + 9), known));
    this.nodes = this.own + this.added.length;
    this.triangles = sideNames.map((_, side) => this.trianglesOf(side));
    this.nodesOf = this.triangles.map((triangles) => Uint16Array.from(new Set(triangles)));
    this.lines = new Map();
  }

  /** The nodes of a face in rows. */
  gridOf(face, known) {
    if (this.across === 3) return face;
    const grid = new Uint16Array(25);
    for (let j = 0; j < 5; ++j)
      for (let i = 0; i < 5; ++i) {
        const beside = [Math.floor, Math.ceil].flatMap((v) =>
          [Math.floor, Math.ceil].map((u) => face[u(i / 2) + 3 * v(j / 2)]),
        );
        // Faces that share an edge share what is added on it.
        const key = i % 4 && j % 4 ? null : [...new Set(beside)].sort().join();
        if (i % 2 === 0 && j % 2 === 0) grid[i + 5 * j] = beside[0];
        else grid[i + 5 * j] = known.get(key) ?? this.add(face, i, j, beside);
        if (key) known.set(key, grid[i + 5 * j]);
      }
    return grid;
  }

  add(nodes, i, j, beside) {
    const shares = Array.from(nodes, (_, k) => quarterShares[i][k % 3] * quarterShares[j][Math.floor(k / 3)]);
    return this.own + this.added.push({ nodes, shares, beside }) - 1;
  }

  trianglesOf(side) {
    const triangles = [],
      n = this.across;
    this.sides.forEach((of, face) => {
      if (of !== side) return;
      for (let at = 0; at < n * (n - 1); ++at) {
        if (at % n === n - 1) continue;
        const [a, b, c, d] = [0, 1, n + 1, n].map((step) => this.grids[face][at + step]);
        triangles.push(a, b, c, a, c, d);
      }
    });
    return Uint16Array.from(triangles);
  }

  /** Edges of the faces of a side as pairs of nodes; with `once` those of one face alone. */
  linesOf(side, once) {
    const key = `${side} ${once}`;
    if (!this.lines.has(key)) this.lines.set(key, Uint16Array.from(this.edgesOf(side, once)));
    return this.lines.get(key);
  }

  edgesOf(side, once) {
    const seen = new Map(),
      n = this.across;
    this.sides.forEach((of, face) => {
      if (of !== side) return;
      for (const [first, step] of [
        [0, 1],
        [n * (n - 1), 1],
        [0, n],
        [n - 1, n],
      ]) {
        const nodes = Array.from({ length: n }, (_, i) => this.grids[face][first + i * step]),
          middle = nodes[(n - 1) / 2],
          found = seen.get(middle);
        if (found) found.count += 1;
        else seen.set(middle, { nodes, count: 1 });
      }
    });
    const edges = [...seen.values()].filter((edge) => !once || edge.count === 1);
    return edges.flatMap(({ nodes }) => nodes.slice(1).flatMap((node, i) => [nodes[i], node]));
  }

  /** Places with those of the added nodes, in one direction. */
  withPlaces(list) {
    const all = new Float32Array(this.nodes);
    all.set(list);
    this.added.forEach(({ nodes, shares }, i) => {
      for (let k = 0; k < 9; ++k) all[this.own + i] += shares[k] * list[nodes[k]];
    });
    return all;
  }

  /** Values with those of the added nodes. */
  withValues(list) {
    const all = new Float32Array(this.nodes);
    all.set(list);
    this.added.forEach(({ beside }, i) => {
      for (const node of beside) all[this.own + i] += list[node] / 4;
    });
    return all;
  }
}

/** The outputs of a run. Places are in mm as the container stands: its mouth up, which may turn the case's frame over
 * about the x axis; `z` here goes up. */
class SpaceFilm {
  constructor(json, buffer) {
    Object.assign(this, json);
    this.buffer = buffer;
    this.meshes = json.meshes.map((mesh) => new SpaceMesh(mesh, buffer));
    this.times = json.frames.map((frame) => frame.t);
    this.sector = (2 * Math.PI) / this.copies;
    this.kept = new Map();
    this.up = 1;
    this.up = this.mouthIsUp(this.at(this.times.length - 1)) ? 1 : -1;
    this.kept.clear();
  }

  /** The mouth is where the rim is. */
  mouthIsUp(frame) {
    const rim = frame.mesh.nodesOf[rimFaces];
    if (!rim.length) return true;
    const mean = rim.reduce((sum, node) => sum + frame.z[node], 0) / rim.length;
    return mean > (frame.bottom + frame.top) / 2;
  }

  /** An output with its numbers; the last few are kept. */
  at(index) {
    if (!this.kept.has(index)) {
      if (this.kept.size > 4) this.kept.delete(this.kept.keys().next().value);
      this.kept.set(index, new SpaceFrame(this, this.frames[index]));
    }
    return this.kept.get(index);
  }

  nearest(time) {
    return nearestOf(this.times, time);
  }

  /** Mean wall of an output by area: of the last one that of the run's own summary, where that is there. */
  meanWall(index) {
    const known = index === this.times.length - 1 && this.summary ? this.summary.mean_thickness_mm : NaN;
    return Number.isFinite(known) ? known : this.at(index).meanWall();
  }

  /** Lowest and highest value of a field over all outputs. */
  range(name) {
    const ranges = this.frames.map((frame) => frame[name]).filter((field) => field);
    if (!ranges.length) return null;
    const low = Math.min(...ranges.map((field) => field[1])),
      high = Math.max(...ranges.map((field) => field[2]));
    return [low, high > low ? high : low + 1];
  }

  /** The extent of the glass over all outputs: r least and most, z least and most, as it stands. */
  extent() {
    if (this.known) return this.known;
    const extent = [0, 0, Infinity, -Infinity];
    this.times.forEach((_, i) => {
      const frame = this.at(i);
      extent[1] = Math.max(extent[1], frame.radius);
      extent[2] = Math.min(extent[2], frame.bottom);
      extent[3] = Math.max(extent[3], frame.top);
    });
    return (this.known = extent);
  }

  /** The place of a point of the sector in one of its copies: [a, b, c, d] of x' = a x + b y, y' = c x + d y. */
  copy(number) {
    const turn = (number % 2 ? number + 1 : number) * this.sector,
      [cos, sin] = [Math.cos(turn), this.up * Math.sin(turn)];
    return number % 2 ? [cos, sin, sin, -cos] : [cos, -sin, sin, cos];
  }

  /** The angle in the sector, rad, at which the glass is as it is at an angle. */
  folded(angle) {
    const turn = 2 * Math.PI,
      around = ((angle % turn) + turn) % turn,
      number = Math.min(this.copies - 1, Math.floor(around / this.sector + 1e-9)),
      inside = around - number * this.sector;
    return Math.max(0, number % 2 ? this.sector - inside : inside);
  }
}

class SpaceFrame {
  constructor(film, json) {
    Object.assign(this, { film, json, t: json.t, mesh: film.meshes[json.mesh] });
    const { own } = this.mesh,
      packed = new Uint16Array(film.buffer, json.points, 3 * own),
      step = film.box[3];
    const places = [0, 1, 2].map((k) =>
      this.mesh.withPlaces(
        Float32Array.from(packed.subarray(k * own, (k + 1) * own), (word) => film.box[k] + step * word),
      ),
    );
    [this.x, this.y, this.z] = places;
    if (film.up < 0) for (const list of [this.y, this.z]) list.forEach((value, i) => (list[i] = -value));
    [this.bottom, this.top, this.radius] = [Infinity, -Infinity, 0];
    // Of the nodes alone, as in wall.csv: heights are above the lowest of them.
    for (let i = 0; i < own; ++i) {
      this.bottom = Math.min(this.bottom, this.z[i]);
      this.top = Math.max(this.top, this.z[i]);
      this.radius = Math.max(this.radius, Math.hypot(this.x[i], this.y[i]));
    }
    this.read = {};
  }

  /** A field by node; null where the output has none. */
  values(name) {
    const field = this.json[name];
    if (!field) return null;
    const [at, low, high] = field,
      [Packed, most] = name === "thickness" ? [Uint16Array, 65535] : [Uint8Array, 255];
    return (this.read[name] ??= this.mesh.withValues(
      Float32Array.from(new Packed(this.film.buffer, at, this.mesh.own), (word) => low + ((high - low) * word) / most),
    ));
  }

  /** The range of a field for colours: of the wall without its extremes, which the rim and the corners of the base are. */
  range(name) {
    const values = this.values(name);
    if (!values) return null;
    const some = name === "thickness" ? this.mesh.nodesOf[outsideFaces] : values.keys();
    const sorted = Float32Array.from(some, (node) => values[node]).sort(),
      off = name === "thickness" ? Math.floor(0.02 * sorted.length) : 0;
    const [low, high] = [sorted[off], sorted[sorted.length - 1 - off]];
    return [low, high > low ? high : low + 1];
  }

  /** The angle about the axis in the case's frame, degrees, 0 to 360. */
  angleOf(x, y) {
    const angle = (Math.atan2(this.film.up * y, x) * 180) / Math.PI;
    return angle < -1e-6 ? angle + 360 : Math.max(0, angle);
  }

  /** The thinnest or thickest place of the outer side: {node, x, y, z, value, height, angle}. */
  extreme(sign = 1) {
    const wall = this.values("thickness");
    if (!wall) return null;
    const node = this.mesh.nodesOf[outsideFaces].reduce((best, one) =>
      sign * wall[one] < sign * wall[best] ? one : best,
    );
    return { ...this.placeOf(node), value: wall[node] };
  }

  placeOf(node) {
    const [x, y, z] = [this.x[node], this.y[node], this.z[node]];
    return { node, x, y, z, height: z - this.bottom, angle: this.angleOf(x, y) };
  }

  /** Mean wall by area of the outer side; quadratic on a face, as the run's own. */
  meanWall() {
    const values = this.values("thickness"),
      triangles = this.mesh.triangles[outsideFaces];
    if (!values) return NaN;
    const wall = this.mesh.withPlaces(values.subarray(0, this.mesh.own));
    let [sum, whole] = [0, 0];
    for (let i = 0; i < triangles.length; i += 3) {
      const [a, b, c] = triangles.subarray(i, i + 3),
        area = Math.hypot(...this.across(a, b, c));
      sum += (area * (wall[a] + wall[b] + wall[c])) / 3;
      whole += area;
    }
    return sum / whole;
  }

  /** Normal of a triangle, of twice its area. */
  across(a, b, c) {
    const [ux, uy, uz] = [this.x[b] - this.x[a], this.y[b] - this.y[a], this.z[b] - this.z[a]],
      [vx, vy, vz] = [this.x[c] - this.x[a], this.y[c] - this.y[a], this.z[c] - this.z[a]];
    return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  }

  normalsOf(side) {
    this.known ??= [];
    return (this.known[side] ??= this.normals(side));
  }

  /** Unit normals of the nodes of a side; in a plane of symmetry they lie in it. */
  normals(side) {
    const normals = new Float32Array(3 * this.mesh.nodes),
      triangles = this.mesh.triangles[side];
    for (let i = 0; i < triangles.length; i += 3) {
      const nodes = triangles.subarray(i, i + 3),
        normal = this.across(...nodes);
      for (const node of nodes) for (let k = 0; k < 3; ++k) normals[3 * node + k] += normal[k];
    }
    const planes = side < firstPlane ? this.planeNormals() : [];
    for (const node of this.mesh.nodesOf[side]) {
      const normal = normals.subarray(3 * node, 3 * node + 3);
      for (const [px, py] of planes)
        if (Math.abs(px * this.x[node] + py * this.y[node]) < 0.01) {
          const along = px * normal[0] + py * normal[1];
          ((normal[0] -= along * px), (normal[1] -= along * py));
        }
      const size = Math.hypot(...normal) || 1;
      normal.forEach((value, k) => (normal[k] = value / size));
    }
    return normals;
  }

  planeNormals() {
    if (this.film.copies < 2) return [];
    const end = this.film.up * this.film.sector;
    return [
      [0, 1],
      [-Math.sin(end), Math.cos(end)],
    ];
  }
}
