// SPDX-License-Identifier: GPL-3.0-or-later
// The section of glass and tools on a canvas.

const fields = {
  temperature: { label: "Temperature", unit: "°C", colours: "inferno", text: (value) => `${fixed(value, 0)} °C` },
  viscosity: {
    label: "Viscosity, logarithmic",
    unit: "Pa s",
    colours: "viridis",
    logarithmic: true,
    text: (value) => `10^${value.toFixed(2)} = ${figure(10 ** value, 2)} Pa s`,
  },
  pressure: {
    label: "Contact pressure",
    unit: "kPa",
    colours: "magma",
    onSurface: true,
    text: (value) => `${figure(value / 1000, 3)} kPa`,
  },
};
const toolColours = "cividis";

/** What a canvas shows of the plane, and where: pixels for each mm, the middle in mm. */
class View {
  constructor(extent, planar, width, room = Infinity, zoom = 1, shift = [0, 0]) {
    const [low, high, bottom, top] = extent,
      reach = planar ? (high - low) / 2 : high;
    const tall = 1.22 * (top - bottom),
      wide = Math.max(2.5 * reach, 0.55 * tall);
    this.width = Math.round(width);
    this.height = Math.round(Math.min(room, (width * tall) / wide));
    this.scale = zoom * Math.min(width / wide, this.height / tall);
    this.middle = [planar ? (low + high) / 2 : 0, (bottom + top) / 2];
    this.shift = shift;
  }
  x(r, side) {
    return this.width / 2 + this.scale * side * (r - this.middle[0]) + this.shift[0];
  }
  y(z, up) {
    return this.height / 2 - this.scale * up * (z - this.middle[1]) + this.shift[1];
  }
}

/** Draws one frame; `halves` are {run, frame, side}: side 1 to the right, -1 mirrored. Returns what is read by pointing. */
function drawSection(canvas, view, halves, options) {
  canvas.width = view.width;
  canvas.height = view.height;
  const raster = new Raster(view.width, view.height),
    context = canvas.getContext("2d"),
    names = [""],
    paints = [null],
    shapes = [];
  const field = fields[options.field];
  for (const { run, frame, side } of halves) {
    const up = options.turned && run.stages.length ? (run.stageAt(run.film.times[frame]).upright ? 1 : -1) : 1;
    for (const body of run.film.bodies(frame, options.field)) {
      const nodes = body.mesh.nodes,
        x = new Float32Array(nodes),
        y = new Float32Array(nodes);
      for (let i = 0; i < nodes; ++i)
        ((x[i] = view.x(body.places[i], side)), (y[i] = view.y(body.places[nodes + i], up)));
      const filled = body.glass && field.onSurface ? null : body.values;
      raster.body(body.mesh.cells, x, y, filled, names.length);
      paints.push(paintOf(body, options));
      names.push(halves.some((half) => half.run !== run) ? `${run.name}: ${body.name}` : body.name);
      shapes.push({ body, x, y });
    }
  }
  context.putImageData(raster.image(paints), 0, 0);
  for (const shape of shapes) strokeBody(context, shape, options, field);
  return { raster, names, shapes };
}

function paintOf(body, options) {
  const [low, high] = (body.glass ? options.range : options.toolRange) || [0, 1];
  const plain = isDark() ? 0xff5a524a : 0xffe6e0d8;
  if (body.glass && fields[options.field].onSurface) return { plain };
  return { colours: colourTables[body.glass ? fields[options.field].colours : toolColours], low, high, plain };
}

function strokeEdges(context, edges, x, y) {
  context.beginPath();
  for (const [first, last, mid] of edges) {
    context.moveTo(x[first], y[first]);
    context.quadraticCurveTo(
      2 * x[mid] - (x[first] + x[last]) / 2,
      2 * y[mid] - (y[first] + y[last]) / 2,
      x[last],
      y[last],
    );
  }
  context.stroke();
}

function strokeBody(context, { body, x, y }, options, field) {
  const edges = edgesOf(body.mesh);
  if (options.mesh) {
    context.lineWidth = 0.5;
    context.strokeStyle = body.glass ? "rgba(0,0,0,0.45)" : "rgba(255,255,255,0.3)";
    strokeEdges(context, edges.all, x, y);
  }
  const outline = edges.outline.filter(
    ([first, last, mid]) =>
      Math.max(Math.abs(body.places[first]), Math.abs(body.places[last]), Math.abs(body.places[mid])) > 1e-3,
  );
  context.lineWidth = options.line;
  context.strokeStyle = body.glass && isDark() ? "#fff" : "#000";
  strokeEdges(context, outline, x, y);
  if (body.glass && field.onSurface && body.values) strokePressure(context, outline, { body, x, y }, options);
}

function strokePressure(context, outline, { body, x, y }, options) {
  const [low, high] = options.range || [0, 1],
    colours = colourTables[fields[options.field].colours];
  context.lineWidth = 4 * options.line;
  context.lineCap = "round";
  for (const edge of outline) {
    const value = Math.max(...edge.map((node) => body.values[node]));
    if (!(value > 0)) continue;
    context.strokeStyle = cssOfWord(
      colours[Math.max(0, Math.min(255, Math.round((255 * (value - low)) / (high - low))))],
    );
    strokeEdges(context, [edge], x, y);
  }
}

/** What is under a pixel, as a text; empty outside all bodies. */
function readingAt(drawing, options, px, py) {
  const { raster, names, shapes } = drawing,
    at = Math.floor(py) * raster.width + Math.floor(px),
    number = raster.bodies[at];
  if (!number) return "";
  const { body, x, y } = shapes[number - 1],
    field = fields[options.field];
  let nearest = -1,
    distance = Infinity;
  const candidates = body.glass && field.onSurface ? edgesOf(body.mesh).outline.flat() : x.keys();
  for (const node of candidates) {
    const d = (x[node] - px) ** 2 + (y[node] - py) ** 2;
    if (d < distance) ((distance = d), (nearest = node));
  }
  const place = `r ${fixed(body.places[nearest], 1)} mm, z ${fixed(body.places[body.mesh.nodes + nearest], 1)} mm`;
  const value = body.glass && field.onSurface ? body.values && body.values[nearest] : raster.values[at];
  const text = value === value && value != null ? (body.glass ? field : fields.temperature).text(value) : "";
  return `${names[number]}${text ? ", " + text : ""} (${place})`;
}
