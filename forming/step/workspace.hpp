#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>

#include "forming/flow/solver.hpp"
#include "thermal/time/ida.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::forming {

/// Time integrator of a static stage, in which nothing moves, kept from step to step, and the data that it refers to.
struct StaticStage {
  Index stage = 0;                                   ///< index into Scene::stages
  std::vector<core::Mesh> meshes;                    ///< by body
  Eigen::VectorXd wall_thickness;                    ///< of the glass by node, m; empty where it limits no radiation
  std::optional<thermal::IdaIntegrator> integrator;  ///< its problem points to the two above
  long integrator_steps = 0;                         ///< since the integrator's start
  Index steps = 0;                                   ///< of the run since then
  bool expired = false;                              ///< the next step starts a new integrator
};

/// Solver data that is kept from step to step for speed. The result of a step depends on the state and the step size
/// alone, to the last bit, whatever the workspace contains. The one exception is `static_stage`: the history of its
/// integrator is no part of the state, so a checkpoint is written only when it has expired.
struct Workspace {
  std::optional<flow::Solver> flow;  ///< sparsity pattern and its analysis, for as long as the glass keeps its mesh
  thermal::StepMatrix heat;          ///< the same for heat; the factor is reused within a step only
  std::unique_ptr<StaticStage> static_stage;
  long clamped_lookups = 0;  ///< evaluations of the conductance outside its table, in the present step
};

}  // namespace parison::forming
