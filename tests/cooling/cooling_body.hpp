#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

#include "forming/cooling/glass_memory.hpp"
#include "forming/cooling/nodal_values.hpp"
#include "forming/flow/solver.hpp"
#include "structured.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::cooling {

using core::Point;

/// The constants of the published plates: reference temperature 869 K, H/R 7.62e4 K, half of it with frozen structure.
/// Without structure the pace is that of the temperature and the expansion that of the solid.
inline GlassLaw reference_law(bool with_structure = true) {
  constexpr double reference = 869, activation = 7.62e4;
  GlassLaw law{70e9, 0.22, 9e-6, with_structure ? 32e-6 : 9e-6, {}, {}, (with_structure ? 0.5 : 1) * activation, {}};
  law.shear.weight << 0.05523, 0.08205, 0.1215, 0.2286, 0.2860, 0.22662;
  law.shear.weight /= law.shear.weight.sum();
  law.structure.weight = law.shear.weight;
  law.shear.time << 6.658e-5, 1.197e-3, 1.514e-2, 0.1672, 0.7497, 3.292;
  law.structure.time << 5.965e-4, 1.077e-2, 0.1362, 1.505, 6.747, 29.63;
  const double mean = law.shear.mean(), modulus = law.shear_modulus();
  law.shear.time /= mean;
  law.structure.time /= mean;
  law.log_equilibrium = [=](double T) { return std::log(modulus * mean) + activation * (1 / T - 1 / reference); };
  return law;
}

/// A body that cools: heat, then equilibrium, step by step on its first mesh.
struct CoolingBody {
  GlassLaw law;
  core::Mesh mesh;
  core::Geometry geometry;
  Eigen::VectorXd temperature;
  GlassMemory memory;
  thermal::Material heat;
  flow::Problem problem{};
  flow::Material material{2500, {}, {}, 0, {}};
  std::vector<std::optional<thermal::SurfaceExchange>> exchange;
  std::vector<std::optional<core::TimeFunction>> prescribed;
  double time = 0;
  double imbalance = 0;  ///< of the last step: force that no constraint carries over the largest of an element's

  CoolingBody(GlassLaw its_law, core::Mesh its_mesh, core::Geometry its_geometry, double start)
      : law(std::move(its_law)), mesh(std::move(its_mesh)), geometry(its_geometry) {
    temperature = Eigen::VectorXd::Constant(mesh.node_count(), start);
    memory = at_rest(mesh, temperature);
    exchange.resize(mesh.boundaries().size());
    prescribed.resize(mesh.boundaries().size());
    problem.boundary_conditions.resize(mesh.boundaries().size());
  }
  CoolingBody(const CoolingBody&) = delete;

  /// A step on given temperatures at its end.
  flow::Solution strain_to(const Eigen::VectorXd& next, double dt) {
    const MemoryStep step = start_step(law, mesh, memory, temperature, next, dt);
    problem.mesh = &mesh;
    problem.geometry = geometry;
    problem.material = &material;
    problem.temperature = &next;
    problem.memory = &step.flow;
    if (!solver) solver.emplace(mesh);
    flow::Solution solution = solver->solve(problem, {});
    EXPECT_TRUE(solution.converged) << solution.reason;
    auto points = flow::strains(mesh, flow::cell_geometry(mesh, geometry), dt * solution.velocity);
    for (auto& point : points) point.rotation = 0;  // the mesh does not turn either
    memory = end_step(step, memory, mesh, points, solution.pressure);
    temperature = next;
    time += dt;
    return solution;
  }
  void step(double dt) { strain_to(heated(dt), dt); }
  /// Temperatures after a step of heat.
  Eigen::VectorXd heated(double dt) {
    thermal::Problem heat_problem{geometry, {{&mesh, &mesh, heat.density, &heat, exchange, prescribed}}, {}, {}};
    thermal::StepOptions options;
    options.tolerance = heat_tolerance;
    auto outcome = thermal::advance(heat_problem, time, {temperature}, dt, options, matrix);
    EXPECT_TRUE(outcome.converged) << outcome.reason;
    return std::move(outcome.temperature[0]);
  }
  /// Steps that change no temperature by much more than `change`, K, until `end`, s; calls `after` for each.
  void cool(
      double end, double change, double first, const std::function<void()>& after = [] {}) {
    double dt = first;
    while (time < end - 1e-9 * end) {
      dt = std::min(dt, end - time);
      const Eigen::VectorXd before = temperature;
      step(dt);
      ++steps;
      after();
      const double changed = (temperature - before).lpNorm<Eigen::Infinity>();
      dt *= std::clamp(change / std::max(changed, 1e-9), 0.5, 1.5);
    }
  }
  /// Component of the stress at the node nearest to a place, MPa.
  double stress(const Point& at, Index component) const {
    const auto points = stress_at_points(mesh, memory.stress, memory.pressure);
    const Eigen::Map<const Eigen::VectorXd> flat(points.front().data(), 4 * Index(points.size()));
    Index nearest = 0;
    for (Index n = 0; n < mesh.node_count(); ++n)
      if ((mesh.nodes[n] - at).norm() < (mesh.nodes[nearest] - at).norm()) nearest = n;
    return 1e-6 * to_nodes(mesh, flat, 4)[4 * nearest + component];
  }

  std::optional<flow::Solver> solver;
  thermal::StepMatrix matrix;
  double heat_tolerance = 0.02;
  int steps = 0;
};

/// A rectangle from the origin; its sides are bottom, right, top, left, and its cells get thinner towards right and top
/// by powers.
inline core::Mesh rectangle(double width, double height, Index columns, Index rows, double along_r, double along_z) {
  core::Mesh mesh = tests::structured(columns, rows, [=](double s, double t) {
    return Point(width * (1 - std::pow(1 - s, along_r)), height * (1 - std::pow(1 - t, along_z)));
  });
  for (const auto& cell : mesh.cells())
    for (int i = 0; i < 3; ++i) mesh.nodes[cell[3 + i]] = 0.5 * (mesh.nodes[cell[i]] + mesh.nodes[cell[(i + 1) % 3]]);
  return mesh;
}

/// Half a plate as the middle of a disc, thickness in m: bottom is its middle plane, right the rim, top the surface,
/// left the axis.
inline core::Mesh half_plate(double thickness, Index rows, double grading = 1.25) {
  return rectangle(3 * thickness, thickness / 2, 12, rows, 1, grading);
}

/// Keeps the middle plane and the axis of such a plate.
inline void hold_symmetry(CoolingBody& body) {
  for (const char* name : {"bottom", "left"})
    body.problem.boundary_conditions[core::find_boundary(body.mesh, name)].kind =
        flow::BoundaryCondition::Kind::symmetry;
}

}  // namespace parison::cooling
