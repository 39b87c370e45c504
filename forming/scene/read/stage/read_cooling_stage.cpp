// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

/// A part of a lehr of even surroundings.
struct Zone {
  double length, temperature, h;  // m, K, W/m2/K
};

/// ["6 m", "560 degC", "20 W/m2/K"].
Zone read_zone(const CaseNode& node) {
  const auto& parts = core::list(node);
  if (parts.size() != 3)
    core::refuse(node, fmt::format("{} values were found, allowed are the length of the zone, its temperature and its "
                                   "h, such as [\"6 m\", \"560 degC\", \"20 W/m2/K\"]",
                                   parts.size()));
  return {core::positive(parts[0], dimension::length), core::quantity(parts[1], dimension::temperature),
          core::not_negative(parts[2], dimension::conductance)};
}

/// Refuses glass that starts where it is solid: what stress it has there is not known.
void refuse_solid_start(const CaseNode& kind, const Scene& scene) {
  constexpr double solid = 1e13;  // Pa.s
  const double start = scene.glass.start_field ? scene.glass.start_field->min : scene.glass.initial_temperature;
  if (!scene.stages.empty() || scene.glass.annealing->log_equilibrium(start) < std::log(solid)) return;
  core::refuse(kind,
               fmt::format("\"cooling\" was found for glass that starts at {:.4g} degC with more than {:g} Pa.s, so "
                           "that its stress is not known; allowed is a start in softer glass",
                           start - core::zero_celsius, solid));
}

}  // namespace

void read_kind(const CaseTable& table, const Scene& scene, Stage& stage) {
  const auto* kind = table.find("kind");
  stage.cools = kind && core::choice(*kind, {"forming", "cooling"}) == 1;
  const auto* lehr = table.find("lehr");
  if (!stage.cools) {
    if (lehr) core::refuse(*lehr, "a lehr was found, allowed only in a stage of kind = \"cooling\"");
    if (!scene.stages.empty() && scene.stages.back().cools)
      core::refuse(kind ? *kind : table.get("name"),
                   "the stage forms glass that the stage before has cooled, allowed is kind = \"cooling\"");
    return;
  }
  if (!scene.has_heat() || !scene.has_flow())
    core::refuse(*kind, "\"cooling\" was found, allowed only where the glass carries heat and flows");
  if (scene.glass.flow->viscosity.constant)
    core::refuse(
        *kind,
        "\"cooling\" was found with a constant viscosity, which never sets; allowed are the laws vft, table and "
        "composition");
  if (!scene.glass.annealing)
    core::refuse(*kind,
                 "\"cooling\" was found and the material of the glass has no table annealing, allowed is one "
                 "with it, such as flint");
  refuse_solid_start(*kind, scene);
  for (const char* key : {"pressure", "motion", "trapped_air", "end_speed", "name_boundary"})
    if (const auto* item = table.find(key))
      core::refuse(*item, "found in a stage of kind = \"cooling\", allowed only where glass is formed");
}

void read_lehr(const CaseNode& node, const CaseTable& table, Stage& stage) {
  for (const char* key : {"duration", "from", "until", "air", "inner_air"})
    if (const auto* item = table.find(key))
      core::refuse(*item, "found beside a lehr, whose zones and belt speed say it; allowed is one of them");
  const CaseTable lehr(node, {"belt_speed", "zones"});
  const double speed = core::positive(lehr.get("belt_speed"), dimension::speed);
  const auto& zones = core::list(lehr.get("zones"));
  if (zones.empty()) core::refuse(lehr.get("zones"), "no zone was found, allowed is at least one");
  core::Table temperature, h;
  for (const CaseNode& item : zones) {
    const Zone zone = read_zone(item);
    const double middle = stage.duration + 0.5 * zone.length / speed;
    for (auto [table_of, value] : {std::pair(&temperature, zone.temperature), std::pair(&h, zone.h)}) {
      table_of->x.push_back(middle);
      table_of->y.push_back(value);
    }
    stage.duration += zone.length / speed;
  }
  stage.air.of_stage = true;
  stage.air.h = core::TimeFunction(h);
  stage.air.air_temperature = stage.air.ambient_temperature = core::TimeFunction(temperature);
}

}  // namespace parison::forming
