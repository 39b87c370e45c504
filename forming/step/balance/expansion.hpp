#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// How the glass changes its volume in a step because its temperature changes its density. Flow comes before heat: the
/// temperatures at the step's end are predicted, and what they are off is made good when they are known
/// (`conserve_mass`).
struct Expansion {
  Eigen::VectorXd end_temperature;  ///< by node, K; empty, as the rate, where density does not depend on temperature
  std::vector<double> rate;         ///< div v at each quadrature point of the cells, -(d rho/dt)/rho, 1/s
};

/// Whether the volume of the glass follows from its mass and its temperatures.
bool follows_density(const Scene& scene);

/// The expansion of a step of length dt that ends with such temperatures.
Expansion expansion_until(const Scene& scene, const State& state, Eigen::VectorXd end_temperature, double dt);

/// Volume that the mass in a mesh has at the mean density of the start, m3, by nodal temperatures, K: what is
/// conserved. That of the mesh itself where density does not depend on temperature.
double conserved_volume(const Scene& scene, const GlassState& glass, const core::Mesh& mesh,
                        const Eigen::VectorXd& temperature);

/// Means of div v less the expansion rate, 1/s. The flow makes the one over the volume zero, since the pressure is a
/// linear function; the mass is conserved where the other one is.
struct MeanDivergence {
  double of_volume, of_mass;
};

/// These of velocities by node on the midpoint mesh of a step.
MeanDivergence mean_divergence(const Scene& scene, const State& state, const core::Mesh& midpoint,
                               const Eigen::VectorXd& velocity, const Expansion& expansion);

}  // namespace parison::forming
