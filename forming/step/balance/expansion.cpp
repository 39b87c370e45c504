// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/balance/expansion.hpp"

#include <cmath>
#include <utility>

#include "forming/flow/cells/expansion.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {

bool follows_density(const Scene& scene) {
  return scene.has_flow() && scene.expands();
}

Expansion expansion_until(const Scene& scene, const State& state, Eigen::VectorXd end_temperature, double dt) {
  Expansion expansion;
  if (!follows_density(scene)) return expansion;
  const auto& shapes = core::cell_shapes<6>().value;
  const core::Table density = scene.glass.relative_density();
  const auto& cells = state.glass.mesh.cells();
  expansion.rate.reserve(cells.size() * core::cell_points);
  for (const auto& cell : cells)
    for (int q = 0; q < core::cell_points; ++q) {
      double before = 0, after = 0;
      for (int i = 0; i < 6; ++i) {
        before += shapes(q, i) * state.glass.temperature[cell[i]];
        after += shapes(q, i) * end_temperature[cell[i]];
      }
      expansion.rate.push_back(std::log(density(before) / density(after)) / dt);
    }
  expansion.end_temperature = std::move(end_temperature);
  return expansion;
}

double conserved_volume(const Scene& scene, const GlassState& glass, const core::Mesh& mesh,
                        const Eigen::VectorXd& temperature) {
  if (!follows_density(scene)) return core::volume(mesh, scene.geometry);
  const double mass = scene.glass.density() * relative_mass(scene, mesh, temperature);
  return glass.initial_volume * (mass / glass.mass);
}

MeanDivergence mean_divergence(const Scene& scene, const State& state, const core::Mesh& midpoint,
                               const Eigen::VectorXd& velocity, const Expansion& expansion) {
  const auto& shapes = core::cell_shapes<6>().value;
  const core::Table density = scene.glass.relative_density();
  const auto geometry = flow::cell_geometry(midpoint, scene.geometry);
  double volume = 0, mass = 0, volume_gain = 0, mass_gain = 0;
  for (Index cell = 0; cell < geometry.cells; ++cell)
    for (int q = 0; q < core::cell_points; ++q) {
      double temperature = 0;
      for (int i = 0; i < 6; ++i) {
        const Index node = midpoint.cells()[cell][i];
        temperature += 0.5 * shapes(q, i) * (state.glass.temperature[node] + expansion.end_temperature[node]);
      }
      const double here = geometry.at(cell / core::batch_size, q).volume[cell % core::batch_size];
      const double excess =
          flow::divergence(midpoint, geometry, cell, q, velocity) - expansion.rate[cell * core::cell_points + q];
      const double weight = here * density(temperature);
      volume += here, mass += weight;
      volume_gain += here * excess, mass_gain += weight * excess;
    }
  return {volume_gain / volume, mass_gain / mass};
}

}  // namespace parison::forming
