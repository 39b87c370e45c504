#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/solid/hex_geometry.hpp"
#include "forming/solid/flow/solid_flow.hpp"
#include "forming/solid/flow/surface_loads.hpp"
#include "solid/boundary_faces.hpp"

namespace parison::tests {

using core::Index;
using core::Vector3;

/// Cells x by y by z of the image of the unit cube, mapped at all nodes.
inline core::HexMesh hex_block(Index x, Index y, Index z, const std::function<Vector3(const Vector3&)>& map) {
  core::HexMesh mesh;
  for (Index k = 0; k <= 2 * z; ++k)
    for (Index j = 0; j <= 2 * y; ++j)
      for (Index i = 0; i <= 2 * x; ++i) mesh.nodes.push_back(map({0.5 * i / x, 0.5 * j / y, 0.5 * k / z}));
  const auto node = [&](Index i, Index j, Index k) { return i + (2 * x + 1) * (j + (2 * y + 1) * k); };
  for (Index k = 0; k < z; ++k)
    for (Index j = 0; j < y; ++j)
      for (Index i = 0; i < x; ++i) {
        auto& cell = mesh.cells.emplace_back();
        for (int n = 0; n < 27; ++n) cell[n] = node(2 * i + n % 3, 2 * j + n / 3 % 3, 2 * k + n / 9);
      }
  return mesh;
}

/// Octant of a shell between two radii, m: three patches of n by n cells around the direction (1, 1, 1), which share
/// nodes; the third coordinate of the cells is the radius.
inline core::HexMesh octant(Index n, Index layers, const std::function<double(double)>& radius) {
  core::HexMesh mesh;
  const auto direction = [](int patch, double u, double v) {
    // Gnomonic square of a third of the octant: from an axis to the middle of two edges and of the face.
    const double a = std::tan(u * M_PI / 4), b = std::tan(v * M_PI / 4);
    Vector3 at = Vector3::Zero();
    at[patch] = 1;
    at[(patch + 1) % 3] = a;
    at[(patch + 2) % 3] = b;
    return at.normalized().eval();
  };
  std::vector<std::vector<Index>> column(3);  // of each patch's nodes, its first node
  std::vector<Vector3> directions;
  for (int patch = 0; patch < 3; ++patch)
    for (Index j = 0; j <= 2 * n; ++j)
      for (Index i = 0; i <= 2 * n; ++i) {
        const Vector3 d = direction(patch, 0.5 * i / n, 0.5 * j / n);
        Index found = 0;
        while (found < static_cast<Index>(directions.size()) && (directions[found] - d).norm() > 1e-9) ++found;
        if (found == static_cast<Index>(directions.size())) directions.push_back(d);
        column[patch].push_back(found);
      }
  for (Vector3& d : directions)
    for (int c = 0; c < 3; ++c)
      if (std::abs(d[c]) < 1e-12) d[c] = 0;
  const auto all = static_cast<Index>(directions.size());
  for (Index k = 0; k <= 2 * layers; ++k)
    for (const Vector3& d : directions) mesh.nodes.push_back(radius(0.5 * k / layers) * d);
  for (int patch = 0; patch < 3; ++patch)
    for (Index k = 0; k < layers; ++k)
      for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) {
          auto& cell = mesh.cells.emplace_back();
          for (int m = 0; m < 27; ++m)
            cell[m] = column[patch][2 * i + m % 3 + (2 * n + 1) * (2 * j + m / 3 % 3)] + all * (2 * k + m / 9);
        }
  return mesh;
}

/// Quarter of a round parison that hangs from a plane: a half ball below a tube, with layers from its inner side
/// outwards. `bottom` and `top`: heights of its lowest point and of the plane, m.
inline core::HexMesh round_parison(Index n, Index rows, Index layers, double radius, double wall, double bottom,
                                   double top) {
  using Quad = std::array<Index, 9>;
  const core::HexMesh ball = octant(n, 1, [](double s) { return 1 + s; });
  const Index sphere = ball.node_count() / 3;
  std::vector<Vector3> direction(ball.nodes.begin(), ball.nodes.begin() + sphere);
  std::vector<double> height(sphere, 0.0);  // of the share of the tube
  std::vector<Quad> quads;
  std::vector<std::pair<double, Index>> ring;
  for (Index k = 0; k < sphere; ++k)
    if (direction[k][2] == 0) ring.push_back({std::atan2(direction[k][1], direction[k][0]), k});
  std::sort(ring.begin(), ring.end());
  for (const auto& cell : ball.cells) {  // turned upside down below, so its sides change places
    Quad& quad = quads.emplace_back();
    for (int k = 0; k < 9; ++k) quad[k] = cell[k / 3 + 3 * (k % 3)];
  }
  const auto across = static_cast<Index>(ring.size());
  const auto at = [&](Index row, Index i) { return row == 0 ? ring[i].second : sphere + (row - 1) * across + i; };
  for (Index row = 1; row <= 2 * rows; ++row)
    for (Index i = 0; i < across; ++i) {
      direction.push_back(direction[at(0, i)]);
      height.push_back(0.5 * row / rows);
    }
  for (Index row = 0; row < rows; ++row)
    for (Index i = 0; i + 2 < across; i += 2) {
      Quad& quad = quads.emplace_back();
      for (int k = 0; k < 9; ++k) quad[k] = at(2 * row + k / 3, i + k % 3);
    }
  core::HexMesh mesh;
  const auto all = static_cast<Index>(direction.size());
  for (Index k = 0; k <= 2 * layers; ++k)
    for (Index s = 0; s < all; ++s) {
      const double r = radius - wall * (1 - 0.5 * k / layers);
      const Vector3 d(direction[s][0], direction[s][1], -direction[s][2]);
      mesh.nodes.push_back(r * d + Vector3(0, 0, bottom + radius + height[s] * (top - bottom - radius)));
    }
  for (const Quad& quad : quads)
    for (Index k = 0; k < layers; ++k) {
      auto& cell = mesh.cells.emplace_back();
      for (int m = 0; m < 27; ++m) cell[m] = quad[m % 9] + all * (2 * k + m / 9);
    }
  return mesh;
}

/// Nodes that satisfy something.
inline std::vector<Index> nodes_where(const core::HexMesh& mesh, const std::function<bool(const Vector3&)>& is_so) {
  std::vector<Index> nodes;
  for (Index n = 0; n < mesh.node_count(); ++n)
    if (is_so(mesh.nodes[n])) nodes.push_back(n);
  return nodes;
}

/// Nodes in the plane through the origin with this unit normal.
inline flow::SymmetryPlane plane_of(const core::HexMesh& mesh, const Vector3& normal) {
  return {normal, nodes_where(mesh, [&](const Vector3& x) { return std::abs(x.dot(normal)) < 1e-9; })};
}

/// Faces of the boundary all of whose nodes satisfy something.
inline std::vector<core::HexFace> faces_where(const core::HexMesh& mesh,
                                              const std::function<bool(const Vector3&)>& is_so) {
  std::vector<core::HexFace> faces;
  for (const auto& face : core::test::boundary_faces(mesh)) {
    bool all = true;
    for (const Index n : core::face_node_numbers(mesh, face)) all = all && is_so(mesh.nodes[n]);
    if (all) faces.push_back(face);
  }
  return faces;
}

/// A glass of one viscosity, Pa.s.
inline flow::Material uniform_glass(double viscosity) {
  flow::Material material{};
  material.density = 2500;
  material.viscosity.constant = viscosity;
  return material;
}

/// Glass at one temperature that fills a mesh.
inline flow::SolidGlass glass_of(core::HexMesh mesh, const flow::Material& material) {
  flow::SolidGlass glass;
  glass.temperature = Eigen::VectorXd::Constant(mesh.node_count(), 1300);
  glass.cell_mass = flow::masses_by_volume(material, mesh, glass.temperature);
  glass.mesh = std::move(mesh);
  return glass;
}

/// Velocities, three for each node, m/s, and pressures, four for each cell, Pa, of glass at an instant.
struct SolidVelocity {
  Eigen::VectorXd velocity, pressure;
  int solutions = 0;  ///< for the corrections of the pressure
};

/// Without tools; `expansion` is div v of each cell, 1/s.
inline SolidVelocity solve_instant(const flow::SolidProblem& problem, flow::FlowMatrix& matrix,
                                   const flow::SolidGlass& glass, double expansion = 0) {
  matrix.assemble(problem, glass.mesh, glass.temperature, Eigen::VectorXd::Zero(3 * glass.mesh.node_count()));
  matrix.factorise();
  const Eigen::VectorXd force = flow::pressure_forces(problem, glass.mesh) +
                                flow::surface_tension_forces(problem, glass.mesh) +
                                matrix.weight(problem.gravity, glass.cell_mass);
  Eigen::VectorXd wanted(4 * glass.mesh.cell_count());
  for (Index cell = 0; cell < glass.mesh.cell_count(); ++cell)
    wanted.segment<4>(4 * cell) = expansion * matrix.moment(cell);
  SolidVelocity result{{}, Eigen::VectorXd::Zero(wanted.size())};
  for (double first = 0, change = 1; change > 1e-10 * first && result.solutions < 30; ++result.solutions) {
    result.velocity = matrix.solve(force, result.pressure, wanted);
    const Eigen::VectorXd corrected = matrix.corrected_pressure(result.velocity, result.pressure, wanted);
    change = (corrected - result.pressure).norm();
    first = std::max({first, change, corrected.norm()});
    result.pressure = corrected;
  }
  return result;
}

}  // namespace parison::tests
