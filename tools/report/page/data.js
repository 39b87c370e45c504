// SPDX-License-Identifier: GPL-3.0-or-later
// The data of the page: JSON, and numbers packed into one compressed text.

async function unpacked(text) {
  const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  if (typeof DecompressionStream === "undefined")
    throw new Error("this browser cannot unpack the data of the report; a newer one can");
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

const isObject = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
const objects = (value) => (Array.isArray(value) ? value.filter(isObject) : []);
const texts = (value) => (Array.isArray(value) ? value.map(String) : []);

/** A summary with every part of the kind that the page expects: a file may have been edited, or be of another version. */
function readSummary(given) {
  const summary = isObject(given) ? given : {};
  for (const name of ["glass", "thickness", "container", "quantities"])
    if (!isObject(summary[name])) summary[name] = {};
  for (const [name, one] of Object.entries(summary.quantities)) if (!isObject(one)) delete summary.quantities[name];
  summary.complete = Array.isArray(summary.checks) && Array.isArray(summary.flags);
  for (const name of ["checks", "flags", "stages"]) summary[name] = objects(summary[name]);
  for (const name of ["warnings", "overrides"]) summary[name] = texts(summary[name]);
  summary.stages = summary.stages.filter((stage) => isObject(stage.work));
  return summary;
}

/** A column of a packed table; null where there is none. */
function columnOf(table, buffer, name) {
  const at = table ? table.names.indexOf(name) : -1;
  return at < 0 ? null : new Float32Array(buffer, table.at + 4 * at * table.rows, table.rows);
}

/** The place in a list of times that is nearest to one. */
function nearestOf(times, time) {
  let best = 0;
  times.forEach((at, i) => {
    if (Math.abs(at - time) < Math.abs(times[best] - time)) best = i;
  });
  return best;
}

/** A run with its numbers. */
class Run {
  constructor(json, buffer, index) {
    Object.assign(this, json);
    this.index = index;
    this.buffer = buffer;
    this.summary = readSummary(json.summary);
    this.film = json.film ? new Film(json.film, buffer) : null;
    this.space = json.space ? new SpaceFilm(json.space, buffer) : null;
  }

  /** A column of one of the tables; null where there is none. */
  column(tableName, name) {
    return columnOf(this[tableName], this.buffer, name);
  }

  /** Names of the tools that have a column with this ending. */
  toolsWith(tableName, ending) {
    const table = this[tableName];
    return table
      ? table.names.filter((name) => name.endsWith(ending)).map((name) => name.slice(0, -ending.length))
      : [];
  }

  get endTime() {
    const times = this.column("history", "time_s");
    return times && times.length ? times[times.length - 1] : 0;
  }

  /** How far a run has come that has not completed: "at 0.51 s, stopped"; empty for one that has. */
  get short() {
    if (this.state === "completed") return "";
    return `at ${figure(this.endTime)} s, ${this.state === "running" ? "still running" : "stopped"}`;
  }

  stageAt(time) {
    return this.stages.find((stage) => time <= stage.end + 1e-9) || this.stages[this.stages.length - 1];
  }
}

/** The sections at the outputs of a run. */
class Film {
  constructor(json, buffer) {
    Object.assign(this, json);
    this.buffer = buffer;
    this.meshes = json.meshes.map(([nodes, cells, at]) => ({ nodes, cells: new Uint16Array(buffer, at, 6 * cells) }));
    this.times = json.frames.map((frame) => frame.t);
  }

  /** Places of the nodes, mm: all r, then all z. */
  points(at, box, nodes) {
    const packed = new Uint16Array(this.buffer, at, 2 * nodes),
      places = new Float32Array(2 * nodes);
    for (let i = 0; i < nodes; ++i) {
      places[i] = box[0] + box[2] * packed[i];
      places[nodes + i] = box[1] + box[2] * packed[nodes + i];
    }
    return places;
  }

  values(field, nodes) {
    if (!field) return null;
    const [at, low, high] = field,
      packed = new Uint8Array(this.buffer, at, nodes),
      values = new Float32Array(nodes);
    for (let i = 0; i < nodes; ++i) values[i] = low + ((high - low) / 255) * packed[i];
    return values;
  }

  /** The bodies of a frame: the active tools, then the glass. */
  bodies(index, fieldName) {
    const frame = this.frames[index],
      bodies = [];
    for (const [tool, shift, field] of frame.tools) {
      const of = this.tools[tool],
        mesh = this.meshes[of.mesh],
        places = this.toolPoints(of).slice();
      for (let i = mesh.nodes; i < 2 * mesh.nodes; ++i) places[i] += shift;
      bodies.push({ name: of.name, glass: false, mesh, places, values: this.values(field, mesh.nodes) });
    }
    const mesh = this.meshes[frame.mesh];
    bodies.push({
      name: "glass",
      glass: true,
      mesh,
      places: this.points(frame.points, this.box, mesh.nodes),
      values: this.values(frame[fieldName], mesh.nodes),
    });
    return bodies;
  }

  toolPoints(tool) {
    tool.places ??= this.points(tool.points, tool.box, this.meshes[tool.mesh].nodes);
    return tool.places;
  }

  /** Lowest and highest value of a field over all frames; of the tools where no field is named. */
  range(fieldName) {
    let low = Infinity,
      high = -Infinity;
    for (const frame of this.frames)
      for (const field of fieldName ? [frame[fieldName]] : frame.tools.map((tool) => tool[2]))
        if (field) ((low = Math.min(low, field[1])), (high = Math.max(high, field[2])));
    return low <= high ? [low, high > low ? high : low + 1] : null;
  }

  /** The extent of the glass over all frames, mm: r least, r most, z least, z most. */
  extent() {
    if (this.known) return this.known;
    const extent = [Infinity, -Infinity, Infinity, -Infinity];
    for (const frame of this.frames) {
      const nodes = this.meshes[frame.mesh].nodes,
        places = this.points(frame.points, this.box, nodes);
      for (let i = 0; i < nodes; ++i) {
        ((extent[0] = Math.min(extent[0], places[i])), (extent[1] = Math.max(extent[1], places[i])));
        ((extent[2] = Math.min(extent[2], places[nodes + i])), (extent[3] = Math.max(extent[3], places[nodes + i])));
      }
    }
    return (this.known = extent);
  }

  /** The frame nearest to a time. */
  nearest(time) {
    return nearestOf(this.times, time);
  }
}
