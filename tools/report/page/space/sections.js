// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of the wall: at a height, at an angle, and its thickness over the height.

/** A straight line, longer at both ends by a share. */
function strokeLine(context, [x, y], [u, v], more = 0) {
  context.beginPath();
  context.moveTo(x - more * (u - x), y - more * (v - y));
  context.lineTo(u + more * (u - x), v + more * (v - y));
  context.stroke();
}

class WallSections {
  constructor(part, charts) {
    this.part = part;
    // Which curves there are does not depend on the moment: at the last one the glass has its shape.
    const { state, film } = part,
      frame = film.at(film.times.length - 1),
      corner = cornerAngle(frame);
    state.height ??= 0.5 * (frame.top - frame.bottom);
    state.angle ??= corner == null ? 0 : (corner * 180) / Math.PI;
    const canvas = (label, draw, click) =>
      element("canvas", {
        role: "img",
        "aria-label": label,
        style: { cursor: "crosshair" },
        onpointermove: (event) => this.tell(draw(), event),
        onpointerleave: () => (this.reading.textContent = ""),
        onclick: click,
      });
    this.across = canvas(
      "section of the wall at a height",
      () => this.acrossShown,
      (event) => this.pickAngle(event),
    );
    this.along = canvas(
      "section of the wall at an angle",
      () => this.alongShown,
      (event) => this.pickHeight(event),
    );
    this.reading = element("p", { class: "reading soft" });
    this.acrossLabel = element("p", { class: "number" });
    this.alongLabel = element("p", { class: "number" });
    this.heights = this.slider("height", "height");
    this.angles = this.slider("angle", "angle");
    this.chart = charts.chart({
      title: "Wall thickness over height",
      note: "at the moment shown; at an angle that of the side, thinnest around also that of the base",
      xLabel: "height, mm",
      yLabel: "thickness, mm",
      upright: true,
      height: 460,
      series: this.series(frame),
    });
    const column = (title, canvas, ...others) =>
      element("div", { class: "screen" }, element("h3", {}, title), canvas, ...others);
    this.element = element(
      "div",
      {},
      element(
        "div",
        { class: "sections" },
        column("At a height", this.across, this.heights, this.acrossLabel),
        column("At an angle", this.along, this.angles, this.alongLabel),
        this.chart,
      ),
      this.reading,
    );
  }

  /** Of the sector. */
  get degrees() {
    return (this.part.film.sector * 180) / Math.PI;
  }

  slider(key, label) {
    const input = element("input", {
      type: "range",
      min: 0,
      max: 100,
      step: "any",
      "aria-label": label,
      oninput: () => {
        this.part.state[key] = Number(input.value);
        this.part.drawWall();
      },
    });
    return element("div", { class: "scrub" }, input);
  }

  /** Thickness over even heights: in the planes of symmetry, at the corner and the chosen angle, thinnest around. */
  series(frame) {
    const { state } = this.part,
      count = 120,
      tall = frame.top - frame.bottom,
      heights = Float32Array.from({ length: count }, (_, i) => (tall * (i + 0.5)) / count),
      corner = cornerAngle(frame),
      degrees = this.degrees;
    const at = (angle) => (angle == null ? [] : wallOverHeights(cutAtAngle(frame, angle), frame.bottom, heights));
    const one = (label, y, colour, dash = 0) => ({ label, x: heights, y, colour, dash });
    return [
      one("at 0°", at(0), 0),
      ...(degrees > 90 ? [one("at 90°", at(Math.PI / 2), 4)] : []),
      ...(degrees < 360 ? [one(`at ${figure(degrees)}°`, at((degrees * Math.PI) / 180), 2, 1)] : []),
      one("at the corner", at(corner), 3),
      one("thinnest around", thinnestOverHeights(frame, heights), 1, 2),
      one("at the angle chosen", at((state.angle * Math.PI) / 180), 6, 1),
    ];
  }

  draw() {
    const { frame, state } = this.part,
      density = Math.min(2, window.devicePixelRatio || 1),
      tall = frame.top - frame.bottom;
    state.height = Math.max(0, Math.min(tall, state.height));
    const [heights, angles] = [this.heights.firstChild, this.angles.firstChild];
    Object.assign(heights, { max: tall, value: state.height });
    Object.assign(angles, { max: this.degrees, value: state.angle });
    this.density = density;
    this.range = this.part.rangeOf("thickness") || [0, 1];
    const width = (this.across.parentNode.clientWidth || 330) * density,
      height = Math.min(width * 1.15, 400 * density);
    this.pixels = Math.min((0.92 * width) / (2 * frame.radius), (0.9 * height) / tall);
    this.drawAcross(frame, width, height);
    this.drawAlong(frame, width, height);
    if (this.chart) this.chart.update(this.series(frame));
  }

  eachPiece(lines, side, visit) {
    for (const line of lines)
      line.forEach((point, i) => {
        if (point.side === side) visit(point, line[(i + 1) % line.length]);
      });
  }

  colourOf(wall) {
    const [low, high] = this.range,
      share = (wall - low) / (high - low);
    return share === share ? cssOfWord(colourTables.wall[Math.round(255 * Math.max(0, Math.min(1, share)))]) : "#888";
  }

  /** Fills closed lines in the colours of the wall, from the outer side in; returns the points of the outer side. */
  stroke(context, lines, toPixel) {
    context.beginPath();
    for (const line of lines) {
      line.forEach((point) => context.lineTo(...toPixel(point)));
      context.closePath();
    }
    context.fillStyle = isDark() ? "#5a6b78" : "#c9d6df";
    context.fill("evenodd");
    context.save();
    context.clip("evenodd");
    const points = [];
    this.eachPiece(lines, outsideFaces, (point, next) => {
      const [from, to] = [toPixel(point), toPixel(next)];
      points.push({ ...point, at: from });
      context.lineWidth = 2.1 * this.pixels * point.wall;
      const colours = context.createLinearGradient(...from, ...to);
      [point, next].forEach((one, i) => colours.addColorStop(i, this.colourOf(one.wall)));
      context.strokeStyle = colours;
      strokeLine(context, from, to, 0.3);
    });
    context.restore();
    context.lineWidth = 1.2 * this.density;
    context.strokeStyle = cssColour("--ink");
    for (const side of [insideFaces, outsideFaces, rimFaces])
      this.eachPiece(lines, side, (point, next) => strokeLine(context, toPixel(point), toPixel(next)));
    return points;
  }

  drawAcross(frame, width, height) {
    const { film, state } = this.part,
      context = sized(this.across, width, height),
      cuts = cutAtHeight(frame, state.height),
      points = [];
    for (let copy = 0; copy < film.copies; ++copy) {
      const [a, b, c, d] = film.copy(copy);
      const placed = cuts.map((cut) =>
        cut.map((p) => ({ ...p, x: a * p.x + b * p.y, y: film.up * (c * p.x + d * p.y) })),
      );
      points.push(
        ...this.stroke(context, placed, (p) => [width / 2 + this.pixels * p.x, height / 2 - this.pixels * p.y]),
      );
    }
    this.rays(context, width / 2, height / 2, [[Math.cos, Math.sin].map((of) => of((state.angle * Math.PI) / 180))]);
    scaleLength(context, this.pixels, this.density);
    this.acrossShown = { canvas: this.across, points };
    const thin = this.markThinnest(context, points);
    const most = (of) => Math.max(...points.map(of)),
      size = `${fixed(2 * most((p) => p.x), 1)} x ${fixed(2 * most((p) => p.y), 1)} mm`,
      corner = cornerAngle(frame),
      over = corner == null ? "" : `, ${fixed(2 * most((p) => Math.hypot(p.x, p.y)), 1)} mm at the widest`;
    this.acrossLabel.textContent = thin
      ? `height ${fixed(state.height, 1)} mm: outside ${size}${over}; wall ${fixed(thin.wall, 2)} to ${fixed(
          most((p) => p.wall),
          2,
        )} mm, thinnest at ${fixed(this.angleAt(thin), 1)}°`
      : `height ${fixed(state.height, 1)} mm: no outer side`;
  }

  drawAlong(frame, width, height) {
    const { state, film } = this.part,
      context = sized(this.along, width, height),
      angle = (state.angle * Math.PI) / 180,
      middle = (frame.bottom + frame.top) / 2,
      points = [];
    for (const [turn, sign] of [
      [angle, 1],
      [angle + Math.PI, -1],
    ]) {
      const cuts = cutAtAngle(frame, turn);
      const toPixel = (p) => [width / 2 + sign * this.pixels * p.r, height / 2 - this.pixels * (p.z - middle)];
      for (const point of this.stroke(context, cuts, toPixel)) points.push({ ...point, turn });
    }
    const y = height / 2 - this.pixels * (frame.bottom + state.height - middle);
    this.rays(context, 0, y, [[1, 0]]);
    scaleLength(context, this.pixels, this.density);
    this.alongShown = { canvas: this.along, points, middle };
    const thin = this.markThinnest(context, points);
    const name =
      Math.abs(state.angle) < 0.05 || Math.abs(state.angle - this.degrees) < 0.05 ? "plane of symmetry, " : "";
    this.alongLabel.textContent = thin
      ? `${film.copies > 1 ? name : ""}angle ${fixed(state.angle, 1)}°: thinnest ${fixed(thin.wall, 2)} mm at height ${fixed(thin.z - frame.bottom, 1)} mm`
      : `angle ${fixed(state.angle, 1)}°: no outer side`;
  }

  rays(context, x, y, directions) {
    context.strokeStyle = cssColour("--soft");
    context.lineWidth = this.density;
    context.setLineDash([8 * this.density, 3 * this.density, 2 * this.density, 3 * this.density]);
    for (const [dx, dy] of directions) {
      const far = 4 * Math.max(context.canvas.width, context.canvas.height);
      context.beginPath();
      context.moveTo(x, y);
      context.lineTo(x + far * dx, y - far * dy);
      context.stroke();
    }
    context.setLineDash([]);
  }

  markThinnest(context, points) {
    const known = points.filter((point) => point.wall === point.wall);
    if (!known.length) return null;
    const thin = known.reduce((best, one) => (one.wall < best.wall - 1e-6 ? one : best));
    markPlace(context, ...thin.at, spaceFields.thickness.text(thin.wall), this.density);
    return thin;
  }

  angleAt({ x, y }) {
    const angle = (Math.atan2(y, x) * 180) / Math.PI;
    return angle < -1e-6 ? angle + 360 : Math.max(0, angle);
  }

  /** The wall at the point of the outer side nearest to the pointer. */
  tell(shown, event) {
    if (!shown || !shown.points.length) return;
    const [x, y] = pixelOf(shown.canvas, event),
      far = (point) => Math.hypot(point.at[0] - x, point.at[1] - y),
      near = shown.points.reduce((best, one) => (far(one) < far(best) ? one : best)),
      { frame, state } = this.part,
      angle = shown.canvas === this.along ? (near.turn * 180) / Math.PI : this.angleAt(near),
      height = shown.canvas === this.along ? near.z - frame.bottom : state.height;
    this.reading.textContent = `wall ${spaceFields.thickness.text(near.wall)} (angle ${fixed(angle % 360, 1)}°, height ${fixed(height, 1)} mm)`;
  }

  pickAngle(event) {
    const [x, y] = pixelOf(this.across, event),
      angle = Math.atan2(this.across.height / 2 - y, x - this.across.width / 2);
    this.part.state.angle = (this.part.film.folded(angle) * 180) / Math.PI;
    this.part.drawWall();
  }

  pickHeight(event) {
    const [, y] = pixelOf(this.along, event),
      { frame, state } = this.part;
    state.height = this.alongShown.middle - frame.bottom + (this.along.height / 2 - y) / this.pixels;
    this.part.drawWall();
  }
}
