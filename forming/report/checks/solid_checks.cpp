// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/checks/solid_checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/solid/hex_geometry.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/wall/solid_wall.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/solid/solid_step.hpp"

namespace parison::forming {

void add_solid_checks(const Scene& scene, const State& clock, const SolidState& solid, const RunFacts& facts,
                      Checks& checks) {
  constexpr double kept = 1e-6, lost = 1e-3;
  checks.push_back({"solid_volume", solid.totals.volume_error, kept, lost, "",
                    "a cell of the glass in space had another volume than its mass and temperature give it"});
  checks.push_back({"solid_heat", solid.totals.heat_imbalance / std::abs(solid.totals.start_heat), kept, lost, "",
                    "so much of the heat of the glass in space is explained by no surface"});
  constexpr double bearable = 1e-4, severe = 1e-3;  // m
  const SolidOverlap overlap = deepest_overlap(scene, clock, solid, clock.stage, SolidTools::all);
  checks.push_back({"solid_penetration", overlap.depth, bearable, severe, "mm",
                    fmt::format("the glass in space lies so deep in \"{}\" at ({:.1f}, {:.1f}, {:.1f}) mm; a smaller "
                                "numerics.surface_size helps",
                                overlap.tool < 0 ? "no tool" : scene.tools[overlap.tool].name, 1e3 * overlap.at[0],
                                1e3 * overlap.at[1], 1e3 * overlap.at[2]),
                    CheckKind::resolution});
  if (!facts.completed) return;
  const CoolingSeen& seen = facts.diagnostics.cooling;
  const bool cooled = seen.volume > 0;
  if (cooled) {
    const SolidExtent extent = extent_of(solid);
    add_sag_check(seen.sag(extent.high - extent.low, whole_volume(solid)), checks);
  }
  if (!scene.container || !scene.container->capacity) return;
  const double volume = cooled ? seen.volume : whole_volume(solid);
  const double drawn = *scene.container->capacity + scene.container->glass_volume - volume;
  add_capacity_check(cooled ? seen.capacity : solid_wall(solid).capacity, drawn, checks);
}

}  // namespace parison::forming
