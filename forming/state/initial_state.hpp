#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Edge lengths where nothing flows, of those where glass is meshed again and again: the first mesh serves the whole
/// run.
inline constexpr double static_edge_factor = 0.5;

/// Meshes every body of the scene and sets its start: time 0, first stage, the temperatures that the case gives.
State initial_state(const Scene& scene);

/// The temperatures that the case gives the glass at its start, on its present mesh.
void set_start_temperature(const Scene& scene, State& state);

/// The glass mesh with its nodes where the mass was last distributed.
core::Mesh mass_mesh(const GlassState& glass);
inline core::Mesh mass_mesh(const State& state) {
  return mass_mesh(state.glass);
}

/// Mass of the glass over its `density`, m3, as it was last distributed.
double relative_mass(const Scene& scene, const GlassState& glass);

/// The same of the density that glass in a mesh has at nodal temperatures, K.
double relative_mass(const Scene& scene, const core::Mesh& mesh, const Eigen::VectorXd& temperature);

/// Distributes the mass of `before` anew, by volume and the density at the temperatures of `glass`.
void distribute_mass(const Scene& scene, const GlassState& before, GlassState& glass);

/// Heat content of the glass, J, relative to thermal::content_reference.
double glass_heat(const Scene& scene, const State& state);

}  // namespace parison::forming
