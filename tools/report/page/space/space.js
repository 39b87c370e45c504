// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the page on glass in space: the container, its wall unrolled and sections, all at one moment.

class SpacePart extends Player {
  constructor(runs, state, timeChanged, charts) {
    super(state, timeChanged);
    this.runs = runs.filter((run) => run.space);
    state.run = Math.min(state.run ?? 0, this.runs.length - 1);
    state.field ??= "thickness";
    if (!this.film.frames[this.last][state.field]) state.field = "temperature";
    ((state.ownScale ??= true), (state.marked ??= true));
    this.clampedStart();
    this.screen = new SpaceScreen(this);
    this.map = new WallMap(this);
    this.sections = new WallSections(this, charts);
    this.build();
  }

  get run() {
    return this.runs[this.state.run];
  }
  get film() {
    return this.run.space;
  }
  get times() {
    return this.film.times;
  }
  get frame() {
    return this.film.at(this.state.index);
  }

  get isHeld() {
    return Boolean(this.playing || this.screen.held);
  }

  clampedStart() {
    this.state.index = Math.max(0, Math.min(this.last, this.state.index ?? this.last));
  }

  build() {
    this.label = element("strong", { class: "number" });
    this.reading = element("p", { class: "reading soft" });
    this.scale = element("div", {});
    this.painter = element("p", { class: "soft" });
    const names = this.runs.map((run, i) => [i, run.name]);
    const known = Object.entries(spaceFields).filter(([name]) => this.film.range(name));
    this.element = element(
      "div",
      { class: "film" },
      element("div", { class: "screen" }, this.screen.canvas, this.scrub(), this.label, this.reading, this.painter),
      element(
        "div",
        { class: "panel" },
        ...(this.runs.length > 1 ? [selectOf(this, "Run", "run", names)] : []),
        selectOf(
          this,
          "Colour",
          "field",
          known.map(([name, field]) => [name, field.label]),
        ),
        ...this.screen.controls(),
        tickOf(this, "colours of this moment", "ownScale"),
        tickOf(this, "thinnest place", "marked"),
        tickOf(this, "mesh", "mesh"),
        this.scale,
      ),
    );
  }

  /** The range of a field that the colours span. */
  rangeOf(field) {
    return this.state.ownScale ? this.frame.range(field) : this.film.range(field);
  }

  options() {
    return { field: this.state.field, range: this.rangeOf(this.state.field) || [0, 1] };
  }

  /** The scale of a field; colours of the wall leave its extremes out. */
  bar(name) {
    const field = spaceFields[name],
      [low, high] = this.rangeOf(name) || [0, 1],
      cut = this.state.ownScale && name === "thickness";
    return scaleBar(`${field.label}, ${field.unit}`, field.colours, [low, high], (value) => {
      const text = name === "contact" ? fixed(100 * value, 0) : fixed(value, name === "thickness" ? 2 : 0);
      return cut ? `${value === low ? "≤" : "≥"} ${text}` : text;
    });
  }

  moment() {
    const stage = this.run.stageAt(this.time);
    return `${this.time.toFixed(2)} s${stage ? `, ${words(stage.name)}` : ""}`;
  }

  draw() {
    this.clampIndex();
    this.label.textContent = this.moment();
    this.screen.draw();
    this.painter.textContent = spacePainter.why || "";
    this.scale.replaceChildren(this.bar(this.state.field));
    this.drawWall();
  }

  /** What depends on the height and the angle that are chosen too. */
  drawWall() {
    this.map.draw();
    this.sections.draw();
  }

  tell(text) {
    this.reading.textContent = text;
  }

  parts() {
    return [
      part("space", "Container", this.element),
      part("map", "Wall map", this.map.element),
      part("sections", "Sections", this.sections.element),
    ];
  }
}

/** Whether a moment of a run is one of glass in space. */
const isInSpace = (run, time) => Boolean(run.space) && time > run.space.times[0] + 1e-9;

/** A small picture of glass in space at a moment, to the scale of the sections beside it. */
function spacePicture(run, time, view, field, range) {
  const frame = run.space.at(run.space.nearest(time));
  const of = new SpaceView(run.space.extent(), {
    width: view.width,
    height: view.height,
    azimuth: 0.45,
    tilt: 0.3,
    pixels: 0.85 * view.scale,
  });
  const copies = Array.from({ length: run.space.copies }, (_, copy) => copy),
    canvas = element("canvas");
  const options = { field, range, copies };
  spacePainter.paint(sized(canvas, of.width, of.height), frame, of, options);
  return canvas;
}
