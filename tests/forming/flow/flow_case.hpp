#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <set>
#include <string>

#include "core/mesh/element.hpp"
#include "forming/flow/solver.hpp"
#include "structured.hpp"

namespace parison::flow {

/// A flow problem that owns its mesh, material and temperature.
struct FlowProblem {
  core::Mesh mesh;
  Material material{};
  Eigen::VectorXd temperature;
  Problem problem{};

  FlowProblem(core::Mesh given, core::Geometry geometry, double viscosity = 1) : mesh(std::move(given)) {
    material.viscosity.constant = viscosity;
    temperature = Eigen::VectorXd::Constant(mesh.node_count(), 1400.0);
    problem.geometry = geometry;
    problem.boundary_conditions.resize(mesh.boundaries().size());
  }
  BoundaryCondition& boundary(const std::string& name) {
    return problem.boundary_conditions[core::find_boundary(mesh, name)];
  }
  void hold_all(BoundaryCondition::Kind kind) {
    for (auto& boundary : problem.boundary_conditions) boundary.kind = kind;
  }
  const Problem& bound() {
    problem.mesh = &mesh;
    problem.material = &material;
    problem.temperature = &temperature;
    return problem;
  }
  Solution solve(const std::vector<bool>& warm = {}) { return Solver(mesh).solve(bound(), warm); }
  std::set<Index> nodes_of(const std::string& name) const {
    std::set<Index> nodes;
    for (const auto& edge : mesh.boundary_edges())
      if (mesh.boundaries()[edge.boundary_id].name == name) nodes.insert(edge.nodes.begin(), edge.nodes.end());
    return nodes;
  }
  /// Candidates of a tool at all nodes of a boundary, without a gap.
  void touch(const std::string& name, Index tool, const Point& normal) {
    for (const Index node : nodes_of(name)) problem.candidates.push_back({node, tool, normal, 0.0});
  }
};

/// Exact velocity, m/s, and pressure, Pa (its mean is not compared).
struct ExactFlow {
  std::function<Point(const Point&)> velocity;
  std::function<double(const Point&)> pressure;
};

/// Errors in L2 over the volume: sqrt(int |v - v_exact|^2 dV), the same for the pressure without its mean.
struct FlowErrors {
  double velocity = 0, pressure = 0;
};

inline FlowErrors flow_errors(const FlowProblem& flow, const Solution& solution, const ExactFlow& exact) {
  double square_v = 0, sum_p = 0, square_p = 0, volume = 0;
  for (Index c = 0; c < flow.mesh.cell_count(); ++c)
    for (const auto& rule : core::triangle_rule(6)) {
      const auto at = core::map_cell_point(flow.mesh, c, flow.problem.geometry, rule);
      Point v = -exact.velocity(at.position);
      double p = -exact.pressure(at.position);
      for (int i = 0; i < 6; ++i) v += at.shape[i] * node_velocity(solution.velocity, flow.mesh.cells()[c][i]);
      for (int i = 0; i < 3; ++i) p += at.linear[i] * solution.pressure[flow.mesh.cells()[c][i]];
      square_v += at.volume * v.squaredNorm();
      sum_p += at.volume * p;
      square_p += at.volume * p * p;
      volume += at.volume;
    }
  return {std::sqrt(square_v), std::sqrt(std::max(0.0, square_p - sum_p * sum_p / volume))};
}

}  // namespace parison::flow
