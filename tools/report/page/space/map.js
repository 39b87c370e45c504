// SPDX-License-Identifier: GPL-3.0-or-later
// The wall unrolled: its thickness over angle and height, and the base from below.

const mapRoom = { left: 46, right: 12, top: 8, bottom: 40 }; // of the axes, in pixels of the page

class WallMap {
  constructor(part) {
    this.part = part;
    const canvas = (label, move, click) =>
      element("canvas", {
        role: "img",
        "aria-label": label,
        style: { cursor: "crosshair" },
        onpointermove: move,
        onclick: click,
        onpointerleave: () => (this.reading.textContent = ""),
      });
    this.canvas = canvas(
      "wall thickness over angle and height",
      (event) => this.tell(this.placeAt(event)),
      (event) => this.choose(this.placeAt(event)),
    );
    this.base = canvas("wall thickness of the base, from below", (event) => this.tellBase(event));
    this.reading = element("p", { class: "reading soft" });
    this.facts = element("p", {});
    this.scale = element("div", {});
    this.element = element(
      "div",
      {},
      this.facts,
      element(
        "div",
        { class: "unrolled" },
        element("div", { class: "screen" }, this.canvas),
        element("div", { class: "screen" }, this.base, element("small", { class: "soft" }, "the base, from below")),
      ),
      this.reading,
      element("div", { class: "panel legend" }, this.scale, tickOf(part, "all around", "around")),
      element("small", { class: "soft hint" }, "A click chooses height and angle of the sections."),
    );
  }

  /** Places of the map: degrees to pixels and heights to pixels, and back. */
  axes(width, height, density) {
    const { film, frame, state } = this.part,
      degrees = state.around ? 360 : (film.sector * 180) / Math.PI,
      tall = frame.top - frame.bottom,
      [left, top] = [mapRoom.left * density, mapRoom.top * density],
      wide = width - left - mapRoom.right * density,
      high = height - top - mapRoom.bottom * density;
    return {
      ...{ left, top, wide, high, degrees, tall },
      x: (angle) => left + (wide * angle) / degrees,
      y: (up) => top + high * (1 - up / tall),
      angle: (x) => ((x - left) / wide) * degrees,
      height: (y) => tall * (1 - (y - top) / high),
    };
  }

  draw() {
    const { frame } = this.part,
      wall = frame.values("thickness");
    if (!wall) return this.facts.replaceChildren("These outputs have no wall thickness.");
    this.frame = frame;
    this.density = Math.min(2, window.devicePixelRatio || 1);
    this.range = this.part.rangeOf("thickness");
    const width = (this.canvas.parentNode.clientWidth || 500) * this.density,
      height = 380 * this.density,
      context = sized(this.canvas, width, height);
    this.at = this.axes(width, height, this.density);
    this.raster = new Raster(Math.round(width), Math.round(height));
    this.fill(wall);
    const colours = colourTables.wall;
    context.putImageData(this.raster.image([null, { colours, low: this.range[0], high: this.range[1] }]), 0, 0);
    this.drawAxes(context);
    this.drawThinnest(context);
    this.drawBase();
    this.scale.replaceChildren(this.part.bar("thickness"));
  }

  /** The outer side, what is further in first: the heel hides the base. */
  fill(wall) {
    const { frame, at } = this,
      { film, mesh } = frame,
      triangles = mesh.triangles[outsideFaces],
      degrees = (film.sector * 180) / Math.PI,
      angles = Float32Array.from({ length: mesh.nodes }, (_, i) => frame.angleOf(frame.x[i], frame.y[i])),
      radius = (node) => Math.hypot(frame.x[node], frame.y[node]),
      order = Array.from({ length: triangles.length / 3 }, (_, i) => 3 * i);
    const reach = order.map((i) => radius(triangles[i]) + radius(triangles[i + 1]) + radius(triangles[i + 2]));
    order.sort((a, b) => reach[a / 3] - reach[b / 3]);
    for (let copy = 0; copy < (this.part.state.around ? film.copies : 1); ++copy)
      for (const i of order) {
        const nodes = triangles.subarray(i, i + 3);
        let turned = Array.from(nodes, (node) => angles[node]);
        if (Math.max(...turned) - Math.min(...turned) > 180)
          turned = turned.map((one) => (one < 180 ? one + 360 : one));
        const corners = turned.flatMap((angle, k) => [
          at.x(copy % 2 ? (copy + 1) * degrees - angle : copy * degrees + angle),
          at.y(frame.z[nodes[k]] - frame.bottom),
          wall[nodes[k]],
        ]);
        this.raster.triangle(...corners, 1);
      }
  }

  drawAxes(context) {
    const { at, density } = this;
    context.strokeStyle = context.fillStyle = cssColour("--ink");
    context.lineWidth = density;
    context.font = `${12 * density}px system-ui, sans-serif`;
    context.strokeRect(at.left, at.top, at.wide, at.high);
    context.textAlign = "center";
    for (let angle = 0; angle <= at.degrees + 1e-6; angle += at.degrees / 6) {
      context.fillRect(at.x(angle), at.top + at.high, density, 4 * density);
      context.fillText(
        `${figure(angle, 3)}°`,
        Math.min(at.x(angle), context.canvas.width - 14 * density),
        at.top + at.high + 17 * density,
      );
    }
    context.fillText("angle", at.left + at.wide / 2, at.top + at.high + 34 * density);
    context.textAlign = "right";
    const step = at.tall > 150 ? 50 : at.tall > 60 ? 20 : 10;
    for (let height = 0; height <= at.tall; height += step) {
      context.fillRect(at.left - 4 * density, at.y(height), 4 * density, density);
      context.fillText(String(height), at.left - 7 * density, at.y(height) + 4 * density);
    }
    context.save();
    context.translate(11 * density, at.top + at.high / 2);
    context.rotate(-Math.PI / 2);
    context.textAlign = "center";
    context.fillText("height, mm", 0, 0);
    context.restore();
    context.textAlign = "left";
    const { state, film } = this.part;
    context.setLineDash([6 * density, 4 * density]);
    context.beginPath();
    context.moveTo(at.left, at.y(state.height));
    context.lineTo(at.left + at.wide, at.y(state.height));
    context.moveTo(at.x(Math.min(state.angle, (film.sector * 180) / Math.PI)), at.top);
    context.lineTo(at.x(Math.min(state.angle, (film.sector * 180) / Math.PI)), at.top + at.high);
    context.stroke();
    context.setLineDash([]);
  }

  drawThinnest(context) {
    const thin = this.frame.extreme(),
      thick = this.frame.extreme(-1),
      where = (one) => `at ${fixed(one.angle, 1)}°, height ${fixed(one.height, 1)} mm`;
    markPlace(
      context,
      this.at.x(thin.angle),
      this.at.y(thin.height),
      spaceFields.thickness.text(thin.value),
      this.density,
    );
    this.facts.replaceChildren(
      element("strong", { class: "thinnest" }, `Thinnest ${spaceFields.thickness.text(thin.value)}`),
      ` ${where(thin)}; thickest ${spaceFields.thickness.text(thick.value)} ${where(thick)}; `,
      `mean ${spaceFields.thickness.text(this.part.film.meanWall(this.part.state.index))} by area. ${this.part.moment()}`,
    );
  }

  /** The base in plan, with the thinnest place where it lies there. */
  drawBase() {
    const { frame, part } = this,
      size = Math.min(380, this.base.parentNode.clientWidth || 300) * this.density;
    this.copies = Array.from({ length: part.film.copies }, (_, copy) => copy);
    this.below = new SpaceView([0, frame.radius, frame.bottom, frame.top], {
      width: size,
      height: size,
      azimuth: 0,
      tilt: -Math.PI / 2,
      pixels: (0.47 * size) / frame.radius,
    });
    const context = sized(this.base, size, size),
      options = { field: "thickness", range: this.range, copies: this.copies };
    spacePainter.paint(context, frame, this.below, options);
    scaleLength(context, this.below.pixels, this.density);
    const thin = frame.extreme(),
      [x, y, depth] = this.below.seen(thin.x, thin.y, thin.z),
      over = pointedAt(frame, this.below, this.copies, x, y);
    if (over && over.depth < depth + 0.3)
      markPlace(context, x, y, spaceFields.thickness.text(thin.value), this.density);
  }

  /** The place of the map under the pointer: {angle, height, wall}; nothing beside the wall. */
  placeAt(event) {
    if (!this.raster) return null;
    const [x, y] = pixelOf(this.canvas, event).map((one) => Math.floor(one) + 0.5),
      at = (y - 0.5) * this.raster.width + x - 0.5;
    if (!this.raster.bodies[at]) return null;
    return { angle: this.at.angle(x), height: this.at.height(y), wall: this.raster.values[at] };
  }

  tell(place) {
    this.reading.textContent = place
      ? `wall ${spaceFields.thickness.text(place.wall)} (angle ${fixed(place.angle, 1)}°, height ${fixed(place.height, 1)} mm)`
      : "";
  }

  choose(place) {
    if (!place) return;
    const { part } = this;
    part.state.height = place.height;
    part.state.angle = (part.film.folded((place.angle * Math.PI) / 180) * 180) / Math.PI;
    part.drawWall();
  }

  tellBase(event) {
    if (!this.below) return;
    const found = pointedAt(this.frame, this.below, this.copies, ...pixelOf(this.base, event));
    this.reading.textContent = spaceReading(this.frame, found);
  }
}
