#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

struct RemeshedState {
  State state;
  bool ok = false;
  std::string reason;
};

/// The state on a new glass mesh. Volume and heat content are conserved to round-off; every other field follows its
/// transfer rule in `glass_fields`. Where no mesh can be made `ok` is false and `reason` a sentence.
RemeshedState remesh_state(const Scene& scene, const State& state, RemeshReason why);

/// Whether the worst cell of the glass mesh is below numerics.quality_floor.
bool needs_remesh(const Scene& scene, const State& state);

/// The state at the start of stage `stage`, an index into Scene::stages: contacts with tools that the stage removes are
/// released, fields follow their stage-start rule, and the boundaries that the stage names are assigned.
State start_stage(const Scene& scene, const State& state, Index stage);

/// A sentence where an end of a boundary that stage `stage` names does not lie on the present surface; empty otherwise.
std::string misplaced_boundary(const Scene& scene, const State& state, Index stage);

}  // namespace parison::forming
