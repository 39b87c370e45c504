#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "remesh/mesher/triangulate.hpp"

namespace parison::forming {

struct RemeshedState {
  State state;
  bool ok = false;
  std::string reason;
};

/// The state on a new glass mesh: geometry, heat content, velocity and contact carried over, the remesh accumulated.
RemeshedState remesh_state(const Scene& scene, const State& state, RemeshReason why,
                           const remesh::Mesher& mesher = remesh::triangulate);

/// The state at the start of stage `stage`, an index into Scene::stages: contacts with tools that the stage removes are
/// released, fields follow their stage-start rule, and the boundaries that the stage names are assigned.
State start_stage(const Scene& scene, const State& state, Index stage);

/// Brings the tools that first serve in a stage that cools under glass whose lowest place lies so far along gravity, m,
/// so that they touch it.
void place_under_glass(const Scene& scene, Index stage, double lowest, State& state);

}  // namespace parison::forming
