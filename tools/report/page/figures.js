// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of the report and bars of heat.

/** Series of some columns of all runs; one run colours its tools, several colour the runs and dash their tools. */
function seriesOf(runs, tableName, columns, scale = 1) {
  const series = [];
  for (const run of runs)
    columns.forEach(({ name, label, dash, colour }, i) => {
      const y = run.column(tableName, name);
      if (!y) return;
      const several = runs.length > 1;
      series.push({
        label: several ? `${run.name}: ${label}` : label,
        x: run.column(tableName, "time_s"),
        y: scale === 1 ? y : y.map((value) => scale * value),
        colour: several ? run.index : (colour ?? i),
        dash: several ? (dash ?? 0) + (colour ?? i) : dash,
      });
    });
  return series;
}

const toolsOf = (runs, tableName, ending) => [...new Set(runs.flatMap((run) => run.toolsWith(tableName, ending)))];

const toolColumns = (tools, ending) =>
  tools.map((tool, i) => ({ name: `${tool}_${ending}`, label: words(tool), colour: i }));

function toolsPart(runs, charts) {
  const tools = toolsOf(runs, "tools", "_surface_max_degC");
  const means = toolColumns(tools, "surface_mean_degC").map((column) => ({
    ...column,
    label: `${column.label}, mean`,
    dash: 1,
  }));
  const glass = [
    ["glass_mean_degC", "mean"],
    ["skin_mean_degC", "surface, mean"],
    ["skin_min_degC", "surface, coldest"],
  ];
  const probes = [...new Set(runs.flatMap((run) => probesOf(run)))];
  return part(
    "temperatures",
    "Temperatures and heat",
    element(
      "div",
      { class: "charts" },
      charts.chart({
        title: "Contact surfaces of the tools",
        note: runs.length > 1 ? "hottest place; the colour is that of the run" : "solid: hottest place, dashed: mean",
        yLabel: "temperature, °C",
        series: seriesOf(runs, "tools", [
          ...toolColumns(tools, "surface_max_degC").map((column) => ({ ...column, label: `${column.label}, hottest` })),
          ...(runs.length > 1 ? [] : means),
        ]),
      }),
      charts.chart({
        title: "Glass",
        yLabel: "temperature, °C",
        series: seriesOf(
          runs,
          "history",
          glass.map(([name, label], i) => ({ name, label, colour: i })),
        ),
      }),
      charts.chart({
        title: "Probes",
        yLabel: "temperature, °C",
        series: seriesOf(
          runs,
          "history",
          probes.map((name, i) => ({ name, label: words(name.replace(/_degC$/, "")), colour: i })),
        ),
      }),
      charts.chart({
        title: "Heat received by the tools",
        yLabel: "heat, kJ",
        series: seriesOf(runs, "tools", toolColumns(tools, "heat_received_J"), 1e-3),
      }),
    ),
    runs.some((run) => run.space)
      ? element("p", { class: "soft" }, "Curves of the tools end where the glass becomes a body in space.")
      : null,
    heatBars(runs),
  );
}

const probesOf = (run) =>
  run.history.names.filter(
    (name) => name.endsWith("_degC") && !["glass_mean_degC", "skin_mean_degC", "skin_min_degC"].includes(name),
  );

/** Heat into each tool at the end, or so far. */
function heatBars(runs) {
  const rows = [];
  for (const tool of toolsOf(runs, "tools", "_heat_received_J"))
    for (const run of runs) {
      const column = run.column("tools", `${tool}_heat_received_J`),
        known = run.summary.quantities[`heat_${tool}`] || {};
      if (column && column.length)
        rows.push({
          tool,
          run,
          heat: (known.value ?? column[column.length - 1]) / 1000,
          error: (known.error || 0) / 1000,
        });
    }
  const most = Math.max(...rows.map((row) => Math.abs(row.heat) + row.error));
  if (!rows.length || !(most > 0)) return null;
  const share = (value) => `${(100 * Math.max(0, value)) / most}%`;
  return element(
    "div",
    {},
    element("h3", {}, "Heat by tool"),
    element(
      "div",
      { class: "bars" },
      ...rows.flatMap(({ tool, run, heat, error }, i) => [
        element("span", {}, [words(tool), runs.length > 1 && run.name, run.short].filter(Boolean).join(", ")),
        element(
          "span",
          { class: "track" },
          element("span", {
            class: "bar",
            style: { display: "block", width: share(heat), background: seriesColour(runs.length > 1 ? run.index : i) },
          }),
          error > 0
            ? element("span", { class: "whisker", style: { left: share(heat - error), width: share(2 * error) } })
            : null,
        ),
        element("span", { class: "number" }, `${withError(heat, error)} kJ`),
      ]),
    ),
  );
}

/** ", height 95 mm": of a place along the outer side of a run's wall, as the container stands; empty where not known. */
function heightAlong(run) {
  const [arc, z] = ["arc_mm", "z_outer_mm"].map((name) => run.column("profile", name)),
    [heights, places] = ["height_mm", "z_mm"].map((name) => run.column("heights", name));
  if (!arc || !z || !heights || !places || heights.length < 2) return () => "";
  const last = heights.length - 1,
    up = Math.sign((heights[last] - heights[0]) / (places[last] - places[0]));
  return (x) => {
    const at = arc.reduce((best, value, i) => (Math.abs(value - x) < Math.abs(arc[best] - x) ? i : best), 0);
    return `, height ${figure(heights[0] + up * (z[at] - places[0]))} mm`;
  };
}

/** The wall of round glass; that of glass in space has its own parts. */
function wallPart(given, charts) {
  const all = given.filter((run) => !run.space);
  if (!all.length) return null;
  // The wall of a run that stopped on its way would stretch the scales of those that are whole.
  const whole = all.filter((run) => !run.short),
    runs = whole.length ? whole : all,
    left = all.filter((run) => !runs.includes(run) && run.heights);
  const over = (tableName, x, y, error) =>
    runs
      .map((run) => ({
        label: all.length > 1 ? run.name : "wall",
        x: run.column(tableName, x),
        y: run.column(tableName, y),
        error:
          error && run.column(tableName, error) && run.column(tableName, error).some(Number.isFinite)
            ? run.column(tableName, error)
            : null,
        colour: run.index,
      }))
      .filter((one) => one.x && one.y);
  const heights = over("heights", "height_mm", "thickness_mm", "error_mm"),
    along = over("profile", "arc_mm", "thickness_mm", "error_mm");
  const hasErrors = heights.some((one) => one.error);
  const note = hasErrors
    ? "band and bars: estimated error by the coarser runs"
    : "no error bars, since no coarser run is there: `parison resume DIR --error-bars` makes them";
  const sides = runs.flatMap((run) =>
    [
      ["outer", 0],
      ["inner", 1],
    ].map(([side, dash]) => ({
      label: `${all.length > 1 ? run.name + ": " : ""}${side} side`,
      x: run.column("profile", "arc_mm"),
      y: run.column("profile", `T_${side}_degC`),
      colour: runs.length > 1 ? run.index : dash,
      dash,
    })),
  );
  const readers = runs.map(heightAlong),
    alsoAt = (x) => readers.map((heightAt) => heightAt(x)).join("");
  const charted = [
    charts.chart({
      title: "Wall thickness over height",
      note,
      xLabel: "height as it stands, mm",
      yLabel: "thickness, mm",
      upright: true,
      height: 460,
      series: heights,
    }),
    element(
      "div",
      {},
      charts.chart({
        title: "Wall thickness along the outer side",
        note: "from the first rim or the axis",
        xLabel: "along the outer side, mm",
        yLabel: "thickness, mm",
        height: 230,
        alsoAt,
        series: along,
      }),
      charts.chart({
        title: "Temperature of the wall at the end",
        xLabel: "along the outer side, mm",
        yLabel: "temperature, °C",
        height: 230,
        alsoAt,
        series: sides,
      }),
    ),
  ];
  const notes = left.map((run) =>
    element("p", { class: "soft" }, `${run.name} is left out: its wall is that ${run.short}.`),
  );
  return charted[0] || charted[1].childElementCount
    ? part("wall", "Wall", element("div", { class: "charts" }, ...charted.filter((one) => one)), ...notes)
    : part("wall", "Wall", element("p", { class: "soft" }, wallAbsent(runs)));
}

function wallAbsent(runs) {
  const absent = runs.map((run) => run.summary.thickness.absent).find((sentence) => sentence);
  return absent || "The wall is measured when the run has come to its end.";
}

function balancePart(runs, charts) {
  const heat = [
    ["heat_to_tools_J", "to the tools"],
    ["heat_to_air_J", "to the air"],
    ["dissipation_J", "viscous heat"],
  ];
  return part(
    "balance",
    "Balance",
    element(
      "div",
      { class: "charts" },
      charts.chart({
        title: "Heat of the glass since the start",
        yLabel: "heat, kJ",
        series: seriesOf(
          runs,
          "history",
          heat.map(([name, label], i) => ({ name, label, colour: i })),
          1e-3,
        ),
      }),
      charts.chart({
        title: "Heat that no entry explains, of the heat lost",
        yLabel: "share",
        series: seriesOf(runs, "history", [{ name: "energy_imbalance", label: "energy" }]),
      }),
      charts.chart({
        title: "Volume of the glass, relative change",
        yLabel: "share",
        series: seriesOf(runs, "history", [{ name: "volume_change", label: "volume" }]),
      }),
      charts.chart({
        title: "Contact area",
        yLabel: "area, cm2",
        series: seriesOf(runs, "history", [{ name: "contact_area_mm2", label: "contact" }], 1e-2),
      }),
    ),
    workTable(runs),
  );
}
