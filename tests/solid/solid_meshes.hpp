#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <vector>

#include "core/solid/cell_table.hpp"
#include "core/solid/prism_mesh.hpp"
#include "solid/boundary_faces.hpp"
#include "thermal/bodies.hpp"
#include "thermal/solid/solid_step.hpp"

namespace parison::thermal::test {

using core::Vector3;
using Map = std::function<Vector3(const Vector3&)>;

/// Sides of a block of hexahedra, boundary_id of its faces.
enum BlockSide : Index { x_low, x_high, y_low, y_high, z_low, z_high };

struct Block {
  core::HexMesh mesh;
  std::vector<core::QuadFace> faces;
};

/// The unit cube in cells, its nodes taken to where `map` says.
inline Block block(int nx, int ny, int nz, const Map& map) {
  Block made;
  const int lx = 2 * nx + 1, ly = 2 * ny + 1, lz = 2 * nz + 1;
  for (int k = 0; k < lz; ++k)
    for (int j = 0; j < ly; ++j)
      for (int i = 0; i < lx; ++i) made.mesh.nodes.push_back(map({0.5 * i / nx, 0.5 * j / ny, 0.5 * k / nz}));
  for (int c = 0; c < nx * ny * nz; ++c) {
    auto& cell = made.mesh.cells.emplace_back();
    const int i0 = 2 * (c % nx), j0 = 2 * (c / nx % ny), k0 = 2 * (c / (nx * ny));
    for (int n = 0; n < 27; ++n) cell[n] = (i0 + n % 3) + lx * ((j0 + n / 3 % 3) + ly * (k0 + n / 9));
  }
  for (const core::HexFace& face : core::test::boundary_faces(made.mesh))
    made.faces.push_back(core::quad_face(made.mesh, face, 2 * face.axis + face.end));
  return made;
}

/// Gives cells straight edges and flat middles: all nodes between vertices by interpolation.
inline void straighten(core::HexMesh& mesh) {
  for (const auto& cell : mesh.cells)
    for (int n = 0; n < 27; ++n) {
      Vector3 x = Vector3::Zero();
      for (int v = 0; v < 8; ++v) {
        double weight = 1;
        const std::array<double, 3> at{0.5 * (n % 3), 0.5 * (n / 3 % 3), 0.5 * (n / 9)};
        for (int a = 0; a < 3; ++a) weight *= (v >> a & 1) ? at[a] : 1 - at[a];
        if (weight > 0) x += weight * mesh.nodes[cell[2 * (v & 1) + 6 * (v >> 1 & 1) + 18 * (v >> 2 & 1)]];
      }
      mesh.nodes[cell[n]] = x;
    }
}
inline void straighten(core::PrismMesh& mesh) {
  constexpr std::array<std::array<int, 2>, 6> ends{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  for (const auto& cell : mesh.cells)
    for (int n = 0; n < 18; ++n) {
      const auto& [a, b] = ends[n % 6];
      const double up = 0.5 * (n / 6);
      const auto at = [&](int i) -> Vector3 { return (1 - up) * mesh.nodes[cell[i]] + up * mesh.nodes[cell[i + 12]]; };
      mesh.nodes[cell[n]] = 0.5 * (at(a) + at(b));
    }
}

/// Nodal values of a function of position.
inline Eigen::VectorXd sample(const std::vector<Vector3>& nodes, const std::function<double(const Vector3&)>& f) {
  Eigen::VectorXd values(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) values[static_cast<Index>(i)] = f(nodes[i]);
  return values;
}

template <typename Mesh>
Eigen::VectorXd masses(const Mesh& mesh, const core::CellTable& table, const Material& material) {
  return point_masses(mesh.nodes, core::cell_list(mesh, table), material,
                      Eigen::VectorXd::Constant(mesh.node_count(), 300));
}

inline SolidInterfaceLaw constant_solid_conductance(double value) {
  return [value](double, const std::vector<core::SolidInterfacePoint>&, const InterfaceTemperatures&, Eigen::ArrayXd& h,
                 Eigen::ArrayXd* dh_dT) {
    h.setConstant(value);
    if (dh_dT) dh_dT->setZero();
  };
}

/// One step as long as asked, whatever its error.
inline StepOptions one_step() {
  StepOptions options;
  options.tolerance = 1e30;
  return options;
}

/// The steady state: two steps without end, of which the second is returned.
inline StepOutcome settle(const SolidProblem& problem, std::vector<Eigen::VectorXd> temperature, double dt = 1e9) {
  SolidStepMatrix matrix;
  for (int step = 0; step < 2; ++step)
    temperature = advance(problem, 0, temperature, dt, one_step(), matrix).temperature;
  return advance(problem, 0, temperature, dt, one_step(), matrix);
}

}  // namespace parison::thermal::test
