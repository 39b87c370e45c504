// SPDX-License-Identifier: GPL-3.0-or-later
// The film of the run with its controls, and the strip of the ends of the stages.

/** One film for all runs; where there are several, each half may show another one. */
class FilmPart extends Player {
  constructor(runs, state, timeChanged) {
    super(state, timeChanged);
    this.runs = runs.filter((run) => run.film);
    Object.assign(this, { view: null, drawing: null });
    const last = this.runs.length - 1;
    state.right = Math.min(state.right ?? last, last);
    state.left = Math.min(state.left ?? 0, last);
    state.field ??= "temperature";
    if (!this.runs[state.right].film.frames.some((frame) => frame[state.field]))
      state.field = Object.keys(fields).find((name) => this.range(name)) || "temperature";
    this.build();
  }

  get right() {
    return this.runs[this.state.right];
  }
  get left() {
    return this.runs[this.state.left];
  }
  get times() {
    return this.right.film.times;
  }

  range(name) {
    const ranges = this.runs.map((run) => run.film.range(name)).filter((range) => range);
    return ranges.length
      ? [Math.min(...ranges.map((range) => range[0])), Math.max(...ranges.map((range) => range[1]))]
      : null;
  }

  extent() {
    const all = this.runs.map((run) => run.film.extent());
    return [0, 1, 2, 3].map((k) => (k % 2 ? Math.max : Math.min)(...all.map((extent) => extent[k])));
  }

  build() {
    this.canvas = element("canvas", {
      role: "img",
      "aria-label": "section of glass and tools",
      onpointermove: (event) => this.point(event),
      onpointerleave: () => this.tell(""),
      onpointerdown: (event) => this.grip(event),
    });
    this.reading = element("p", { class: "reading soft", "aria-live": "off" });
    this.label = element("strong", { class: "number" });
    this.scales = element("div", { class: "panel" });
    this.element = element(
      "div",
      { class: "film" },
      element("div", { class: "screen" }, this.canvas, this.scrub(), this.label, this.reading),
      element("div", { class: "panel" }, ...this.controls(), this.scales),
    );
  }

  controls() {
    this.state.turned ??= true;
    const names = this.runs.map((run, i) => [i, run.name]);
    const zoom = (factor) => () => {
      this.state.zoom = Math.max(1, (this.state.zoom || 1) * factor);
      if (this.state.zoom === 1) this.state.shift = [0, 0];
      this.draw();
    };
    return [
      selectOf(
        this,
        "Colour",
        "field",
        Object.entries(fields)
          .filter(([name]) => this.range(name))
          .map(([name, field]) => [name, field.label]),
      ),
      ...(this.runs.length > 1 ? [selectOf(this, "Left", "left", names), selectOf(this, "Right", "right", names)] : []),
      tickOf(this, "colours of this moment", "ownScale"),
      tickOf(this, "mesh", "mesh"),
      this.runs.some((run) => run.stages.some((stage) => !stage.upright))
        ? tickOf(this, "turn over with the machine", "turned")
        : null,
      element(
        "div",
        {},
        element("button", { onclick: zoom(1.5), "aria-label": "closer" }, "+"),
        " ",
        element("button", { onclick: zoom(1 / 1.5), "aria-label": "farther" }, "−"),
        " ",
        element("button", { onclick: zoom(0) }, "Whole"),
      ),
    ].filter((control) => control);
  }

  options() {
    const run = this.right,
      frame = run.film.frames[this.state.index],
      own = this.state.ownScale && frame[this.state.field];
    return {
      field: this.state.field,
      range: own ? [own[1], Math.max(own[2], own[1] + 1e-6)] : this.range(this.state.field),
      toolRange: this.range(null),
      mesh: this.state.mesh,
      turned: this.state.turned,
      line: Math.max(1, (this.density || 1) * 0.8),
    };
  }

  draw() {
    const width = this.element.firstChild.clientWidth || 600;
    this.density = Math.min(2, window.devicePixelRatio || 1);
    this.clampIndex();
    const room = this.printing ? 600 : Math.min(900, Math.max(320, 0.8 * window.innerHeight)),
      planar = this.right.planar;
    this.view = new View(
      this.extent(),
      planar,
      width * this.density,
      room * this.density,
      this.state.zoom || 1,
      this.state.shift || [0, 0],
    );
    const time = this.times[this.state.index];
    const halves = planar
      ? [{ run: this.right, frame: this.state.index, side: 1 }]
      : [
          { run: this.left, frame: this.left.film.nearest(time), side: -1 },
          { run: this.right, frame: this.state.index, side: 1 },
        ];
    this.shown = this.options();
    this.drawing = drawSection(this.canvas, this.view, halves, this.shown);
    const stage = this.right.stageAt(time);
    const left = this.left.film.times,
      end = left[left.length - 1],
      ended = time > end + 1e-3 ? ` at its end, ${fixed(end, 2)} s` : "";
    const sides =
      this.left === this.right || planar ? "" : `; left ${this.left.name}${ended}, right ${this.right.name}`;
    this.label.textContent = `${time.toFixed(2)} s${stage ? ", " + words(stage.name) : ""}${sides}`;
    this.canvas.style.touchAction = (this.state.zoom || 1) > 1 ? "none" : "auto";
    this.scales.replaceChildren(...scaleBars(this.shown));
  }

  tell(text) {
    this.reading.textContent = text;
  }

  point(event) {
    if (!this.drawing) return;
    const box = this.canvas.getBoundingClientRect();
    const scale = Math.min(box.width / this.view.width, box.height / this.view.height);
    const left = (box.width - scale * this.view.width) / 2,
      top = (box.height - scale * this.view.height) / 2;
    const x = (event.clientX - box.left - left) / scale,
      y = (event.clientY - box.top - top) / scale;
    if (this.held) {
      this.state.shift = [this.held[2] + x - this.held[0], this.held[3] + y - this.held[1]];
      this.draw();
    }
    this.at = [x, y];
    const inside = x >= 0 && y >= 0 && x < this.view.width && y < this.view.height;
    this.tell(inside ? readingAt(this.drawing, this.shown, x, y) : "");
  }

  grip(event) {
    this.point(event);
    if (!((this.state.zoom || 1) > 1)) return;
    this.held = [...this.at, ...(this.state.shift || [0, 0])];
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.addEventListener(
      "pointerup",
      () => {
        this.held = null;
      },
      { once: true },
    );
  }
}

/** The colour scales of glass and tools with their ends. */
function scaleBars(options) {
  const field = fields[options.field],
    bars = [];
  if (options.range)
    bars.push(
      scaleBar(`glass, ${field.label.toLowerCase()}`, field.colours, options.range, (value) =>
        field.logarithmic ? `${figure(10 ** value, 2)} ${field.unit}` : field.text(value),
      ),
    );
  if (options.toolRange)
    bars.push(scaleBar("tools, temperature", toolColours, options.toolRange, fields.temperature.text));
  return bars;
}

/** The extent of the glass of a run over all its outputs, round and in space. */
function wholeExtent(run, film) {
  const [one, other] = [film.extent(), run.space ? run.space.extent() : film.extent()];
  return one.map((value, k) => (k % 2 ? Math.max : Math.min)(value, other[k]));
}

/** Small pictures of the ends of the stages; each leads the film there. */
function stripOf(run, film, showTime) {
  const options = {
    field: film.range("temperature") ? "temperature" : film.state.field,
    turned: true,
    line: 0.8,
    toolRange: film.range(null),
  };
  options.range = film.range(options.field);
  const inSpace = options.field === "temperature" && run.space && run.space.range("temperature");
  if (inSpace) options.range = [Math.min(options.range[0], inSpace[0]), Math.max(options.range[1], inSpace[1])];
  const view = new View(wholeExtent(run, film), run.planar, 260);
  const section = (stage) => {
    const canvas = element("canvas"),
      frame = run.film.nearest(stage.end);
    const halves = (run.planar ? [1] : [-1, 1]).map((side) => ({ run, frame, side }));
    drawSection(canvas, view, halves, options);
    return canvas;
  };
  return element(
    "div",
    { class: "strip" },
    ...run.stages.map((stage) =>
      element(
        "button",
        { title: "show this moment in the film", onclick: () => showTime(stage.end) },
        isInSpace(run, stage.end)
          ? spacePicture(
              run,
              stage.end,
              view,
              inSpace ? "temperature" : "thickness",
              inSpace ? options.range : run.space.range("thickness"),
            )
          : section(stage),
        words(stage.name),
        element("br"),
        element("small", {}, `${stage.end.toFixed(2)} s`),
      ),
    ),
  );
}
