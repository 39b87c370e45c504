#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/mesh/element.hpp"
#include "core/mesh/interface_point.hpp"
#include "core/mesh/mesh.hpp"
#include "thermal/problem.hpp"

namespace parison::thermal::test {

using core::Index;
using core::Point;

enum Side : Index { bottom, right, top, left };

/// `count` divisions of [from, to], each `ratio` times as long as the one before.
inline std::vector<double> divide(double from, double to, int count, double ratio = 1) {
  std::vector<double> x{from};
  double sum = 0, length = 1, at = 0;
  for (int i = 0; i < count; ++i, length *= ratio) sum += length;
  length = 1;
  for (int i = 0; i < count; ++i, length *= ratio) x.push_back(from + (to - from) * (at += length / sum));
  x.back() = to;
  return x;
}

/// Rectangle on a grid, its sides the boundaries bottom, right, top, left.
inline core::Mesh rectangle(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<Point> vertices;
  std::vector<std::array<Index, 3>> triangles;
  const auto nx = static_cast<Index>(x.size());
  for (const double b : y)
    for (const double a : x) vertices.emplace_back(a, b);
  for (Index j = 0; j + 1 < static_cast<Index>(y.size()); ++j)
    for (Index i = 0; i + 1 < nx; ++i) {
      const Index a = j * nx + i, b = a + 1, c = b + nx, d = a + nx;
      if ((i + j) % 2) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      }
    }
  core::Mesh mesh = core::make_quadratic_mesh(vertices, triangles);
  mesh.edit().boundaries = {"bottom", "right", "top", "left"};
  for (core::BoundaryEdge& edge : mesh.edit().boundary_edges) {
    const Point along = mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]];
    const bool level = std::abs(along[0]) > std::abs(along[1]);
    edge.boundary_id = level ? (along[0] > 0 ? bottom : top) : (along[1] > 0 ? right : left);
  }
  return mesh;
}

inline BodyView body(const core::Mesh& mesh, const Material& material) {
  return {&mesh,
          &mesh,
          material.density,
          &material,
          std::vector<std::optional<SurfaceExchange>>(mesh.boundaries().size()),
          std::vector<std::optional<core::TimeFunction>>(mesh.boundaries().size())};
}

/// Nodal values of a function of position.
inline Eigen::VectorXd sample(const core::Mesh& mesh, const std::function<double(const Point&)>& f) {
  Eigen::VectorXd values(mesh.node_count());
  for (Index i = 0; i < mesh.node_count(); ++i) values[i] = f(mesh.nodes[i]);
  return values;
}

/// L2 norm of the difference between a field and a function, divided by the square root of the volume.
inline double distance(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& field,
                       const std::function<double(const Point&)>& f) {
  double sum = 0, volume = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (const auto& at : core::triangle_rule(6)) {
      const core::CellPoint point = core::map_cell_point(mesh, c, geometry, at);
      double value = 0;
      for (int i = 0; i < 6; ++i) value += point.shape[i] * field[mesh.cells()[c][i]];
      sum += point.volume * std::pow(value - f(point.position), 2);
      volume += point.volume;
    }
  return std::sqrt(sum / volume);
}

/// Interface between the bottom of a slave mesh and the top of a master mesh whose vertices match.
inline std::vector<core::InterfacePoint> stack(const core::Mesh& slave, const core::Mesh& master,
                                               core::Geometry geometry) {
  std::vector<core::InterfacePoint> points;
  for (const core::BoundaryEdge& edge : slave.boundary_edges()) {
    if (edge.boundary_id != bottom) continue;
    const auto faces = [&](const core::BoundaryEdge& other) {
      return other.boundary_id == top &&
             std::abs(master.nodes[other.nodes[2]][0] - slave.nodes[edge.nodes[2]][0]) < 1e-9;
    };
    const auto facing = std::find_if(master.boundary_edges().begin(), master.boundary_edges().end(), faces);
    for (const auto& at : core::edge_rule(3)) {
      const core::EdgePoint on = core::map_edge_point(slave, edge.nodes, geometry, at);
      points.push_back(
          {0, 1, edge.nodes, facing->nodes, on.shape, core::edge_shape(1 - at.s), on.position, on.area, 0, 1, 1e5, 0});
    }
  }
  return points;
}

/// A law of single points, for the whole interface.
inline InterfaceLaw pointwise(std::function<core::Conductance(const core::InterfacePoint&, double)> law) {
  return [law](double, const std::vector<core::InterfacePoint>& points, const InterfaceTemperatures& temperature,
               Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dT) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const core::Conductance value = law(points[i], temperature.slave[i]);
      h[i] = value.h;
      if (dh_dT) (*dh_dT)[i] = value.dh_dT;
    }
  };
}
inline InterfaceLaw constant_conductance(double h) {
  return pointwise([h](const core::InterfacePoint&, double) { return core::Conductance{h, 0}; });
}

}  // namespace parison::thermal::test
