#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Edge lengths where nothing flows, of those where glass is meshed again and again: the first mesh serves the whole
/// run.
inline constexpr double static_edge_factor = 0.5;

/// Meshes every body of the scene and sets its start: time 0, first stage, uniform temperatures.
State initial_state(const Scene& scene);

/// Flags of the boundaries of a body's mesh that are symmetry axes or planes.
std::vector<bool> symmetry_boundaries(const Body& body, const core::Mesh& mesh);

/// Flags of the boundaries of a body that may touch others.
std::vector<bool> contact_boundaries(const Body& body, const core::Mesh& mesh);

/// The same for the boundaries of its profile.
std::vector<bool> contact_boundaries(const Body& body);

/// What a named boundary of the body's present mesh is; stretches named by a stage are contact boundaries.
BoundaryKind boundary_kind(const Body& body, const std::string& boundary);

/// The glass mesh with its nodes where the mass was last distributed.
core::Mesh mass_mesh(const State& state);

/// Heat content of the glass, J, relative to thermal::content_reference.
double glass_heat(const Scene& scene, const State& state);

/// Body 0 is the glass, body 1 + i tool i.
const Body& body_of(const Scene& scene, Index body);

}  // namespace parison::forming
