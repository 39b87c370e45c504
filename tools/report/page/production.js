// SPDX-License-Identifier: GPL-3.0-or-later
// Production of one container after another: the tools to which a cycle settles.

/** A cycle with its numbers; every part of the kind that the page expects. */
class Production {
  constructor(json, buffer, index) {
    const cycle = isObject(json.cycle) ? json.cycle : {};
    Object.assign(this, { name: json.name, index, buffer, cycle, over_time: json.over_time, start_up: json.start_up });
    this.tools = Object.entries(isObject(cycle.tools) ? cycle.tools : {}).filter(([, tool]) => isObject(tool));
    this.runs = Array.isArray(cycle.forming_runs) ? cycle.forming_runs.length : 0;
  }

  column(tableName, name) {
    return columnOf(this[tableName], this.buffer, name);
  }
}

/** How well the state is known, and what is wrong with it. */
function productionNotes({ cycle, runs }) {
  const after = `${runs} forming run${runs === 1 ? "" : "s"}, a machine cycle of ${figure(cycle.cycle_s)} s`;
  const known = `settled, known to ${figure(cycle.uncertainty_K, 2)} K, ${after}`;
  const notes = [cycle.confirmed ? ["good", known] : ["bad", `not settled after ${after}`]];
  if (cycle.reason) notes.push(["bad", String(cycle.reason)]);
  for (const sentence of texts(cycle.not_possible)) notes.push(["bad", `no possible production: ${sentence}`]);
  return element("ul", { class: "notes" }, ...notes.map(([kind, text]) => element("li", { class: kind }, text)));
}

function productionTable({ tools }) {
  const powers = (tool) => Object.entries(isObject(tool.power_W) ? tool.power_W : {}).filter(([, power]) => power !== 0);
  const degrees = (value) => (Number.isFinite(value) ? value.toFixed(1) : "-");
  return table(
    [
      "tool",
      ...["lowest, °C", "mean, °C", "highest, °C", "hottest place, °C", "heat from glass, kJ"].map(number),
      number("mean power out, W"),
    ],
    tools.map(([name, tool]) => [
      words(name),
      ...["surface_min_degC", "surface_mean_degC", "surface_max_degC", "hottest_point_degC"].map((key) =>
        number(degrees(tool[key])),
      ),
      number(figure(tool.heat_received_J / 1000)),
      number(
        powers(tool)
          .map(([boundary, power]) => `${words(boundary)} ${figure(power, 3)}`)
          .join(", ") || "none",
      ),
    ]),
  );
}

/** Surfaces of all tools; one cycle colours its tools, several colour the cycles and dash their tools. */
function surfaceSeries(productions, tableName, x, endings) {
  const several = productions.length > 1;
  return productions.flatMap((one) =>
    one.tools.flatMap(([tool], i) =>
      endings.map(([ending, label], k) => ({
        label: `${several ? `${one.name}: ` : ""}${words(tool)}${label}`,
        x: one.column(tableName, x),
        y: one.column(tableName, `${tool}_${ending}`),
        colour: several ? one.index : i,
        dash: several ? i : k,
      })),
    ),
  );
}

const productionNote =
  "Temperatures are of the surface: its mean, lowest, mean and highest in the cycle, and its hottest place. Power is what " +
  "each boundary has to take away, as the mean of the cycle; that of a contact surface goes to the air.";

function productionPart(productions, charts) {
  if (!productions.length) return null;
  const several = productions.length > 1,
    mean = ["surface_mean_degC", several ? "" : ", mean"],
    hottest = ["surface_max_degC", ", hottest"];
  return part(
    "production",
    "Production",
    ...productions.flatMap((one) => [
      several ? element("h3", {}, one.name) : null,
      productionNotes(one),
      one.tools.length ? productionTable(one) : null,
    ]),
    productions.some((one) => one.tools.length) ? element("p", {}, element("small", {}, productionNote)) : null,
    element(
      "div",
      { class: "charts" },
      charts.chart({
        title: "Surfaces of the tools over the settled cycle",
        note: several ? "mean; the colour is that of the cycle" : "solid: mean, dashed: hottest place",
        yLabel: "temperature, °C",
        series: surfaceSeries(productions, "over_time", "time_s", several ? [mean] : [mean, hottest]),
      }),
      charts.chart({
        title: "Surfaces of the tools from the start on",
        note: "mean at the gob of each container",
        xLabel: "cycle",
        yLabel: "temperature, °C",
        series: surfaceSeries(productions, "start_up", "cycle", [mean]),
      }),
    ),
  );
}
