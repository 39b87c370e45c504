// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/remeshing/mesh_smoothing.hpp"

#include <algorithm>
#include <cmath>

#include "contact/unilateral/tool_gap.hpp"
#include "core/mesh/element.hpp"
#include "core/mesh/profile.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

using core::dim;

void smooth_displacement(const core::Mesh& from, core::Mesh& mesh) {
  constexpr int sweeps = 20;
  std::vector<bool> on_surface(mesh.nodes.size(), false);
  for (const Index node : surface_nodes(mesh)) on_surface[node] = true;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::vector<Point> sum(mesh.nodes.size(), Point::Zero());
    std::vector<int> count(mesh.nodes.size(), 0);
    for (const auto& cell : mesh.cells()) {
      Point mean = Point::Zero();
      for (const Index node : cell) mean += (mesh.nodes[node] - from.nodes[node]) / cell.size();
      for (const Index node : cell) sum[node] += mean, ++count[node];
    }
    for (Index n = 0; n < mesh.node_count(); ++n)
      if (!on_surface[n]) mesh.nodes[n] = from.nodes[n] + sum[n] / count[n];
  }
}

namespace {

/// Unit directions in which surface nodes may move: along the normal, within symmetry planes; zero on fixed boundaries.
std::vector<Point> surface_directions(const Scene& scene, const core::Mesh& mesh) {
  std::vector<Point> direction(mesh.nodes.size(), Point::Zero());
  for (const auto& edge : mesh.boundary_edges()) {
    if (mesh.boundaries()[edge.boundary_id].kind == BoundaryKind::symmetry) continue;
    const double ends[] = {0, 1, 0.5};
    for (int i = 0; i < 3; ++i)
      direction[edge.nodes[i]] += core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, {ends[i], 1}).normal;
  }
  for (auto& along : direction)
    if (along.norm() > 0) along.normalize();
  for (const auto& edge : mesh.boundary_edges()) {
    const BoundaryKind kind = mesh.boundaries()[edge.boundary_id].kind;
    const Point normal = core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, {0.5, 1}).normal;
    for (const Index node : edge.nodes) {
      if (kind == BoundaryKind::symmetry) direction[node] -= direction[node].dot(normal) * normal;
      if (kind == BoundaryKind::fixed) direction[node].setZero();
    }
  }
  return direction;
}

/// Takes the directions of nodes that touch tools away.
void constrain_at_tools(const Scene& scene, const State& state, const core::Mesh& mesh, std::vector<Point>& direction) {
  constexpr double touching = 2e-6;
  for (const auto& place : scene.stages[state.stage].tools) {
    const Body& body = scene.tools[place.tool];
    const auto contact = contact_boundaries(body);
    const Point offset = state.tools[place.tool].offset * core::axis_direction();
    for (const Index node : surface_nodes(mesh))
      if (contact::signed_gap(body.profile, contact, mesh.nodes[node] - offset) < touching) direction[node].setZero();
  }
}

/// Volume swept per metre of motion, m2.
double swept_area(const Scene& scene, const core::Mesh& mesh, const std::vector<Point>& direction) {
  double area = 0;
  for (const auto& edge : mesh.boundary_edges())
    for (const auto& rule : core::edge_rule(3)) {
      const auto at = core::map_edge_point(mesh, edge.nodes, scene.geometry, rule);
      for (int i = 0; i < 3; ++i) area += at.area * at.shape[i] * at.normal.dot(direction[edge.nodes[i]]);
    }
  return area;
}

void move(double distance, const std::vector<Point>& direction, core::Mesh& mesh) {
  for (Index n = 0; n < mesh.node_count(); ++n) mesh.nodes[n] += distance * direction[n];
}

}  // namespace

void restore_volume(const Scene& scene, const State& state, double target, core::Mesh& mesh) {
  constexpr double max_shift = 0.05e-3;  // of the free surface in one round
  constexpr double max_free_shift = 20e-6, max_whole_shift = 3e-6;
  constexpr double reached = 4e-15;
  constexpr int free_rounds = 20, rounds = 26;
  bool everywhere = false;
  for (int round = 0; round < rounds; ++round) {
    const double defect = target - core::volume(mesh, scene.geometry);
    if (std::abs(defect) <= reached * target) return;
    auto direction = surface_directions(scene, mesh);
    const double whole = swept_area(scene, mesh, direction);
    if (!everywhere) {
      auto free = direction;
      constrain_at_tools(scene, state, mesh, free);
      const double open = swept_area(scene, mesh, free);
      const bool small = std::abs(defect) > max_free_shift * open && std::abs(defect) < max_whole_shift * whole;
      everywhere = open <= 0 || small || round >= free_rounds;
      if (!everywhere) {
        move(std::clamp(defect / open, -max_shift, max_shift), free, mesh);
        project_out_of_tools(scene, state, mesh);
        continue;
      }
    }
    if (whole <= 0) return;
    move(defect / whole, direction, mesh);
  }
}

}  // namespace parison::forming
