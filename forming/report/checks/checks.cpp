// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/checks/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/numbers.hpp"
#include "forming/diagnostics/table_excess.hpp"
#include "forming/diagnostics/temperature_bounds.hpp"
#include "forming/report/container/container_report.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/step/balance/work.hpp"
#include "forming/step/cooling/cooling_step.hpp"

namespace parison::forming {

void add_capacity_check(double capacity, double drawn, Checks& checks) {
  checks.push_back({"capacity", std::abs(capacity / drawn - 1), most_doubt, no_limit, "%",
                    fmt::format("the formed glass holds {:.5g} ml, {:.5g} ml by the drawings and its volume: the glass "
                                "does not fill its mould, has sunk, or an outline is not the one that is meant",
                                capacity / core::millilitre, drawn / core::millilitre)});
}

void add_capacity_checks(const Scene& scene, const State& state, const RunFacts& facts, Checks& checks) {
  if (!scene.container || !(scene.container->capacity || scene.container->outside)) return;
  const ContainerPlan& plan = *scene.container;
  checks.push_back({"drawn_volume", plan.doubt, most_doubt, most_doubt, "%",
                    "the volumes of mould and press differ by so much from those within chords of the same outlines; "
                    "neither the plunger's stop nor the capacity from the drawings is to be trusted"});
  if (!facts.completed || !plan.capacity || scene.solid) return;
  const auto formed = container_report(scene, state, true);
  if (!formed || !formed->capacity) return;
  const CoolingSeen& seen = facts.diagnostics.cooling;  // a container that has cooled since is judged as it was then
  const bool cooled = seen.capacity > 0;
  // Glass that shrinks sinks at its rim, and a little more of it stands higher: that is judged to the drawn rim.
  const double capacity = cooled ? seen.capacity : formed->to_drawn_rim.value_or(*formed->capacity);
  // What the glass lost of its volume in the mould, the capacity has gained.
  const double volume = cooled ? seen.volume : core::volume(state.glass.mesh, scene.geometry);
  const double drawn = *plan.capacity + state.glass.initial_volume - volume;
  add_capacity_check(capacity, drawn, checks);
}

void add_sag_check(double sag, Checks& checks) {
  constexpr double most = 5e-3;
  checks.push_back({"sag", std::abs(sag), most, no_limit, "%",
                    "after the mould the container became so much lower or higher than shrinkage makes it: it was "
                    "taken out too hot, its plate or its air are too hot, or it stood too long before it set"});
}

namespace {

/// Of a round container.
void add_sag_check(const Scene& scene, const State& state, const RunFacts& facts, Checks& checks) {
  const CoolingSeen& seen = facts.diagnostics.cooling;
  const bool is_cold = facts.completed && seen.height > 0 && remembers(state);
  const auto container = is_cold ? container_report(scene, state, true) : std::nullopt;
  if (!container || !(container->size.height > 0)) return;
  add_sag_check(seen.sag(container->size.height, core::volume(state.glass.mesh, scene.geometry)), checks);
}

}  // namespace

std::string hot_glass_text(const Scene& scene, const HotGlass& hottest) {
  if (!(hottest.above > told_excess)) return "";
  return fmt::format(
      "{:.0f} K above all that heats it, in {} at {:.4g} s, (r, z) = ({:.1f}, {:.1f}) mm; {:.2g} % of it more than "
      "{:g} K",
      hottest.above, scene.stages[hottest.stage].name, hottest.time, 1e3 * hottest.r, 1e3 * hottest.z,
      100 * hottest.volume_share, told_excess);
}

void add_hot_glass_check(const Scene& scene, const State& state, const HotGlass& hot, Checks& checks) {
  const double work = std::max(state.totals.work.dissipation, least_loss(scene, state));
  const std::string where = hot_glass_text(scene, hot);
  checks.push_back(
      {"hot_glass", hot.work != 0 ? hot.work / work : 0, 0.01, 0.1, "%",
       fmt::format("glass beside a chilled skin thinner than its cells was hotter than all that can heat it, and "
                   "forces are too low by about this{}; a smaller numerics.skin_size helps",
                   where.empty() ? "" : ": up to " + where),
       CheckKind::error});
}

namespace {

/// The property that is furthest from its table, and of which body.
struct Worst {
  TableExcess excess;
  std::string property = "a property", body = "any body";
};

void include(const TableExcess& excess, const char* property, const std::string& body, Worst& worst) {
  if (is_worse(excess.error, worst.excess.error)) worst = {excess, property, body};
}

void include(const TablesExcess& tables, const char* of_flow, const std::string& body, Worst& worst) {
  include(tables.conductivity, "the conductivity", body, worst);
  include(tables.heat_capacity, "the heat capacity", body, worst);
  include(tables.flow, of_flow, body, worst);
}

}  // namespace

void add_table_check(const Scene& scene, const std::vector<TablesExcess>& tables, Checks& checks) {
  if (!has_property_tables(scene)) return;
  Worst worst;
  for (std::size_t b = 0; b < tables.size(); ++b)
    include(tables[b], b == glass_body ? "the viscosity" : "the friction",
            b == glass_body ? "the glass" : body_of(scene, Index(b)).name, worst);
  checks.push_back({"property_tables", worst.excess.error, 0.02, 0.5, "%",
                    fmt::format("{} of {} may be wrong by about this, in the mean over the body or its surface when it "
                                "was worst: temperatures were beyond the table for {:.3g} s, by up to {:.3g} K; a "
                                "table over a wider range of temperatures helps",
                                worst.property, worst.body, worst.excess.seconds, worst.excess.furthest)});
}

Checks checks(const Scene& scene, const State& state, const RunFacts& facts) {
  Checks all;
  if (scene.has_heat()) add_heat_checks(scene, state, facts.diagnostics, all);
  if (scene.has_flow()) add_flow_checks(scene, state, facts, all);
  if (scene.has_heat() && scene.has_flow()) add_hot_glass_check(scene, state, facts.diagnostics.hot_glass, all);
  add_capacity_checks(scene, state, facts, all);
  add_sag_check(scene, state, facts, all);
  add_table_check(scene, facts.diagnostics.tables, all);
  return all;
}

std::string verdict_of_run(const Checks& checks, bool completed) {
  return (completed ? "" : "stopped before its end; until then ") + verdict_sentence(checks);
}

void add_checks(core::JsonWriter& json, const Checks& checks, bool completed) {
  json.add("trustworthy", trustworthy(checks));
  json.add("verdict", verdict_of_run(checks, completed));
  json.open_list("checks");
  for (const Check& check : checks) {
    json.open_object("");
    json.add("name", check.name);
    json.add("value", check.value);
    json.add("limit", check.limit);
    json.add("severe_limit", check.severe_limit);
    json.add("unit", check.unit);
    json.add("verdict", name_of(check.verdict()));
    json.add("sentence", check.sentence);
    json.close();
  }
  json.close();
}

}  // namespace parison::forming
