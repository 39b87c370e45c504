#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/cooling/glass_law.hpp"
#include "forming/flow/cells/memory.hpp"

namespace parison::cooling {

using core::Index;

/// What glass remembers, besides its temperature. Points: those of triangle_rule(4), cell by cell.
struct GlassMemory {
  Eigen::VectorXd stress;    ///< deviator, flow::SectionTensor of each branch of each point, Pa
  Eigen::VectorXd fictive;   ///< temperature of each branch of each point, K
  Eigen::VectorXd pressure;  ///< by node, that of a mid-side node the mean of its ends, Pa
};

/// Glass without stress and in equilibrium at its temperatures, by node, K.
GlassMemory at_rest(const core::Mesh& mesh, const Eigen::VectorXd& temperature);

/// A step that is known but for its strain.
struct MemoryStep {
  std::vector<Relaxation> relaxation;  ///< at each point
  flow::StressMemory flow;             ///< what the equilibrium needs of it
};
/// A step of dt, s, between temperatures by node, K.
MemoryStep start_step(const GlassLaw& law, const core::Mesh& mesh, const GlassMemory& memory,
                      const Eigen::VectorXd& before, const Eigen::VectorXd& after, double dt);
/// The memory at its end, by the strain at each point and the pressure at each vertex, Pa.
GlassMemory end_step(const MemoryStep& step, const GlassMemory& before, const core::Mesh& mesh,
                     const std::vector<flow::PointStrain>& strains, const Eigen::VectorXd& pressure);

/// Stress at each point, Pa, tension positive, from the stress and the pressure that glass remembers.
std::vector<flow::SectionTensor> stress_at_points(const core::Mesh& mesh, const Eigen::VectorXd& stress,
                                                  const Eigen::VectorXd& nodal_pressure);
/// Fictive temperature at each point, K: the mean over the branches of the law.
Eigen::VectorXd fictive_at_points(const GlassLaw& law, const Eigen::VectorXd& fictive);
}  // namespace parison::cooling
