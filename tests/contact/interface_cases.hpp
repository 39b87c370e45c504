#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

#include "contact/mortar/mortar.hpp"
#include "core/mesh/element.hpp"
#include "core/mesh/mesh.hpp"

namespace parison::contact::testing {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double width = 5e-5;

inline std::vector<double> divided(double from, double to, int count) {
  std::vector<double> x;
  for (int i = 0; i <= count; ++i) x.push_back(from + (to - from) * i / count);
  return x;
}

/// Rectangle of straight quadratic triangles over the given columns, y in [low, high]; boundary 1 is the side at
/// `contact_y`.
inline core::Mesh rectangle(const std::vector<double>& columns, double low, double high, double contact_y,
                            int rows = 1) {
  std::vector<Point> vertices;
  std::vector<std::array<Index, 3>> triangles;
  const Index n = static_cast<Index>(columns.size());
  for (int j = 0; j <= rows; ++j)
    for (const double x : columns) vertices.push_back({x, j == rows ? high : low + (high - low) * j / rows});
  for (int j = 0; j < rows; ++j)
    for (Index i = 0; i + 1 < n; ++i) {
      const Index a = j * n + i, b = a + 1, c = a + n, d = c + 1;
      triangles.push_back({a, b, d});
      triangles.push_back({a, d, c});
    }
  core::Mesh mesh = core::make_quadratic_mesh(vertices, triangles);
  mesh.edit().boundaries.push_back("contact");
  for (auto& edge : mesh.edit().boundary_edges)
    if (mesh.nodes[edge.nodes[0]][1] == contact_y && mesh.nodes[edge.nodes[1]][1] == contact_y) edge.boundary_id = 1;
  return mesh;
}

/// Glass above the line y = 0 and tool below it.
inline core::Mesh glass(const std::vector<double>& columns, double height = 0.004) {
  return rectangle(columns, 0, height, 0);
}
inline core::Mesh tool(const std::vector<double>& columns, double height = 0.004) {
  return rectangle(columns, -height, 0, 0);
}

inline core::Mesh warped(core::Mesh mesh, const std::function<Point(const Point&)>& map) {
  for (auto& x : mesh.nodes) x = map(x);
  return mesh;
}

inline Surface contact_surface(Index body, const core::Mesh& mesh) {
  return make_surface(body, mesh, {false, true}, Point::Zero());
}

/// What the slave's nodes know, indexed like its mesh.
struct SlaveState {
  Eigen::VectorXd gap, pressure;
};
inline SlaveState touching(
    const core::Mesh& mesh, const std::function<double(const Point&)>& gap = [](const Point&) { return 0.0; }) {
  SlaveState state{Eigen::VectorXd(mesh.node_count()), Eigen::VectorXd::Constant(mesh.node_count(), 1e5)};
  for (Index i = 0; i < mesh.node_count(); ++i) state.gap[i] = gap(mesh.nodes[i]);
  return state;
}

struct OneMaster {
  core::Geometry geometry;
  double transition_gap;
  Index law;
};
/// The interface with a single master.
inline std::vector<core::InterfacePoint> build_interface(const Surface& slave, const Surface& master,
                                                         const SlaveState& state, const OneMaster& options) {
  return contact::build_interface(slave, state.pressure,
                                  {Master{master, state.gap, options.transition_gap, options.law}}, options.geometry);
}

inline double weighted_contact_area(const std::vector<core::InterfacePoint>& points) {
  return std::accumulate(points.begin(), points.end(), 0.0,
                         [](double sum, const auto& p) { return sum + p.area * p.contact_weight; });
}

inline double interpolate(const core::Mesh& mesh, const std::array<Index, 3>& nodes, const std::array<double, 3>& shape,
                          const std::function<double(const Point&)>& f) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += shape[i] * f(mesh.nodes[nodes[i]]);
  return sum;
}

/// Largest difference between a function interpolated on the slave and on the master, over all interface points.
inline double max_jump(const core::Mesh& slave, const core::Mesh& master,
                       const std::vector<core::InterfacePoint>& points, const std::function<double(const Point&)>& f) {
  double jump = 0;
  for (const auto& p : points)
    jump = std::max(jump, std::abs(interpolate(slave, p.slave_nodes, p.slave_shape, f) -
                                   interpolate(master, p.master_nodes, p.master_shape, f)));
  return jump;
}

/// Loads of a unit flux on a body's nodes, through the interface.
inline Eigen::VectorXd interface_loads(const core::Mesh& mesh, const std::vector<core::InterfacePoint>& points,
                                       bool master) {
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(mesh.node_count());
  for (const auto& p : points)
    for (int i = 0; i < 3; ++i)
      loads[(master ? p.master_nodes : p.slave_nodes)[i]] +=
          p.area * p.contact_weight * (master ? p.master_shape : p.slave_shape)[i];
  return loads;
}

/// The same from the body's own contact edges.
inline Eigen::VectorXd own_loads(const core::Mesh& mesh, core::Geometry geometry) {
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(mesh.node_count());
  for (const auto& edge : mesh.boundary_edges())
    if (edge.boundary_id == 1)
      for (const auto& rule : core::edge_rule(5)) {
        const auto at = core::map_edge_point(mesh, edge.nodes, geometry, rule);
        for (int i = 0; i < 3; ++i) loads[edge.nodes[i]] += at.area * at.shape[i];
      }
  return loads;
}

}  // namespace parison::contact::testing
