// SPDX-License-Identifier: GPL-3.0-or-later
// Tables and sentences of the report.

/** What the program calls a quantity in tables for people. */
const quantityLabel = (runs, name) => runs.map((run) => (run.labels || {})[name]).find((label) => label) || words(name);

/** What the best models were found to move: "-" where the run has them, "?" where it was not measured. */
const modelText = (one) => (one.model === 0 ? "-" : Number.isFinite(one.model) ? one.model.toPrecision(2) : "?");

/** The models of a run, and the best ones where they are others. */
const modelNames = (run) =>
  Object.entries(run.summary.models || {})
    .map(([part, { used, best }]) => `${part} ${used}${used === best ? "" : ` (best: ${best})`}`)
    .join(", ");

const unitText = (unit) => (unit === "degC" ? "°C" : unit === "of the arc" ? "" : unit);

function quantityPart(runs) {
  const of = (run) => run.summary.quantities,
    names = [...new Set(runs.flatMap((run) => Object.keys(of(run))))];
  if (!names.length)
    return part(
      "quantities",
      "Quantities",
      element("p", { class: "soft" }, "They are known when a run has come to its end."),
    );
  const bars = runs.some((run) => Object.values(of(run)).some((one) => one.error > 0));
  const note = bars
    ? "The figure behind ± is an estimated error from coarser runs; about nine of ten true errors are smaller."
    : "Errors were not estimated: `parison resume DIR --error-bars` does it for a finished run.";
  const headingOf = (run) => [runs.length > 1 ? run.name : "value", run.short].filter((text) => text).join(", ");
  return part(
    "quantities",
    "Quantities",
    table(
      ["quantity", ...runs.flatMap((run) => [headingOf(run), "model"].map(number)), "unit"],
      names.map((name) => {
        const known = runs.map((run) => of(run)[name]);
        return [
          quantityLabel(runs, name),
          ...known.flatMap((one) => (one ? [withError(one.value, one.error), modelText(one)] : ["-", "-"]).map(number)),
          unitText((known.find((one) => one) || {}).unit),
        ];
      }),
    ),
    element("p", {}, element("small", {}, note)),
    element("p", {}, element("small", {}, modelNote(runs))),
  );
}

/** What the columns of models mean. */
function modelNote(runs) {
  const models = [...new Set(runs.map(modelNames))].filter((text) => text);
  return `Model: ${models.join("; ") || "not told"}. Its column is what the best model moved such quantities at most where it was measured, - where the run has it, ? where it was not measured. What tolerances add, \`parison uncertainty\` shows.`;
}

/** What `parison compare` says of the other runs beside the first. */
function differencePart(differences) {
  if (!differences) return null;
  const { base, others } = differences,
    verdictClass = { real: "good", "within its error": "soft" };
  const tableOf = (one) => [
    element("h3", {}, `${one.run} against ${base}`),
    element("p", { class: "soft" }, one.settings),
    table(
      ["quantity", ...[base, one.run, "difference", "error bar", "model"].map(number), "unit", "verdict"],
      one.rows.map((row) => [
        row.quantity,
        ...[row.base, row.other, row.difference, row.bar, row.model].map(number),
        unitText(row.unit),
        element("span", { class: verdictClass[row.verdict] || "warn" }, row.verdict),
      ]),
    ),
    element("p", {}, element("small", {}, one.bars)),
  ];
  const reasonOf = (one) => [
    element("h3", {}, `${one.run} against ${base}`),
    element("p", { class: "warn" }, `The runs are not compared: ${one.reason}`),
  ];
  return part("differences", "Differences", ...others.flatMap((one) => (one.rows ? tableOf(one) : reasonOf(one))));
}

function factsOf(run) {
  const { glass, thickness, container, flags, complete } = run.summary,
    times = run.column("history", "time_s"),
    last = times ? times.length - 1 : -1;
  const now = (name) => {
    const column = run.column("history", name);
    return column && last >= 0 ? column[last] : NaN;
  };
  const range =
    !run.space && Number.isFinite(thickness.min_mm)
      ? `${[thickness.min_mm, thickness.mean_mm, thickness.max_mm].map((value) => value.toFixed(2)).join(" / ")} mm`
      : null;
  return [
    ["simulated", `${figure(run.endTime)} s`],
    ["glass", glass.mass_kg ? `${figure(1000 * glass.mass_kg)} g` : null],
    ["wall: least, mean, most", range],
    ...(run.space ? spaceFacts(run) : []),
    ["capacity to the rim", !run.space && container.capacity_ml ? `${figure(container.capacity_ml)} ml` : null],
    ["glass, mean", Number.isFinite(now("glass_mean_degC")) ? `${now("glass_mean_degC").toFixed(0)} °C` : null],
    ["heat to the tools", Math.abs(now("heat_to_tools_J")) > 0 ? `${figure(now("heat_to_tools_J") / 1000)} kJ` : null],
    ["flags of the process", complete ? String(flags.length) : null],
    ["accuracy", run.summary.accuracy],
  ].filter(([, text]) => text);
}

/** The container in space at the end, or as far as its run has come. */
function spaceFacts({ space, summary: { quantities } }) {
  const { summary } = space,
    last = space.times.length - 1,
    thin = space.at(last).extreme(),
    mean = space.meanWall(last),
    share = summary && summary["outer_within_0.2mm_of_tools"];
  const wall = (value, name) => {
    const error = (quantities[name] || {}).error;
    return `${error > 0 ? withError(value, error) : value.toFixed(2)} mm`;
  };
  return [
    [
      "thinnest wall",
      thin && `${wall(thin.value, "thickness_min")}, height ${fixed(thin.height, 1)} mm, ${fixed(thin.angle, 0)}°`,
    ],
    ["wall, mean by area", Number.isFinite(mean) ? wall(mean, "thickness_mean") : null],
    ["capacity to the rim", summary && summary.capacity_ml > 0 ? `${figure(summary.capacity_ml)} ml` : null],
    ["outside within 0.2 mm of tools", Number.isFinite(share) ? `${fixed(100 * share, 0)} %` : null],
  ];
}

/** What a reader should know first of a run: how it ended, what is wrong, what to do. */
function notesOf(run) {
  const { verdict, trustworthy, flags, warnings, checks, overrides } = run.summary,
    notes = [];
  if (run.told) notes.push([run.state === "running" ? "soft" : "bad", run.told]);
  for (const problem of run.problems || []) notes.push(["warn", problem]);
  if (verdict)
    notes.push([!trustworthy ? "bad" : checks.some((check) => check.verdict !== "inside") ? "warn" : "good", verdict]);
  for (const check of checks)
    if (check.verdict !== "inside")
      notes.push([
        check.verdict === "beyond" ? "warn" : "bad",
        `${words(check.name)} ${figure(check.value, 3)}, limit ${figure(check.limit, 3)}: ${check.sentence}`,
      ]);
  for (const flag of flags) notes.push(["warn", flag.sentence]);
  for (const warning of warnings) notes.push(["warn", warning]);
  if (overrides.length) notes.push(["soft", `set for this run: ${overrides.join(", ")}`]);
  for (const [film, what] of [
    [run.film, "the film"],
    [run.space, "the part on the container"],
  ])
    if (film && film.frames.length < film.outputs)
      notes.push(["soft", `${what} shows ${film.frames.length} of ${film.outputs} outputs, to keep the page small`]);
  if (run.space) notes.push(["soft", `the glass is a body in space from ${run.space.times[0].toFixed(2)} s on`]);
  return notes;
}

const stateClass = { completed: "good", running: "warn", stopped: "warn", failed: "bad", ended: "bad" };

function overviewPart(runs) {
  return part(
    "overview",
    "Overview",
    ...runs.map((run) =>
      element(
        "div",
        { style: { marginBottom: "0.75rem" } },
        element(
          "h3",
          {},
          element("span", { class: "mark", style: { background: seriesColour(run.index) } }),
          run.name,
          " ",
          element("span", { class: `state ${stateClass[run.state] || ""}` }, run.state),
        ),
        element(
          "dl",
          { class: "tiles" },
          ...factsOf(run).map(([name, text]) => element("div", {}, element("dt", {}, name), element("dd", {}, text))),
        ),
        element("ul", { class: "notes" }, ...notesOf(run).map(([kind, text]) => element("li", { class: kind }, text))),
      ),
    ),
  );
}

function stageTable(runs) {
  return element(
    "div",
    {},
    ...runs
      .filter((run) => run.stages.length)
      .map((run) =>
        element(
          "div",
          {},
          runs.length > 1 ? element("h3", {}, run.name) : null,
          table(
            ["stage", number("from, s"), number("to, s"), number("lasts, s"), "ended by", "tools"],
            run.stages.map((stage) => [
              words(stage.name),
              number(stage.start.toFixed(3)),
              number(stage.end.toFixed(3)),
              number((stage.end - stage.start).toFixed(3)),
              stage.ended_by || "-",
              toolsIn(run, stage).map(words).join(", "),
            ]),
          ),
        ),
      ),
  );
}

const workColumns = [
  ["tools_J", "by tools"],
  ["gravity_J", "by gravity"],
  ["air_J", "by air"],
  ["dissipation_J", "viscous"],
  ["friction_J", "friction"],
  ["impact_loss_J", "impacts"],
  ["surface_J", "surface"],
  ["correction_J", "corrections"],
];

function workTable(runs) {
  const rows = runs.flatMap((run) =>
    run.summary.stages.map((stage) => [
      runs.length > 1 ? `${run.name}: ${words(stage.name)}` : words(stage.name),
      ...workColumns.map(([key]) => number(figure(stage.work[key], 3))),
      number(`${figure(100 * stage.work.imbalance, 2)} %`),
    ]),
  );
  return rows.length
    ? element(
        "div",
        {},
        element("h3", {}, "Work on the glass since the start, at the end of each stage, J"),
        table(["stage", ...workColumns.map(([, label]) => number(label)), number("imbalance")], rows),
      )
    : null;
}

function checkPart(runs) {
  const tables = runs
    .filter((run) => run.summary.checks.length)
    .map((run) =>
      element(
        "details",
        { open: run.summary.checks.some((check) => check.verdict !== "inside") },
        element("summary", {}, `${run.name}: ${run.summary.verdict || "checks"}`),
        table(
          ["check", number("value"), number("limit"), number("severe"), "verdict", "what it means"],
          run.summary.checks.map((check) => [
            words(check.name),
            number(figure(check.value, 3)),
            number(figure(check.limit, 3)),
            number(figure(check.severe_limit, 3)),
            element("span", { class: { inside: "good", beyond: "warn" }[check.verdict] || "bad" }, check.verdict),
            check.sentence,
          ]),
        ),
      ),
    );
  return tables.length ? part("checks", "Checks", ...tables) : null;
}

function scenePart(runs) {
  return part(
    "scene",
    "Scene as understood",
    ...runs.map((run, i) =>
      element(
        "details",
        { open: i === 0 },
        element("summary", {}, run.name),
        run.scene
          ? element("pre", {}, run.scene)
          : element("p", { class: "warn" }, `The case could not be read again: ${run.scene_problem}`),
      ),
    ),
  );
}
