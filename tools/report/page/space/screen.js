// SPDX-License-Identifier: GPL-3.0-or-later
// The container as it is seen: turned by dragging, cut open, with the thinnest place marked.

/** Draws on a canvas in its own pixels; returns its context. */
function sized(canvas, width, height) {
  [canvas.width, canvas.height] = [Math.round(width), Math.round(height)];
  return canvas.getContext("2d");
}

/** The pixel of a canvas that an event is at. */
function pixelOf(canvas, event) {
  const box = canvas.getBoundingClientRect(),
    scale = Math.min(box.width / canvas.width, box.height / canvas.height);
  return [
    (event.clientX - box.left - (box.width - scale * canvas.width) / 2) / scale,
    (event.clientY - box.top - (box.height - scale * canvas.height) / 2) / scale,
  ];
}

/** A ring about a place with its words. */
function markPlace(context, x, y, text, density, hidden = false) {
  context.save();
  context.globalAlpha = hidden ? 0.45 : 1;
  for (const [colour, width] of [
    ["#fff", 4],
    ["#000", 1.6],
  ]) {
    context.strokeStyle = colour;
    context.lineWidth = width * density;
    context.setLineDash(hidden ? [3 * density, 3 * density] : []);
    context.beginPath();
    context.arc(x, y, 6 * density, 0, 2 * Math.PI);
    context.stroke();
  }
  writeOver(context, text, x + 10 * density, y - 8 * density, density);
  context.restore();
}

/** Words that can be read on any ground, inside the canvas. */
function writeOver(context, text, x, y, density) {
  context.font = `600 ${12 * density}px system-ui, sans-serif`;
  context.setLineDash([]);
  context.lineJoin = "round";
  const left = Math.max(4, Math.min(x, context.canvas.width - context.measureText(text).width - 4)),
    low = Math.max(y, 14 * density);
  context.lineWidth = 3.5 * density;
  context.strokeStyle = isDark() ? "#000" : "#fff";
  context.strokeText(text, left, low);
  context.fillStyle = isDark() ? "#fff" : "#000";
  context.fillText(text, left, low);
}

/** A bar of a round length at the lower left. */
function scaleLength(context, pixels, density) {
  const length = [1, 2, 5, 10, 20, 50, 100, 200].filter((mm) => mm * pixels < context.canvas.width / 4).pop() || 1,
    [left, low] = [10 * density, context.canvas.height - 10 * density];
  context.strokeStyle = context.fillStyle = cssColour("--ink");
  context.lineWidth = 2 * density;
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(left, low - 4 * density);
  context.lineTo(left, low);
  context.lineTo(left + length * pixels, low);
  context.lineTo(left + length * pixels, low - 4 * density);
  context.stroke();
  context.font = `${12 * density}px system-ui, sans-serif`;
  context.fillText(`${length} mm`, left + 5 * density, low - 6 * density);
}

class SpaceScreen {
  constructor(part) {
    this.part = part;
    const { state } = part;
    ((state.azimuth ??= 0.45), (state.tilt ??= 0.3), (state.zoom ??= 1), (state.shift ??= [0, 0]), (state.cut ??= 0));
    this.canvas = element("canvas", {
      role: "img",
      tabindex: 0,
      "aria-label": "the container in space; arrow keys turn it, plus and minus zoom",
      style: { touchAction: "pan-y", cursor: "grab" },
      onpointerdown: (event) => this.grip(event),
      onpointermove: (event) => this.move(event),
      onpointerup: () => (this.held = null),
      onpointerleave: () => this.part.tell(""),
      onkeydown: (event) => this.press(event),
    });
    this.canvas.addEventListener("wheel", (event) => this.roll(event), { passive: false });
  }

  controls() {
    const { part } = this,
      { state } = part,
      zoom = (factor) => () => this.zoom(factor);
    return [
      selectOf(part, "Shown", "cut", cutChoices(part.film)),
      element(
        "div",
        {},
        element("button", { onclick: zoom(1.3), "aria-label": "closer" }, "+"),
        " ",
        element("button", { onclick: zoom(1 / 1.3), "aria-label": "farther" }, "−"),
        " ",
        element(
          "button",
          {
            onclick: () => {
              Object.assign(state, { azimuth: 0.45, tilt: 0.3, zoom: 1, shift: [0, 0], cutFor: null });
              part.draw();
            },
          },
          "Whole",
        ),
        " ",
        element("button", { onclick: () => this.look(0, -Math.PI / 2) }, "Base"),
        " ",
        element("button", { onclick: () => this.look(0, 0) }, "Side"),
      ),
      element("small", { class: "soft hint" }, "Drag to turn; with shift, move. The wheel zooms after a click."),
    ];
  }

  look(azimuth, tilt) {
    Object.assign(this.part.state, { azimuth, tilt, zoom: 1, shift: [0, 0] });
    this.draw();
  }

  zoom(factor) {
    const { state } = this.part;
    state.zoom = Math.max(0.5, Math.min(20, state.zoom * factor));
    state.shift = state.shift.map((one) => (state.zoom <= 1 ? 0 : one * factor));
    this.draw();
  }

  grip(event) {
    this.held = [event.clientX, event.clientY];
    this.canvas.focus({ preventScroll: true });
    this.canvas.setPointerCapture(event.pointerId);
  }

  move(event) {
    const { state } = this.part;
    if (this.held) {
      const [dx, dy] = [event.clientX - this.held[0], event.clientY - this.held[1]];
      this.held = [event.clientX, event.clientY];
      if (event.shiftKey) state.shift = [state.shift[0] + dx * this.density, state.shift[1] + dy * this.density];
      else this.turn(0.01 * dx, 0.01 * dy);
      this.draw();
      return;
    }
    if (this.view)
      this.part.tell(
        spaceReading(this.frame, pointedAt(this.frame, this.view, this.copies, ...pixelOf(this.canvas, event))),
      );
  }

  turn(azimuth, tilt) {
    const { state } = this.part;
    state.azimuth -= azimuth;
    state.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, state.tilt + tilt));
  }

  press(event) {
    const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
    if (turns) this.turn(...turns);
    else if ("+=-".includes(event.key)) this.zoom(event.key === "-" ? 1 / 1.3 : 1.3);
    else return;
    event.preventDefault();
    this.draw();
  }

  roll(event) {
    if (document.activeElement !== this.canvas) return;
    event.preventDefault();
    this.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15);
  }

  /** What is cut away is towards the viewer at the moment when it is chosen. */
  chooseCopies() {
    const { state, film } = this.part,
      key = `${state.run} ${state.cut}`;
    if (state.cutFor !== key) Object.assign(state, { cutFor: key, copies: copiesLeft(film, state.cut, state.azimuth) });
    return state.copies;
  }

  draw() {
    const { state, film } = this.part,
      width = this.canvas.parentNode.clientWidth || 600;
    this.density = Math.min(2, window.devicePixelRatio || 1);
    const room = this.part.printing ? 420 : Math.min(760, Math.max(300, 0.7 * window.innerHeight));
    this.frame = this.part.frame;
    this.copies = this.chooseCopies();
    this.view = new SpaceView(film.extent(), {
      ...state,
      width: width * this.density,
      height: Math.min(room, 1.1 * width) * this.density,
    });
    const options = { ...this.part.options(), copies: this.copies, mesh: state.mesh };
    const context = sized(this.canvas, this.view.width, this.view.height);
    spacePainter.paint(context, this.frame, this.view, options);
    scaleLength(context, this.view.pixels, this.density);
    if (state.marked) this.mark(context);
  }

  /** Marks the thinnest place in the copy in which it is seen, else pale where it is behind. */
  mark(context) {
    const thin = this.frame.extreme();
    if (!thin) return;
    const places = this.copies.map((copy) => {
      const [a, b, c, d] = this.frame.film.copy(copy);
      return this.view.seen(a * thin.x + b * thin.y, c * thin.x + d * thin.y, thin.z);
    });
    const best = places.reduce((one, other) => (other[2] > one[2] ? other : one)),
      over = pointedAt(this.frame, this.view, this.copies, best[0], best[1]),
      hidden = over !== null && over.depth > best[2] + 0.3;
    markPlace(context, best[0], best[1], spaceFields.thickness.text(thin.value), this.density, hidden);
  }
}
