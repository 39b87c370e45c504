#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene.hpp"
#include "forming/state.hpp"
#include "forming/workspace.hpp"

namespace parison::forming {

struct StepResult {
  State state;
  bool converged = false;
  std::string reason;
  StepReport report;
};

/// One staggered step of length dt: flow on the mid-step mesh, new positions, interface at the new positions, heat in all
/// bodies. The given state is left as it is; a step that failed is a dropped value.
StepResult coupled_step(const Scene& scene, const State& state, double dt, Workspace& workspace);

}  // namespace parison::forming
