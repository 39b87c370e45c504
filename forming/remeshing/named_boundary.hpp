#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Gives the edges that a stage names a boundary of their own: those between two points, or those that a tool touched.
/// `state` is the end of the stage before.
void name_boundary(const Scene& scene, const State& state, const NamedBoundary& named, core::Mesh& mesh);

/// Why a boundary that a stage names cannot be found on the glass, a sentence; empty where all can.
std::string misplaced_boundary(const Scene& scene, const State& state, Index stage);

}  // namespace parison::forming
