// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of the report, the timing of the machine, and bars of heat.

/** Series of some columns of all runs; one run colours its tools, several colour the runs and dash their tools. */
function seriesOf(runs, tableName, columns, scale = 1) {
  const series = [];
  for (const run of runs)
    columns.forEach(({ name, label, dash, colour }, i) => {
      const y = run.column(tableName, name);
      if (!y) return;
      const several = runs.length > 1;
      series.push({ label: several ? `${run.name}: ${label}` : label, x: run.column(tableName, "time_s"), y: scale === 1 ? y : y.map((value) => scale * value),
        colour: several ? run.index : (colour ?? i), dash: several ? (dash ?? 0) + (colour ?? i) : dash });
    });
  return series;
}

const toolsOf = (runs, tableName, ending) => [...new Set(runs.flatMap((run) => run.toolsWith(tableName, ending)))];

/** Tools whose position changes in some run. */
function movingTools(runs) {
  return toolsOf(runs, "history", "_position_mm").filter((tool) => runs.some((run) => {
    const places = run.column("history", `${tool}_position_mm`);
    return places && places.some((place) => Math.abs(place - places[0]) > 1e-6);
  }));
}

const toolColumns = (tools, ending) => tools.map((tool, i) => ({ name: `${tool}_${ending}`, label: words(tool), colour: i }));

function machinePart(runs, charts) {
  const moving = movingTools(runs);
  return part("machine", "Machine", ...runs.map((run) => ganttOf(run, runs.length > 1)), element("div", { class: "charts" },
    charts.chart({ title: "Force of the moving tools on the glass", note: "positive along +axis", yLabel: "force, kN", series: seriesOf(runs, "history", toolColumns(moving, "force_N"), 1e-3) }),
    charts.chart({ title: "Position of the moving tools", note: "offset from the drawn position along +axis", yLabel: "position, mm", series: seriesOf(runs, "history", toolColumns(moving, "position_mm")) })),
    moving.length ? null : element("p", { class: "soft" }, "No tool moves in this run."), stageTable(runs));
}

/** Which tools a stage has: by the case, or by what the outputs show. */
function toolsIn(run, stage) {
  if (stage.tools) return stage.tools;
  const frame = run.film && run.film.frames.find((one) => one.t > stage.start && one.t <= stage.end + 1e-9);
  return frame ? frame.tools.map(([tool]) => run.film.tools[tool].name) : [];
}

function ganttOf(run, named) {
  if (!run.stages.length || !(run.endTime > 0)) return null;
  const tools = [...new Set(run.stages.flatMap((stage) => toolsIn(run, stage)))], row = 22, width = Math.max(300, Math.min(900, window.innerWidth - 50)), left = width < 600 ? 84 : 110, end = run.stages[run.stages.length - 1].end || run.endTime;
  const x = (time) => left + ((width - left) * time) / end, height = row * (tools.length + 1) + 24;
  const picture = drawn("svg", { class: "gantt", viewBox: `0 0 ${width + 10} ${height}`, role: "img", "aria-label": "stages and active tools over time" });
  const block = (stage, line, colour, text) => {
    const from = x(stage.start), wide = Math.max(1, x(stage.end) - from - 1);
    picture.append(drawn("rect", { x: from, y: line * row + 2, width: wide, height: row - 5, rx: 3, fill: colour, opacity: text ? 0.25 : 0.7 },
      drawn("title", {}, `${words(stage.name)}: ${stage.start.toFixed(3)} to ${stage.end.toFixed(3)} s`)));
    if (text && wide > 7 * text.length) picture.append(drawn("text", { x: from + wide / 2, y: line * row + 15, "text-anchor": "middle" }, text));
  };
  picture.append(drawn("text", { x: 0, y: 15 }, "stages"));
  run.stages.forEach((stage) => block(stage, 0, cssColour("--accent"), words(stage.name)));
  tools.forEach((tool, i) => {
    picture.append(drawn("text", { x: 0, y: (i + 1) * row + 15 }, tool.length > left / 7 ? words(tool).slice(0, left / 7 - 1) + "…" : words(tool)));
    run.stages.forEach((stage) => toolsIn(run, stage).includes(tool) && block(stage, i + 1, seriesColour(i), ""));
  });
  const ticks = roundTimes(end, width / 75);
  ticks.forEach((time) => picture.append(drawn("text", { x: x(time), y: height - 6, "text-anchor": "middle" }, `${figure(time)} s`)));
  return element("div", { class: "wide" }, named ? element("h3", {}, run.name) : null, picture);
}

function roundTimes(end, most) {
  const step = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].find((one) => end / one <= most) || end;
  return Array.from({ length: Math.floor(end / step + 1e-9) + 1 }, (_, i) => i * step);
}

function toolsPart(runs, charts) {
  const tools = toolsOf(runs, "tools", "_surface_max_degC");
  const means = toolColumns(tools, "surface_mean_degC").map((column) => ({ ...column, label: `${column.label}, mean`, dash: 1 }));
  const glass = [["glass_mean_degC", "mean"], ["skin_mean_degC", "surface, mean"], ["skin_min_degC", "surface, coldest"]];
  const probes = [...new Set(runs.flatMap((run) => probesOf(run)))];
  return part("temperatures", "Temperatures and heat", element("div", { class: "charts" },
    charts.chart({ title: "Contact surfaces of the tools", note: runs.length > 1 ? "hottest place; the colour is that of the run" : "solid: hottest place, dashed: mean", yLabel: "temperature, °C",
      series: seriesOf(runs, "tools", [...toolColumns(tools, "surface_max_degC").map((column) => ({ ...column, label: `${column.label}, hottest` })), ...(runs.length > 1 ? [] : means)]) }),
    charts.chart({ title: "Glass", yLabel: "temperature, °C", series: seriesOf(runs, "history", glass.map(([name, label], i) => ({ name, label, colour: i }))) }),
    charts.chart({ title: "Probes", yLabel: "temperature, °C", series: seriesOf(runs, "history", probes.map((name, i) => ({ name, label: words(name.replace(/_degC$/, "")), colour: i }))) }),
    charts.chart({ title: "Heat received by the tools", yLabel: "heat, kJ", series: seriesOf(runs, "tools", toolColumns(tools, "heat_received_J"), 1e-3) })),
  heatBars(runs));
}

const probesOf = (run) => run.history.names.filter((name) => name.endsWith("_degC") && !["glass_mean_degC", "skin_mean_degC", "skin_min_degC"].includes(name));

/** Heat into each tool at the end, or so far. */
function heatBars(runs) {
  const rows = [];
  for (const tool of toolsOf(runs, "tools", "_heat_received_J"))
    for (const run of runs) {
      const column = run.column("tools", `${tool}_heat_received_J`), known = run.summary.quantities[`heat_${tool}`] || {};
      if (column && column.length) rows.push({ tool, run, heat: (known.value ?? column[column.length - 1]) / 1000, error: (known.error || 0) / 1000 });
    }
  const most = Math.max(...rows.map((row) => Math.abs(row.heat) + row.error));
  if (!rows.length || !(most > 0)) return null;
  const share = (value) => `${(100 * Math.max(0, value)) / most}%`;
  return element("div", {}, element("h3", {}, "Heat by tool"), element("div", { class: "bars" }, ...rows.flatMap(({ tool, run, heat, error }, i) => [
    element("span", {}, runs.length > 1 ? `${words(tool)}, ${run.name}` : words(tool)),
    element("span", { class: "track" }, element("span", { class: "bar", style: { display: "block", width: share(heat), background: seriesColour(runs.length > 1 ? run.index : i) } }),
      error > 0 ? element("span", { class: "whisker", style: { left: share(heat - error), width: share(2 * error) } }) : null),
    element("span", { class: "number" }, `${withError(heat, error)} kJ`)])));
}

function wallPart(runs, charts) {
  const over = (tableName, x, y, error) => runs.map((run) => ({ label: runs.length > 1 ? run.name : "wall", x: run.column(tableName, x), y: run.column(tableName, y),
    error: error && run.column(tableName, error) && run.column(tableName, error).some(Number.isFinite) ? run.column(tableName, error) : null, colour: run.index })).filter((one) => one.x && one.y);
  const heights = over("heights", "height_mm", "thickness_mm", "error_mm"), along = over("profile", "arc_mm", "thickness_mm", "error_mm");
  const hasErrors = heights.some((one) => one.error);
  const note = hasErrors ? "band and bars: estimated error by the coarser runs" : "no error bars: `parison run --error-bars` estimates them";
  const sides = runs.flatMap((run) => [["outer", 0], ["inner", 1]].map(([side, dash]) => ({ label: `${runs.length > 1 ? run.name + ": " : ""}${side} side`, x: run.column("profile", "arc_mm"),
    y: run.column("profile", `T_${side}_degC`), colour: runs.length > 1 ? run.index : dash, dash })));
  const charted = [charts.chart({ title: "Wall thickness over height", note, xLabel: "height as it stands, mm", yLabel: "thickness, mm", upright: true, height: 460, series: heights }),
    element("div", {}, charts.chart({ title: "Wall thickness along the outer side", note: "from the first rim or the axis", xLabel: "along the outer side, mm", yLabel: "thickness, mm", height: 230, series: along }),
      charts.chart({ title: "Temperature of the wall at the end", xLabel: "along the outer side, mm", yLabel: "temperature, °C", height: 230, series: sides }))];
  return charted[0] || charted[1].childElementCount ? part("wall", "Wall", element("div", { class: "charts" }, ...charted.filter((one) => one)))
    : part("wall", "Wall", element("p", { class: "soft" }, wallAbsent(runs)));
}

function wallAbsent(runs) {
  const absent = runs.map((run) => run.summary.thickness.absent).find((sentence) => sentence);
  return absent || "The wall is measured when the run has come to its end.";
}

function balancePart(runs, charts) {
  const heat = [["heat_to_tools_J", "to the tools"], ["heat_to_air_J", "to the air"], ["dissipation_J", "viscous heat"]];
  return part("balance", "Balance", element("div", { class: "charts" },
    charts.chart({ title: "Heat of the glass since the start", yLabel: "heat, kJ", series: seriesOf(runs, "history", heat.map(([name, label], i) => ({ name, label, colour: i })), 1e-3) }),
    charts.chart({ title: "Heat that no entry explains, of the heat lost", yLabel: "share", series: seriesOf(runs, "history", [{ name: "energy_imbalance", label: "energy" }]) }),
    charts.chart({ title: "Volume of the glass, relative change", yLabel: "share", series: seriesOf(runs, "history", [{ name: "volume_change", label: "volume" }]) }),
    charts.chart({ title: "Contact area", yLabel: "area, cm2", series: seriesOf(runs, "history", [{ name: "contact_area_mm2", label: "contact" }], 1e-2) })),
  workTable(runs));
}
