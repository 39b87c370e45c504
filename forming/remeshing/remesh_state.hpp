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

/// Whether the quality of the glass mesh asks for a new one.
bool needs_remesh(const Scene& scene, const State& state);

/// The state at the start of stage `stage`: contacts with tools no longer in place open, stretches of the surface
/// named.
State start_stage(const Scene& scene, const State& state, Index stage);

/// What is wrong with a stretch that a stage names on the surface as it stands when the stage begins; empty where
/// nothing is.
std::string misplaced_boundary(const Scene& scene, const State& state, Index stage);

}  // namespace parison::forming
