// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "flow_case.hpp"

namespace parison::flow {
namespace {

using core::Geometry;

/// Two layers on a fixed floor, pulled sideways by a unit force and free of shear at the top y = 1: dv/dy = (1 -
/// y)/eta, which quadratic velocities hold exactly, so that all that is left is round-off.
struct Layers {
  double lower, upper;

  double viscosity(double y) const { return y < 0.5 ? lower : upper; }
  double speed(double y) const {
    const auto in = [](double z) { return z - 0.5 * z * z; };
    return y < 0.5 ? in(y) / lower : in(0.5) / lower + (in(y)-in(0.5)) / upper;
  }
};

/// Largest error of the velocity in each layer, relative to the layer's own fastest point.
std::array<double, 2> layer_errors(const Layers& layers) {
  const auto bent = [](double s, double t) {
    const double wave = std::sin(2 * M_PI * t) * std::sin(2 * M_PI * s);
    return Point(s + 0.03 * wave, t);
  };
  FlowProblem flow(tests::structured(12, 12, bent), Geometry::planar);
  flow.hold_all(BoundaryCondition::Kind::fixed);
  for (auto& boundary : flow.problem.boundary_conditions)
    boundary.velocity = [=](const Point& x) { return Point(layers.speed(x[1]), 0); };
  flow.boundary("top").kind = BoundaryCondition::Kind::symmetry;
  flow.problem.viscosity = [=](const Point& x) { return layers.viscosity(x[1]); };
  flow.problem.force = [](const Point&) { return Point(1, 0); };
  for (auto& cell : flow.mesh.edit().cells)  // straight sides
    for (int i = 0; i < 3; ++i)
      flow.mesh.nodes[cell[3 + i]] = 0.5 * (flow.mesh.nodes[cell[i]] + flow.mesh.nodes[cell[(i + 1) % 3]]);
  const auto solution = flow.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  std::array<double, 2> error{};
  for (Index n = 0; n < flow.mesh.node_count(); ++n) {
    const double y = flow.mesh.nodes[n][1];
    const int upper = y > 0.5;
    const double off = (node_velocity(solution.velocity, n) - Point(layers.speed(y), 0)).norm();
    error[upper] = std::max(error[upper], off / layers.speed(upper ? 1.0 : 0.5));
  }
  return error;
}

TEST(StiffSkin, layers_of_ten_and_twelve_decades_flow_exactly) {
  for (const double jump : {1e6, 1e10, 1e12}) {
    const auto under = layer_errors({1e2, 1e2 * jump}), over = layer_errors({1e2 * jump, 1e2});
    std::printf("jump %.0e: error soft below %.1e, stiff on it %.1e; stiff below %.1e, soft on it %.1e\n", jump,
                under[0], under[1], over[0], over[1]);
    for (const double error : {under[0], under[1], over[0], over[1]}) EXPECT_LT(error, 1e-12);
  }
}

/// Glass between 598 degC on a fixed floor and 1200 degC at its top, pulled sideways by a unit force: its own law takes
/// the viscosity from 3e10, the most in the flow, to 1e2 Pa.s. Largest error of a node's velocity, relative to the
/// exact one there.
double skin_error(Index n) {
  constexpr double cold = 871, hot = 1473;
  FlowProblem flow(tests::structured(2, n, [](double s, double t) { return Point(0.1 * s, t); }), Geometry::planar);
  flow.material.viscosity = {-2.309, 3922, 564.15, std::nullopt};
  for (Index k = 0; k < flow.mesh.node_count(); ++k) flow.temperature[k] = cold + (hot - cold) * flow.mesh.nodes[k][1];
  const auto rate = [&](double y) { return (1 - y) / flow.material.viscosity(cold + (hot - cold) * y); };
  constexpr int parts = 4096;  // of the height, each with Simpson's rule; even mesh nodes lie on their ends
  std::vector<double> exact(parts + 1, 0.0);
  for (int i = 0; i < parts; ++i) {
    const double a = double(i) / parts, h = 1.0 / parts;
    exact[i + 1] = exact[i] + h / 6 * (rate(a) + 4 * rate(a + 0.5 * h) + rate(a + h));
  }
  const auto speed = [&](double y) { return exact[std::size_t(std::lround(y * parts))]; };
  flow.hold_all(BoundaryCondition::Kind::fixed);
  for (auto& boundary : flow.problem.boundary_conditions)
    boundary.velocity = [=](const Point& x) { return Point(speed(x[1]), 0); };
  flow.boundary("top").kind = BoundaryCondition::Kind::symmetry;
  flow.problem.force = [](const Point&) { return Point(1, 0); };
  const auto solution = flow.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  double worst = 0;
  for (Index k = 0; k < flow.mesh.node_count(); ++k)
    if (const double v = speed(flow.mesh.nodes[k][1]); v > 0)
      worst = std::max(worst, (node_velocity(solution.velocity, k) - Point(v, 0)).norm() / v);
  return worst;
}

TEST(StiffSkin, every_layer_of_a_skin_from_3e10_to_1e2_by_its_temperature_has_its_own_speed) {
  const double coarse = skin_error(128), fine = skin_error(256);
  std::printf("skin by temperature: 128 layers off by %.2e of each node's own speed, 256 by %.2e, order %.2f\n", coarse,
              fine, std::log2(coarse / fine));
  tests::expect_at_most("skin from 3e10 to 1e2 Pa.s, 256 layers: each node's own speed off by", fine, 5e-3);
  EXPECT_GT(std::log2(coarse / fine), 1.9);  // speeds vanish towards the floor: an order less
}

double free_area(const FlowProblem& flow, const core::Mesh& mesh) {
  double area = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.boundaries()[edge.boundary_id].name == "right")
      for (const auto& rule : core::edge_rule(5))
        area += core::map_edge_point(mesh, edge.nodes, flow.problem.geometry, rule).area;
  return area;
}

/// Power of gravity, air and surface tension on the moving glass, W; that of the tension from how fast the free surface
/// grows.
double loads_power(const FlowProblem& flow, const Solution& solution) {
  double power = 0;
  for (Index c = 0; c < flow.mesh.cell_count(); ++c)
    for (const auto& rule : core::triangle_rule(6)) {
      const auto at = core::map_cell_point(flow.mesh, c, flow.problem.geometry, rule);
      for (int i = 0; i < 6; ++i)
        power += flow.material.density * flow.problem.gravity * at.volume * at.shape[i] *
                 node_velocity(solution.velocity, flow.mesh.cells()[c][i])[1];
    }
  for (const auto& edge : flow.mesh.boundary_edges())
    if (flow.mesh.boundaries()[edge.boundary_id].name == "right")
      for (const auto& rule : core::edge_rule(5)) {
        const auto at = core::map_edge_point(flow.mesh, edge.nodes, flow.problem.geometry, rule);
        for (int i = 0; i < 3; ++i)
          power -= flow.problem.boundary_conditions[edge.boundary_id].pressure * at.area * at.shape[i] *
                   at.normal.dot(node_velocity(solution.velocity, edge.nodes[i]));
      }
  core::Mesh before = flow.mesh, after = flow.mesh;
  const double dt = 1e-4 * 0.01 / solution.velocity.lpNorm<Eigen::Infinity>();
  for (Index n = 0; n < flow.mesh.node_count(); ++n) {
    before.nodes[n] -= dt * node_velocity(solution.velocity, n);
    after.nodes[n] += dt * node_velocity(solution.velocity, n);
  }
  return power - flow.material.surface_tension * (free_area(flow, after) - free_area(flow, before)) / (2 * dt);
}

/// A disc pressed between sticking plates, in air over-pressure, its skin by the plates stiffer by `jump`.
FlowProblem skinned_disc(double jump) {
  FlowProblem flow(tests::structured(24, 16, [](double s, double t) { return Point(0.02 * s, 0.01 * t); }),
                   Geometry::axisymmetric);
  flow.material.density = 2400;
  flow.material.surface_tension = 30;
  flow.problem.gravity = -9.81;
  flow.problem.viscosity = [=](const Point& x) {
    const double depth = std::min(x[1], 0.01 - x[1]);
    return 100 * std::pow(jump, std::max(0.0, 1 - depth / 0.002));
  };
  flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  flow.boundary("right").pressure = 2e3;
  flow.problem.tools.resize(2);
  flow.problem.tools[1].force = -200;
  flow.problem.tools[1].speed_limit = 10;
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("top", 1, Point(0, -1));
  return flow;
}

TEST(StiffSkin, work_done_on_the_glass_is_dissipated_at_any_range_of_viscosity) {
  for (const double jump : {1.0, 1e6, 1e10}) {
    FlowProblem flow = skinned_disc(jump);
    const auto solution = flow.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    EXPECT_NEAR(solution.tool_force[1], -200, 1e-6);
    double dissipated = 0;
    for (const double w : solution.dissipation) dissipated += w;
    const double tools =
        solution.tool_force[0] * solution.tool_velocity[0] + solution.tool_force[1] * solution.tool_velocity[1];
    const double loads = loads_power(flow, solution);
    std::printf("viscosity 1e2 to %.0e: plunger %.4e m/s, tools %.4e W, loads %.4e W, dissipated %.4e W, off by %.1e\n",
                100 * jump, solution.tool_velocity[1], tools, loads, dissipated, (tools + loads) / dissipated - 1);
    EXPECT_LT(std::abs((tools + loads) / dissipated - 1), 1e-6);
    EXPECT_GT(std::abs(loads), 1e-3 * dissipated);
  }
}

/// Power of the tools less what the glass loses, relative to that.
double power_left(const FlowProblem& flow, const Solution& solution) {
  double lost = solution.friction_power + solution.impact_power, tools = 0;
  for (const double w : solution.dissipation) lost += w;
  for (std::size_t t = 0; t < flow.problem.tools.size(); ++t)
    tools += solution.tool_force[t] * solution.tool_velocity[t];
  return (tools + loads_power(flow, solution)) / lost - 1;
}

TEST(Balance, what_slides_along_plates_loses_the_rest_of_their_work) {
  for (const double stiffness : {1e3, 1e6, 1e9}) {
    FlowProblem flow = skinned_disc(1);
    for (auto& tool : flow.problem.tools) tool.friction = {Friction::Law::navier, stiffness, std::nullopt};
    const auto solution = flow.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    std::printf("drag %.0e Pa.s/m: friction %.3e W, off by %.1e\n", stiffness, solution.friction_power,
                power_left(flow, solution));
    EXPECT_GT(solution.friction_power, 0);
    EXPECT_LT(std::abs(power_left(flow, solution)), 1e-6);
  }
}

TEST(Balance, friction_at_coulombs_limit_loses_the_rest_of_the_tools_work) {
  for (const double coulomb : {0.02, 0.2}) {
    FlowProblem flow = skinned_disc(1);
    for (auto& tool : flow.problem.tools) tool.friction = {Friction::Law::navier, 1e8, coulomb};
    const auto solution = flow.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    std::printf("Coulomb %.2f: friction %.3e W, off by %.1e; %d solves\n", coulomb, solution.friction_power,
                power_left(flow, solution), solution.iterations);
    EXPECT_LT(solution.iterations, 25);
    EXPECT_LT(std::abs(power_left(flow, solution)), 1e-6);
  }
}

TEST(Balance, what_lands_on_a_plate_loses_its_force_times_the_way) {
  FlowProblem flow = skinned_disc(1);
  for (auto& candidate : flow.problem.candidates) {  // of a domed plate
    if (candidate.tool == 0) continue;
    candidate.contact_fraction = 1 - flow.mesh.nodes[candidate.node][0] / 0.02;
    candidate.rate = -0.05 * (1 - candidate.contact_fraction);
    candidate.approach_velocity = Point(0.1, -0.05);
  }
  const auto solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  std::printf("domed plate: impact %.3e W, off by %.1e\n", solution.impact_power, power_left(flow, solution));
  EXPECT_GT(solution.impact_power, 0);
  EXPECT_LT(std::abs(power_left(flow, solution)), 1e-6);
}

/// A cylinder of glass without friction between a tool that moves up, at 1 mm/s, and one that a force holds against it.
FlowProblem enclosed_plug(double viscosity, double force) {
  FlowProblem flow(tests::structured(4, 4, [](double s, double t) { return Point(0.02 * s, 0.01 * t); }),
                   Geometry::axisymmetric, viscosity);
  flow.boundary("left").kind = flow.boundary("right").kind = BoundaryCondition::Kind::symmetry;
  flow.problem.tools.resize(2);
  flow.problem.tools[0].velocity = 1e-3;
  flow.problem.tools[1].force = force;
  flow.problem.tools[1].speed_limit = 1;
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("top", 1, Point(0, -1));
  return flow;
}

TEST(Balance, a_driven_tool_behind_enclosed_glass_has_its_own_force) {
  for (const double viscosity : {1e3, 1e8, 1e11}) {
    const auto solution = enclosed_plug(viscosity, -1).solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    std::printf("%.0e Pa.s: %.6g N at %.6g m/s\n", viscosity, solution.tool_force[1], solution.tool_velocity[1]);
    // What is left is the round-off of the bulk viscosity, 1e10 times that of the glass.
    EXPECT_NEAR(solution.tool_force[1], -1, 1e-9 * viscosity) << viscosity;
    EXPECT_NEAR(solution.tool_velocity[1], 1e-3, 1e-8) << viscosity;
  }
}

TEST(Balance, a_tool_that_touches_nothing_stays_where_its_force_is_zero) {
  for (const double force : {-1.0, 0.0, 1.0}) {
    FlowProblem flow = skinned_disc(1);
    flow.problem.tools.push_back({{}, 0, force, 0.1});
    const auto solution = flow.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    EXPECT_EQ(solution.tool_velocity[2], 0.1 * force);
    EXPECT_NEAR(solution.tool_force[1], -200, 1e-6);
  }
}

}  // namespace
}  // namespace parison::flow
