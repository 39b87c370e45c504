#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>

#include "forming/flow/solver.hpp"
#include "thermal/time/ida.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::forming {

/// What the solvers keep to be fast. A step's result is that of the state and its length to the last bit, whatever is
/// in here, but for `static_stage`: no checkpoint is written before that is spent.
struct Workspace {
  std::optional<flow::Solver> flow;  ///< pattern and its analysis, until the glass mesh is renewed
  thermal::StepMatrix heat;          ///< pattern and its analysis from step to step, the factor within one
  /// Heat of a stage in which nothing moves: the integrator with what it looks at, and its start.
  struct StaticStage {
    std::vector<core::Mesh> meshes;
    std::vector<Eigen::VectorXd> thickness;
    std::optional<thermal::IdaIntegrator> integrator;
    long inner_steps = 0;  ///< of the integrator since its start
    Index steps = 0;       ///< of the run
    bool expired = false;  ///< the next step makes a new one, so that nothing is lost with this one
    Index stage = -1;
  };
  std::unique_ptr<StaticStage> static_stage;
  long clamped_lookups = 0;
};

}  // namespace parison::forming
