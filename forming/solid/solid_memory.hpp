#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/cooling/glass_law.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// Lets the glass remember from now on: without stress, its structure in equilibrium.
void begin_cooling(SolidState& solid);

/// Whether it does.
inline bool remembers(const SolidState& solid) {
  return solid.branch_stress.size() > 0;
}

/// A step that is known but for its strain.
struct SolidMemoryStep {
  std::vector<cooling::Relaxation> relaxation;  ///< at each point
  flow::SolidMemory flow;                       ///< what the balance of forces needs of it
};
/// A step of dt, s, of glass whose temperatures, K, by node, were `before` and are now those of the solid.
SolidMemoryStep start_memory_step(const cooling::GlassLaw& law, const SolidState& solid, const Eigen::VectorXd& before,
                                  double dt);
/// The memory at its end, by the velocities of the step on a mesh in its middle.
void end_memory_step(const SolidMemoryStep& step, const core::HexMesh& middle, double dt, SolidState& solid);

/// A tensor at each node in the columns, in the order of flow::tensor_entries.
using NodalTensors = Eigen::Matrix<double, flow::tensor_entries, Eigen::Dynamic>;
/// Stress, Pa, tension positive: through the wall the quadratic functions whose straight parts in the cells are nearest
/// to those found, the mean of the stacks of a node. A parabola through a wall comes back exactly.
NodalTensors nodal_stress(const SolidState& solid);
/// The largest principal stress, Pa.
double largest_principal(const Eigen::Matrix<double, flow::tensor_entries, 1>& stress);

}  // namespace parison::forming
