#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "forming/flow/problem.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/contact/penetration.hpp"

namespace parison::forming {

/// Steps no longer than this share of a stage's first step are accepted whatever the penetration.
inline constexpr double min_step_ratio = 0.1;

/// The start of a step, with what all its coupling iterations ask of the glass there, computed once. Refers to the
/// scene and the state.
struct StepStart {
  const Scene& scene;
  const State& state;
  double dt;                              ///< length of the step, s
  std::vector<bool> frozen;               ///< flags of cells that do not flow; empty where there are none
  std::vector<Penetration> penetrations;  ///< of glass nodes into active tools
  double max_penetration = 0;             ///< m
  std::optional<flow::TrappedAir> air;    ///< in sealed cavities; none where the stage vents them
  std::vector<double> air_amount;         ///< in each of its pockets: CavityAir::amount
};

StepStart step_start(const Scene& scene, const State& state, double dt);

}  // namespace parison::forming
