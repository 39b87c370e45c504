#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// What a swab of one tool leaves.
struct SwabbedTool {
  Eigen::VectorXd temperature;  ///< per node, K
  double heat = 0;              ///< given off by its contact surface, J
  std::string failure;          ///< why there is none; empty where there is
};

/// A tool from whose contact surface its swab takes the same heat from each place, J/m2, in the time that the swab
/// takes, while nothing else happens; from the uniform temperature with which it starts. `state` has its mesh.
SwabbedTool swabbed_tool(const Scene& scene, const State& state, Index tool);

}  // namespace parison::forming
