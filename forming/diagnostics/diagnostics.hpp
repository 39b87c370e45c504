#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <vector>

#include "forming/diagnostics/contact_skin.hpp"
#include "forming/diagnostics/cooling_seen.hpp"
#include "forming/diagnostics/extremes.hpp"
#include "forming/diagnostics/flow_work.hpp"
#include "forming/diagnostics/glass_in_tools.hpp"
#include "forming/diagnostics/light_samples.hpp"
#include "forming/diagnostics/solver_statistics.hpp"
#include "forming/diagnostics/table_excess.hpp"
#include "forming/diagnostics/temperature_bounds.hpp"

namespace parison::forming {

/// What a run has seen since the start: its checks, flags and solver statistics are made of it. Nothing that follows in
/// the run depends on it.
struct Diagnostics {
  std::vector<TemperatureBounds> bounds;  ///< by body
  std::vector<TablesExcess> tables;       ///< by body
  std::vector<ContactSkin> skins;         ///< by tool
  std::vector<double> peak_force;  ///< by tool, largest so far without sign while a force drove it or it moved, N
  Extremes extremes;
  HotGlass hot_glass;
  GlassInTools in_tools;
  FlowWork work;
  LightSamples light;
  CoolingSeen cooling;
  double max_drift = 0;          ///< of the glass volume at any step, relative to the start, without sign
  double off_axis = 0;           ///< largest correction of nodes beyond a line of symmetry in a step, m
  double max_flux_mismatch = 0;  ///< between heat out of the glass and into a tool at any step, relative
  long clamped_lookups = 0;      ///< evaluations of h outside its table
  SolverStatistics steps;
};

/// Makes room for that many tools.
void resize(Diagnostics& seen, std::size_t tools);

/// Of a run that has not yet made a step.
Diagnostics first_diagnostics(const Scene& scene, const State& start);

/// Adds a step that was accepted, from the state `before`.
void follow(const Scene& scene, const State& before, const StepResult& step, Diagnostics& seen);

/// Lists every value with its name, as visit_state does.
template <typename Visitor, typename Seen>
void visit_diagnostics(Visitor visit, Seen& seen) {
  for (std::size_t b = 0; b < seen.bounds.size(); ++b) {
    visit_bounds(visit.part(fmt::format("bounds_{}", b)), seen.bounds[b]);
    visit_tables(visit.part(fmt::format("tables_{}", b)), seen.tables[b]);
  }
  for (std::size_t t = 0; t < seen.skins.size(); ++t) visit_skin(visit.part(fmt::format("skin_{}", t)), seen.skins[t]);
  visit("peak_force", seen.peak_force);
  visit_extremes(visit.part("extremes"), seen.extremes);
  visit_hot_glass(visit.part("hot_glass"), seen.hot_glass);
  visit_glass_in_tools(visit.part("in_tools"), seen.in_tools);
  visit_flow_work(visit.part("work"), seen.work);
  visit_light_samples(visit.part("light"), seen.light);
  visit_cooling(visit.part("cooling"), seen.cooling);
  visit("max_drift", seen.max_drift);
  visit("off_axis", seen.off_axis);
  visit("max_flux_mismatch", seen.max_flux_mismatch);
  visit("clamped_lookups", seen.clamped_lookups);
  visit_statistics(visit.part("steps"), seen.steps);
}

}  // namespace parison::forming
