// SPDX-License-Identifier: GPL-3.0-or-later
// The cold container, and its base as a polariscope with a tint plate shows it.

/** Light between crossed polarisers through a retardation, nm: what of red, green and blue passes, as a screen has it. */
function polarisedColour(retardation) {
  const passes = (wavelength) => Math.sin((Math.PI * retardation) / wavelength) ** 2;
  return [680, 545, 440].map((wavelength) => Math.round(255 * passes(wavelength) ** (1 / 2.2)));
}

/** Retardation, nm, at a distance from the axis, mm; none beyond the base. */
function retardationAt(base, radius) {
  const { r_mm: places, retardations_nm: values } = base;
  const last = places.length - 1;
  if (radius > places[last]) return null;
  const next = Math.max(
    1,
    places.findIndex((place) => place >= radius),
  );
  const share = Math.max(0, (radius - places[next - 1]) / (places[next] - places[next - 1]));
  return values[next - 1] + share * (values[next] - values[next - 1]);
}

/** Of a base that is not round, of which a half or a quarter between planes of symmetry is told: the retardation that it
 * adds at (x, y) mm along the diagonal x = y, nm, between the nearest places; none beyond the base. */
function alongDiagonal({ sector_deg: sector, x_mm: xs, y_mm: ys, on_diagonal_nm: values }, x, y) {
  const turned = (sector < 360 && y < 0) !== (sector < 180 && x < 0);
  const [px, py] = [sector < 180 ? Math.abs(x) : x, sector < 360 ? Math.abs(y) : y];
  let sum = 0;
  let weights = 0;
  let nearest = Infinity;
  for (let i = 0; i < xs.length; ++i) {
    const square = (xs[i] - px) ** 2 + (ys[i] - py) ** 2;
    const weight = 1 / (square + 1e-3) ** 2;
    sum += weight * values[i];
    weights += weight;
    nearest = Math.min(nearest, square);
  }
  const reach = 2.5; // mm
  return nearest > reach ** 2 ? null : (turned ? -sum : sum) / weights;
}

/** Whether a picture of the whole base can be made of what is told. */
const isWhole = ({ sector_deg: sector }) => !sector || [90, 180, 360].some((whole) => Math.abs(whole - sector) < 1e-6);

/** The base in the field of a tint plate of 565 nm, which adds to the retardation along one diagonal. */
function baseView(base, times) {
  const size = 280;
  const tint = 565;
  const canvas = element("canvas", { width: size, height: size, class: "polariscope" });
  const context = canvas.getContext("2d");
  const image = context.createImageData(size, size);
  const widest = base.r_mm ? base.r_mm[base.r_mm.length - 1] : Math.max(...base.x_mm.map((x, i) => Math.hypot(x, base.y_mm[i])));
  const scale = 1.15 * widest;
  for (let y = 0; y < size; ++y)
    for (let x = 0; x < size; ++x) {
      const dx = (2 * (x + 0.5)) / size - 1;
      const dy = 1 - (2 * (y + 0.5)) / size;
      const along = base.r_mm
        ? (retardationAt(base, scale * Math.hypot(dx, dy)) ?? 0) * Math.sin(2 * Math.atan2(dy, dx))
        : (alongDiagonal(base, scale * dx, scale * dy) ?? 0);
      const colour = polarisedColour(tint + times * along);
      image.data.set([...colour, 255], 4 * (y * size + x));
    }
  context.putImageData(image, 0, 0);
  const caption = times === 1 ? "as it is" : `retardation times ${times}`;
  return element("figure", {}, canvas, element("figcaption", { class: "soft" }, caption));
}

const tensionText = (one) => `${figure(one.MPa, 3)} MPa at (${figure(one.r_mm, 3)}, ${figure(one.z_mm, 4)}) mm`;

function coldRows({ cooling, container }) {
  const rows = [];
  const add = (label, hot, cold) => {
    if (hot != null && cold != null) rows.push([label, { number: figure(hot, 5) }, { number: figure(cold, 5) }]);
  };
  if (container) {
    add("capacity, ml", cooling.hot_capacity_ml, container.capacity_ml);
    add("height, mm", cooling.hot_height_mm, container.height_mm);
    add("diameter, mm", cooling.hot_diameter_mm, container.diameter_mm);
  }
  return rows;
}

function coldRun(run, several) {
  const { cooling } = run.summary;
  const { base } = cooling;
  const pictured = base && isWhole(base);
  const sentences = [
    `Tension left: outside ${tensionText(cooling.residual_outer)}, inside ${tensionText(cooling.residual_inner)}.`,
    `Largest while cooling: outside ${tensionText(cooling.largest_outer)}, inside ${tensionText(cooling.largest_inner)}.`,
  ];
  if (base)
    sentences.push(
      `Real temper number ${figure(base.real_temper_number, 2)}, apparent ${figure(base.apparent_temper_number, 2)}: ` +
        `${figure(base.retardation_nm, 3)} nm at r = ${figure(base.at_r_mm, 3)} mm through ` +
        `${figure(base.thickness_mm, 3)} mm.${pictured ? " The base between crossed polarisers with a tint plate of 565 nm:" : ""}`,
    );
  const rows = coldRows(run.summary);
  return element(
    "div",
    {},
    several ? element("h3", {}, run.name) : null,
    rows.length ? table(["", "from the mould", "cold"], rows) : null,
    ...sentences.map((sentence) => element("p", {}, sentence)),
    pictured ? element("div", { class: "charts" }, baseView(base, 1), baseView(base, 10)) : null,
  );
}

/** Stress around and along the wall: its mean through the wall, and what is left of it on both sides. */
function stressCharts(runs, charts) {
  const parts = { mean: "mean", outer: "rest, outer side", middle: "rest, middle", inner: "rest, inner side" };
  const chart = (direction, title) =>
    charts.chart({
      title,
      note: "mean through the wall, and the rest that the wall balances in itself; tension is positive",
      xLabel: "along the outer side, mm",
      yLabel: "stress, MPa",
      alsoAt: (x) => runs.map((run) => heightAlong(run)(x)).join(""),
      series: runs.flatMap((run) =>
        Object.entries(parts)
          .map(([name, label], i) => ({
            label: runs.length > 1 ? `${run.name}: ${label}` : label,
            x: run.column("stress", "arc_mm"),
            y: run.column("stress", `${direction}_${name}_MPa`),
            colour: runs.length > 1 ? run.index : i,
            dash: runs.length > 1 ? i : 0,
          }))
          .filter((one) => one.x && one.y),
      ),
    });
  return element(
    "div",
    { class: "charts" },
    chart("hoop", "Residual stress around"),
    chart("meridional", "Residual stress along the wall"),
  );
}

function coldPart(runs, charts) {
  const cold = runs.filter((run) => run.summary && run.summary.cooling);
  return cold.length
    ? part("cold", "Cold container", ...cold.map((run) => coldRun(run, runs.length > 1)), stressCharts(cold, charts))
    : null;
}
