// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "forming/report/checks/checks.hpp"
#include "forming/report/container/container_report.hpp"
#include "forming/scene/container/container_plan.hpp"

namespace parison::forming {

void add_capacity_checks(const Scene& scene, const State& state, const RunFacts& facts, Checks& checks) {
  if (!scene.container || !(scene.container->capacity || scene.container->outside)) return;
  const ContainerPlan& plan = *scene.container;
  checks.push_back({"drawn_volume", plan.doubt, most_doubt, most_doubt, "%",
                    "the volumes of mould and press differ by so much from those within chords of the same outlines; "
                    "neither the plunger's stop nor the capacity from the drawings is to be trusted"});
  if (!facts.completed || !plan.capacity) return;
  const auto formed = container_report(scene, state, true);
  if (!formed || !formed->capacity) return;
  constexpr double millilitre = 1e-6;
  checks.push_back(
      {"capacity", std::abs(*formed->capacity / *plan.capacity - 1), most_doubt, no_limit, "%",
       fmt::format("the formed glass holds {:.5g} ml, {:.5g} ml by the drawings: the glass does not fill its "
                   "mould, has sunk, or an outline is not the one that is meant",
                   *formed->capacity / millilitre, *plan.capacity / millilitre)});
}

}  // namespace parison::forming
