// SPDX-License-Identifier: GPL-3.0-or-later
// Plots by uPlot: zoom by dragging, back by a double click, values under the pointer in the legend.

/** All plots of the page, with what they share. */
class Charts {
  constructor(stages, timePicked) {
    Object.assign(this, { stages, timePicked, time: null, plots: [] });
    this.observer = new ResizeObserver((entries) =>
      entries.forEach((entry) => this.fit(entry.target.plot, entry.contentRect.width)),
    );
  }

  destroy() {
    this.observer.disconnect();
    this.plots.forEach((plot) => plot.destroy());
    this.plots = [];
  }

  fit(plot, width) {
    if (plot && width > 0 && Math.abs(plot.width - width) > 1)
      plot.setSize({ width: Math.floor(width), height: plot.tall });
  }

  /** Where the film is: a line in the plots over time. */
  setTime(time) {
    this.time = time;
    this.plots.forEach((plot) => plot.overTime && plot.redraw(false, false));
  }

  redraw() {
    this.plots.forEach((plot) => plot.redraw(false, true));
  }

  /** `series` are {label, x, y, colour, dash, error, kind}, drawn as lines or by `kind` as "points" or "steps";
   * nothing where none has a value. With `upright` x goes up; `alsoAt` gives more to be read at an x. */
  chart({
    title,
    note,
    series,
    xLabel = "time, s",
    yLabel,
    upright = false,
    logarithmic = false,
    height = 300,
    alsoAt,
  }) {
    const shown = series.filter((one) => one.x && one.y && one.y.some(Number.isFinite));
    if (!shown.length) return null;
    const host = element("div"),
      overTime = xLabel.startsWith("time");
    const box = element(
      "div",
      { class: "chart" },
      element("h3", {}, title),
      note ? element("small", {}, note) : null,
      host,
    );
    const errors = shown.map((one) => (one.error ? new Map(Array.from(one.x, (x, i) => [x, one.error[i]])) : null));
    host.start = () => {
      const plot = new uPlot(
        this.options(host, { shown, errors, xLabel, yLabel, upright, logarithmic, height, overTime, alsoAt }),
        joined(shown),
        host,
      );
      Object.assign(plot, { tall: height, overTime });
      host.plot = plot;
      this.plots.push(plot);
      this.observer.observe(host);
      if (overTime)
        plot.over.addEventListener("click", () => {
          const at = plot.posToVal(plot.cursor.left, "x");
          if (Number.isFinite(at)) this.timePicked(at);
        });
    };
    /** Gives the series new values, by their labels. */
    box.update = (series) => {
      for (const one of shown) {
        const { x, y } = series.find(({ label }) => label === one.label) || { x: [], y: [] };
        Object.assign(one, { x, y });
      }
      if (host.plot) host.plot.setData(joined(shown));
    };
    this.waiting = [...(this.waiting || []), host];
    return box;
  }

  /** Plots know their width once they are in the page. */
  start() {
    (this.waiting || []).forEach((host) => host.start());
    this.waiting = [];
  }

  options(host, { shown, errors, xLabel, yLabel, upright, logarithmic, height, overTime, alsoAt }) {
    const room = (plot, values) => 14 + 7 * Math.max(3, ...(values || []).map((text) => text.length));
    const axis = (label, side, size) => ({
      label,
      side,
      size,
      labelSize: 22,
      gap: 4,
      labelGap: 0,
      stroke: () => cssColour("--ink"),
      grid: { stroke: () => cssColour("--grid"), width: 1 },
      ticks: { stroke: () => cssColour("--line"), width: 1, size: 5 },
      font: "12px system-ui, sans-serif",
      labelFont: "12px system-ui, sans-serif",
    });
    const axes = upright ? [axis(xLabel, 3, room), axis(yLabel, 2, 34)] : [axis(xLabel, 2, 34), axis(yLabel, 3, room)];
    axes[1].values = (plot, splits) => splits.map((value) => (value == null ? "" : tickText(value)));
    if (logarithmic)
      axes[1].values = (plot, splits) =>
        splits.map((value) => (Number.isInteger(Math.log10(value)) ? value.toExponential(0) : ""));
    return {
      width: Math.max(200, Math.floor(host.clientWidth)),
      height,
      axes,
      scales: {
        x: { time: false, ori: upright ? 1 : 0 },
        y: { ori: upright ? 0 : 1, distr: logarithmic ? 3 : 1, range: logarithmic ? undefined : rangeWith(shown) },
      },
      cursor: {
        sync: overTime ? { key: "time" } : undefined,
        drag: { x: true, y: true, uni: 20 },
        points: { size: 7 },
      },
      legend: {
        live: true,
        markers: { width: 3, dash: (plot, i) => ["solid", "dashed", "dotted", "double"][(shown[i - 1].dash || 0) % 4] },
      },
      series: [
        { label: xLabel, value: (plot, value) => (value == null ? "" : figure(value) + (alsoAt ? alsoAt(value) : "")) },
        ...shown.map((one, i) => ({
          label: one.label,
          stroke: () => seriesColour(one.colour),
          width: 2,
          dash: dashes[(one.dash || 0) % dashes.length],
          spanGaps: shown.length > 1,
          ...kindOf(one.kind),
          value: (plot, value, k, at) =>
            value == null || at == null ? "" : withError(value, errors[i] ? errors[i].get(plot.data[0][at]) : 0),
        })),
      ],
      hooks: {
        drawClear: [(plot) => overTime && drawStages(plot, this.stages)],
        draw: [
          (plot) => shown.forEach((one) => one.error && drawErrors(plot, one, upright)),
          (plot) => overTime && this.time != null && drawTime(plot, this.time),
        ],
      },
    };
  }
}

/** Series over all their x as uPlot takes them. */
const joined = (shown) =>
  uPlot.join(
    shown.map((one) => [Array.from(one.x), Array.from(one.y, (value) => (Number.isFinite(value) ? value : null))]),
  );

/** What makes points or steps of a line. */
function kindOf(kind) {
  if (kind === "points") return { paths: () => null, points: { show: true, size: 7, width: 2 } };
  return { points: { show: false }, ...(kind === "steps" ? { paths: uPlot.paths.stepped({ align: 1 }) } : {}) };
}

/** A round number in few characters. */
function tickText(value) {
  const rounded = Number(value.toPrecision(6)),
    size = Math.abs(rounded);
  return size !== 0 && (size < 1e-3 || size >= 1e6) ? rounded.toExponential() : String(rounded);
}

/** The range of all values with their errors and a little room. */
function rangeWith(shown) {
  return (plot, low, high) => {
    if (low == null) return [0, 1];
    const whole = plot.series.every((series, i) => i === 0 || series.show);
    if (whole && !plot.zoomed)
      for (const one of shown)
        if (one.error)
          one.y.forEach((value, i) => {
            if (value + one.error[i] > high) high = value + one.error[i];
            if (value - one.error[i] < low) low = value - one.error[i];
          });
    const room = (high - low || Math.abs(high) || 1) * 0.05;
    return [low >= 0 && low - room < 0 ? 0 : low - room, high + room];
  };
}

function withClip(plot, work) {
  const context = plot.ctx,
    { left, top, width, height } = plot.bbox;
  context.save();
  context.beginPath();
  context.rect(left, top, width, height);
  context.clip();
  work(context, left, top, width, height);
  context.restore();
}

/** Every other stage on a faint ground. */
function drawStages(plot, stages) {
  withClip(plot, (context, left, top, width, height) => {
    context.fillStyle = cssColour("--band");
    stages.forEach((stage, i) => {
      if (i % 2) return;
      const from = plot.valToPos(stage.start, "x", true),
        to = plot.valToPos(stage.end, "x", true);
      context.fillRect(from, top, to - from, height);
    });
  });
}

function drawTime(plot, time) {
  withClip(plot, (context, left, top, width, height) => {
    context.strokeStyle = cssColour("--soft");
    context.setLineDash([4, 4]);
    context.beginPath();
    const x = plot.valToPos(time, "x", true);
    context.moveTo(x, top);
    context.lineTo(x, top + height);
    context.stroke();
  });
}

/** Error bars as a band, and whiskers where they are far enough apart. */
function drawErrors(plot, { x, y, error, colour }, upright) {
  withClip(plot, (context) => {
    context.fillStyle = context.strokeStyle = seriesColour(colour);
    const at = (k, value) => {
      const a = plot.valToPos(x[k], "x", true),
        b = plot.valToPos(value, "y", true);
      return upright ? [b, a] : [a, b];
    };
    const runs = [];
    for (let k = 0, open = false; k < x.length; ++k) {
      const known = Number.isFinite(y[k]) && Number.isFinite(error[k]);
      if (known && !open) runs.push([]);
      if (known) runs[runs.length - 1].push(k);
      open = known;
    }
    context.globalAlpha = 0.22;
    for (const run of runs) {
      context.beginPath();
      run.forEach((k) => context.lineTo(...at(k, y[k] + error[k])));
      [...run].reverse().forEach((k) => context.lineTo(...at(k, y[k] - error[k])));
      context.fill();
    }
    context.globalAlpha = 0.8;
    context.beginPath();
    let last = -Infinity;
    for (const k of runs.flat()) {
      const place = at(k, y[k])[upright ? 1 : 0];
      if (Math.abs(place - last) < 18 * devicePixelRatio) continue;
      last = place;
      context.moveTo(...at(k, y[k] - error[k]));
      context.lineTo(...at(k, y[k] + error[k]));
    }
    context.stroke();
  });
}
