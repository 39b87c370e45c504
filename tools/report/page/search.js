// SPDX-License-Identifier: GPL-3.0-or-later
// The course of the search that found the runs of the page: the goal, and the variables between their bounds.

function courseChart(search, charts) {
  const at = search.values.map((_, i) => i + 1);
  const where = (holds) => search.values.map((value, i) => (search.holds[i] === holds ? value : NaN));
  return charts.chart({
    title: "Goal over the runs",
    note: `${search.values.length} runs, ${search.values.filter((value) => value === null).length} failed; it ended: ${search.ending}`,
    xLabel: "run",
    yLabel: search.sought,
    height: 320,
    series: [
      { label: "a run", x: at, y: where(true), colour: 0, kind: "points" },
      { label: "a run that misses a limit", x: at, y: where(false), colour: 1, kind: "points" },
      { label: "best so far", x: at, y: search.best, colour: 2, kind: "steps" },
      ...(search.good_enough > 0
        ? [{ label: "good enough", x: at, y: at.map(() => search.good_enough), colour: 3, dash: 1 }]
        : []),
    ],
  });
}

function variablesChart(search, charts) {
  return charts.chart({
    title: "Variables over the runs",
    note: "0: lower bound, 1: upper bound",
    xLabel: "run",
    yLabel: "share of the way between the bounds",
    height: 320,
    series: search.variables.map((one, i) => ({
      label: one.key,
      x: one.share.map((_, k) => k + 1),
      y: one.share,
      colour: i % 6,
      dash: Math.floor(i / 6),
    })),
  });
}

function searchPart(search, charts) {
  if (!search) return null;
  const plots = [courseChart(search, charts), variablesChart(search, charts)].filter((one) => one);
  return part(
    "search",
    "Search",
    element("div", { class: "charts" }, ...plots),
    table(
      ["variable", "start", "answer", "bounds", ""],
      search.variables.map((one) => [
        one.key,
        number(figure(one.start)),
        number(figure(one.answer)),
        `${figure(one.from)} to ${figure(one.to)}`,
        one.unit,
      ]),
    ),
  );
}
