#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "forming/solid/flow/flow_matrix.hpp"

namespace parison::flow {

/// What a step did.
struct SolidStep {
  bool accepted = false;  ///< otherwise the glass is as before
  double dt = 0;          ///< s
  double strain = 0;      ///< largest of a cell
  int factors = 0, solutions = 0;
  double volume_error = 0;           ///< of the worst cell, as a share of it
  std::vector<Vector3> tool_forces;  ///< on each tool, N
};

/// The volume of each cell, m3, by its mass and the density at its temperature.
Eigen::VectorXd volumes_by_mass(const Material& material, const SolidGlass& glass);
/// Masses, kg, that give the cells the volumes they have.
Eigen::VectorXd masses_by_volume(const Material& material, const HexMesh& mesh, const Eigen::VectorXd& temperature);

/// Moves the glass over a step `dt`, s: of second order, by the velocities on the configuration expected in its middle;
/// volumes are exact. Without velocities of a step before, those of the instant are found first, without tools.
/// `matrix` belongs to the mesh and the conditions of the problem.
SolidStep step_flow(const SolidProblem& problem, FlowMatrix& matrix, SolidGlass& glass, double dt);

/// The same of glass that remembers its stress, with the memory of the problem: its volume is elastic, no cell keeps
/// it. The temperatures are not used.
SolidStep step_cooling(const SolidProblem& problem, FlowMatrix& matrix, SolidGlass& glass, double dt);

/// What a step may do.
struct SolidStepLimits {
  double strain = 0.15;
  double landing = 2e-4;  ///< way of a point, m, that it would go beyond the tool that it lands on
  double growth = 1.5;    ///< on the step before
  double longest = 1;     ///< s; a first step without velocities has this length
};
/// The step, s, after the last one, by its velocities.
double propose_step(const SolidProblem& problem, const SolidGlass& glass, const SolidStepLimits& limits);
/// The largest rate of strain of a cell, sqrt(2/3 D:D), 1/s.
double strain_rate(const HexMesh& mesh, const Eigen::VectorXd& velocity);

}  // namespace parison::flow
