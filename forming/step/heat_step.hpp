#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/interface_point.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/workspace.hpp"

namespace parison::forming {

struct HeatOutcome {
  bool converged = false;
  std::string reason;
  int substeps = 0;
};

/// Advances the temperatures of all bodies by dt at their present positions and accumulates the balance in the state's
/// totals; `dissipation` in W at the glass quadrature points (empty: none).
HeatOutcome advance_heat(const Scene& scene, State& state, const std::vector<core::InterfacePoint>& interface,
                         const std::vector<double>& dissipation, double dt, Workspace& workspace);

}  // namespace parison::forming
