// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/cooling_seen.hpp"

#include <algorithm>
#include <cmath>

#include "forming/step/cooling/cooling_step.hpp"

namespace parison::forming {

namespace {

/// The largest principal stress of rr, zz, hoop, rz, Pa.
double largest_principal(const Eigen::Vector4d& stress) {
  const double mean = 0.5 * (stress[0] + stress[1]), half = 0.5 * (stress[0] - stress[1]);
  return std::max(stress[2], mean + std::hypot(half, stress[3]));
}

}  // namespace

void keep_larger(const SurfaceTension& now, SurfaceTension& largest) {
  if (now.stress > largest.stress) largest = now;
}

double CoolingSeen::sag(double height_now, double volume_now) const {
  return 1 - height_now / (height * std::cbrt(volume_now / volume));
}

SidesTension surface_tension(const State& state) {
  SidesTension tension;
  const Eigen::VectorXd stress = nodal_stress(state.glass, true);
  if (stress.size() == 0) return tension;
  const core::Mesh& mesh = state.glass.mesh;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    const core::MeshBoundary& boundary = mesh.boundaries()[edge.boundary_id];
    if (boundary.kind == BoundaryKind::symmetry) continue;
    for (const Index node : edge.nodes)
      keep_larger({largest_principal(stress.segment<4>(4 * node)), mesh.nodes[node], state.time},
                  boundary.name == inner_side ? tension.inner : tension.outer);
  }
  return tension;
}

void follow_cooling(const SidesTension& now, CoolingSeen& seen) {
  keep_larger(now.outer, seen.largest.outer);
  keep_larger(now.inner, seen.largest.inner);
}

}  // namespace parison::forming
