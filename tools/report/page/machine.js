// SPDX-License-Identifier: GPL-3.0-or-later
// What the machine did: stages and tools over time, force and position of the tools that move.

/** Tools whose position changes in some run. */
function movingTools(runs) {
  return toolsOf(runs, "history", "_position_mm").filter((tool) =>
    runs.some((run) => {
      const places = run.column("history", `${tool}_position_mm`);
      return places && places.some((place) => Math.abs(place - places[0]) > 1e-6);
    }),
  );
}

function machinePart(runs, charts) {
  const moving = movingTools(runs);
  return part(
    "machine",
    "Machine",
    ...runs.map((run) => ganttOf(run, runs.length > 1)),
    element(
      "div",
      { class: "charts" },
      charts.chart({
        title: "Force of the moving tools on the glass",
        note: "positive along +axis",
        yLabel: "force, kN",
        series: seriesOf(runs, "history", toolColumns(moving, "force_N"), 1e-3),
      }),
      charts.chart({
        title: "Position of the moving tools",
        note: "offset from the drawn position along +axis",
        yLabel: "position, mm",
        series: seriesOf(runs, "history", toolColumns(moving, "position_mm")),
      }),
    ),
    moving.length ? null : element("p", { class: "soft" }, "No tool moves in this run."),
    stageTable(runs),
  );
}

/** Which tools a stage has: by the case, or by what the outputs show. */
function toolsIn(run, stage) {
  if (stage.tools) return stage.tools;
  const frame = run.film && run.film.frames.find((one) => one.t > stage.start && one.t <= stage.end + 1e-9);
  return frame ? frame.tools.map(([tool]) => run.film.tools[tool].name) : [];
}

function ganttOf(run, named) {
  if (!run.stages.length || !(run.endTime > 0)) return null;
  const tools = [...new Set(run.stages.flatMap((stage) => toolsIn(run, stage)))],
    row = 22,
    width = Math.max(300, Math.min(900, window.innerWidth - 50)),
    left = width < 600 ? 84 : 110,
    end = run.stages[run.stages.length - 1].end || run.endTime;
  const x = (time) => left + ((width - left) * time) / end,
    height = row * (tools.length + 1) + 24;
  const picture = drawn("svg", {
    class: "gantt",
    viewBox: `0 0 ${width + 10} ${height}`,
    role: "img",
    "aria-label": "stages and active tools over time",
  });
  const block = (stage, line, colour, text) => {
    const from = x(stage.start),
      wide = Math.max(1, x(stage.end) - from - 1);
    picture.append(
      drawn(
        "rect",
        { x: from, y: line * row + 2, width: wide, height: row - 5, rx: 3, fill: colour, opacity: text ? 0.25 : 0.7 },
        drawn("title", {}, `${words(stage.name)}: ${stage.start.toFixed(3)} to ${stage.end.toFixed(3)} s`),
      ),
    );
    if (text && wide > 7 * text.length)
      picture.append(drawn("text", { x: from + wide / 2, y: line * row + 15, "text-anchor": "middle" }, text));
  };
  picture.append(drawn("text", { x: 0, y: 15 }, "stages"));
  run.stages.forEach((stage) => block(stage, 0, cssColour("--accent"), words(stage.name)));
  tools.forEach((tool, i) => {
    picture.append(
      drawn(
        "text",
        { x: 0, y: (i + 1) * row + 15 },
        tool.length > left / 7 ? words(tool).slice(0, left / 7 - 1) + "…" : words(tool),
      ),
    );
    run.stages.forEach((stage) => toolsIn(run, stage).includes(tool) && block(stage, i + 1, seriesColour(i), ""));
  });
  const ticks = roundTimes(end, width / 75);
  ticks.forEach((time) =>
    picture.append(drawn("text", { x: x(time), y: height - 6, "text-anchor": "middle" }, `${figure(time)} s`)),
  );
  return element("div", { class: "wide" }, named ? element("h3", {}, run.name) : null, picture);
}

function roundTimes(end, most) {
  const step =
    [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].find(
      (one) => end / one <= most,
    ) || end;
  return Array.from({ length: Math.floor(end / step + 1e-9) + 1 }, (_, i) => i * step);
}
