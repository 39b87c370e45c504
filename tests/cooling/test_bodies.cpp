// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that cool, against closed forms: frozen parabolas, a seal, a free body, the order in time.
#include <array>
#include <cmath>
#include <cstdio>

#include "cooling_body.hpp"
#include "figure.hpp"
#include "quarter_sphere.hpp"

namespace parison::cooling {
namespace {

using core::Geometry;

constexpr double kelvin = 273.15;
constexpr double k = 1.3, rho = 2500, cp = 1100, diffusivity = k / (rho * cp);
constexpr double rate = 5.0 / 60;  // K/s

/// Cools the surface of a body at a constant rate from 600 to 20 degC, then until it is even.
void anneal(CoolingBody& body, const char* surface, double length, double change = 5) {
  body.heat = {rho, core::constant(cp), core::constant(k), {}, {}};
  body.heat_tolerance = 1e-3;
  const double ramp = 580 / rate;
  body.prescribed[core::find_boundary(body.mesh, surface)] =
      core::TimeFunction(core::Table{{0, ramp}, {kelvin + 600, kelvin + 20}});
  body.cool(ramp, change, 0.1);
  body.cool(ramp + 10 * length * length / diffusivity, change, 0.1);
}

/// E alpha dT/(1 - nu), MPa, of a temperature difference within, K.
double unit(const GlassLaw& law, double difference) {
  return 1e-6 * law.young * law.solid_expansion * difference / (1 - law.poisson);
}

TEST(CooledBodies, a_slow_plate_freezes_its_parabola) {
  const double thickness = 6e-3;
  CoolingBody body(reference_law(false), half_plate(thickness, 12), Geometry::axisymmetric, kelvin + 600);
  hold_symmetry(body);
  anneal(body, "top", thickness / 2);
  const double scale = unit(body.law, rate * thickness * thickness / (8 * diffusivity));
  tests::Figure off("slow plate without structure: stress over -2/3 at the surface, 1/3 in the middle off by");
  off.add(std::abs(body.stress({0, thickness / 2}, 2) / scale + 2.0 / 3) * 1.5);
  off.add(std::abs(body.stress({0, 0}, 2) / scale - 1.0 / 3) * 3);
  off.at_most(1e-3);
}

TEST(CooledBodies, a_slow_cylinder_freezes_its_parabola) {
  const double radius = 5e-3;
  CoolingBody body(reference_law(false), rectangle(radius, 4 * radius, 20, 20, 1, 1), Geometry::axisymmetric,
                   kelvin + 600);
  hold_symmetry(body);
  anneal(body, "right", radius);
  const double scale = unit(body.law, rate * radius * radius / (4 * diffusivity));
  tests::Figure off("slow cylinder without structure: stress over -1/2 at the surface, 1/4 and 1/2 on the axis off by");
  off.add(std::abs(body.stress({radius, 0}, 2) / scale + 0.5) * 2);
  off.add(std::abs(body.stress({radius, 0}, 1) / scale + 0.5) * 2);
  off.add(std::abs(body.stress({0, 0}, 0) / scale - 0.25) * 4);
  off.add(std::abs(body.stress({0, 0}, 1) / scale - 0.5) * 2);
  off.at_most(1e-3);
}

TEST(CooledBodies, a_slow_sphere_freezes_its_parabola) {
  const double radius = 5e-3;
  CoolingBody body(reference_law(false), tests::quarter_sphere(radius, 16), Geometry::axisymmetric, kelvin + 600);
  body.problem.boundary_conditions[core::find_boundary(body.mesh, "axes")].kind =
      flow::BoundaryCondition::Kind::symmetry;
  anneal(body, "surface", radius);
  const double scale = unit(body.law, rate * radius * radius / (6 * diffusivity));
  tests::Figure off("slow sphere without structure: stress over -2/5 at the surface, 2/5 in the centre off by");
  off.add(std::abs(body.stress({radius, 0}, 2) / scale + 0.4) * 2.5);
  off.add(std::abs(body.stress({0, 0}, 1) / scale - 0.4) * 2.5);
  off.at_most(1e-3);
}

/// Deepest unbalanced force on a free node over stress times section.
double imbalance(const CoolingBody& body) {
  const auto geometry = flow::cell_geometry(body.mesh, body.geometry);
  const auto stress = stress_at_points(body.mesh, body.memory.stress, body.memory.pressure);
  flow::StressMemory held{{}, 1, stress, Eigen::VectorXd::Zero(body.mesh.vertex_count()), {}};
  held.expansion_rate.assign(stress.size(), 0);
  flow::Problem problem = body.problem;
  problem.memory = &held;
  Eigen::VectorXd force = flow::memory_load(problem, geometry).head(core::dim * body.mesh.node_count());
  std::vector<bool> on_symmetry(body.mesh.nodes.size(), false);
  double largest = 0, section = 0;
  for (const auto& edge : body.mesh.boundary_edges()) {
    if (body.problem.boundary_conditions[edge.boundary_id].kind != flow::BoundaryCondition::Kind::symmetry) continue;
    for (const Index node : edge.nodes) force.segment<core::dim>(core::dim * node).setZero();
  }
  for (const auto& point : stress)
    for (const double component : point) largest = std::max(largest, std::abs(component));
  for (const auto& x : body.mesh.nodes) section = std::max(section, M_PI * x[0] * x[0]);
  return force.lpNorm<Eigen::Infinity>() / (largest * section);
}

TEST(CooledBodies, a_free_body_is_in_balance) {
  // A cup of uneven wall that cools fast from a hot side.
  CoolingBody body(reference_law(),
                   tests::structured(24, 4,
                                     [](double s, double t) {
                                       const double angle = M_PI / 2 * (1 - s), r = 30e-3 + t * (2e-3 + 2e-3 * s);
                                       return core::Point(r * std::sin(angle), -r * std::cos(angle));
                                     }),
                   Geometry::axisymmetric, kelvin + 650);
  for (auto& node : body.mesh.nodes) node[0] = std::abs(node[0]) < 1e-12 ? 0 : node[0];
  for (const char* name : {"left", "right"})
    body.problem.boundary_conditions[core::find_boundary(body.mesh, name)].kind =
        flow::BoundaryCondition::Kind::symmetry;
  body.heat = {2500, core::constant(1330), core::constant(1.3), {}, {}};
  body.exchange[core::find_boundary(body.mesh, "top")] = thermal::SurfaceExchange{100, kelvin + 20, 0, 300};
  tests::Figure off("free body: force without balance over stress times section");
  body.cool(300, 10, 1e-3, [&] { off.add(imbalance(body)); });
  EXPECT_GT(std::abs(body.stress(body.mesh.nodes[0], 2)), 0.1);
  off.at_most(1e-10);
}

/// Half a plate in which a core shrinks by more, in proportion to `share` of the height over its half: stress in its
/// middle and on its surface, MPa.
std::array<double, 2> sealed(Index rows, double more, const std::function<double(double)>& share) {
  const double thickness = 4e-3;
  CoolingBody body(reference_law(), rectangle(5 * thickness, thickness / 2, 30, rows, 1, 1), Geometry::axisymmetric,
                   293.15);
  hold_symmetry(body);
  MemoryStep step = start_step(body.law, body.mesh, body.memory, body.temperature, body.temperature, 1);
  for (Index c = 0; c < body.mesh.cell_count(); ++c)
    for (int q = 0; q < flow::cell_points; ++q) {
      const auto at = core::map_cell_point(body.mesh, c, body.geometry, core::triangle_rule(4)[q]);
      step.flow.expansion_rate[c * flow::cell_points + q] = -3 * more * share(at.position[1] / (thickness / 2));
    }
  body.problem.mesh = &body.mesh;
  body.problem.geometry = body.geometry;
  body.problem.material = &body.material;
  body.problem.temperature = &body.temperature;
  body.problem.memory = &step.flow;
  const flow::Solution solution = flow::Solver(body.mesh).solve(body.problem, {});
  EXPECT_TRUE(solution.converged) << solution.reason;
  const auto strains = flow::strains(body.mesh, flow::cell_geometry(body.mesh, body.geometry), solution.velocity);
  body.memory = end_step(step, body.memory, body.mesh, strains, solution.pressure);
  return {body.stress({0, 0}, 2), body.stress({0, thickness / 2}, 2)};
}

TEST(CooledBodies, a_sandwich_seal_has_its_exact_stress) {
  const double apart = 1e-6 * 510;
  const GlassLaw law = reference_law();
  const double exact = 1e-6 * law.young / (1 - law.poisson) * apart / 2;
  EXPECT_NEAR(exact, 22.885, 1e-3);
  tests::Figure off("seal whose expansion goes straight from core to outside: stress off by, relative");
  const auto straight = sealed(8, apart, [](double height) { return 1 - height; });
  off.add(std::abs(straight[0] / exact - 1));
  off.add(std::abs(straight[1] / exact + 1));
  off.at_most(1e-6);
  // The pressure of two glasses jumps, and continuous pressures do not.
  std::array<double, 2> jump{};
  for (int i = 0; i < 2; ++i)
    jump[i] = std::abs(sealed(16 << i, apart, [](double height) { return height < 0.5 ? 1 : 0; })[1] / exact + 1);
  tests::expect_at_most("sandwich seal of equal halves, 32 rows of cells: stress outside off by, relative", jump[1],
                        5e-3);
  EXPECT_GT(std::log2(jump[0] / jump[1]), 0.9);
}

TEST(CooledBodies, the_stress_of_a_quenched_plate_is_of_second_order_in_time) {
  std::array<double, 3> middle{};
  for (int level = 0; level < 3; ++level) {
    CoolingBody body(reference_law(), half_plate(6e-3, 4, 1.25), Geometry::axisymmetric, kelvin + 650);
    hold_symmetry(body);
    body.heat = {2500, core::constant(1330), core::constant(1.3), {}, {}};
    body.heat_tolerance = 1e-4;
    body.exchange[core::find_boundary(body.mesh, "top")] = thermal::SurfaceExchange{100, kelvin + 20, 0, 300};
    const int parts = 1 << level;
    for (double dt = 0.2; body.time < 600; dt *= 1.1)
      for (int part = 0; part < parts; ++part) body.step(dt / parts);
    middle[level] = body.stress({0, 0}, 2);
  }
  std::printf("middle %.6f %.6f %.6f MPa\n", middle[0], middle[1], middle[2]);
  tests::expect_at_least("quenched plate: order of the stress in time",
                         std::log2(std::abs((middle[1] - middle[0]) / (middle[2] - middle[1]))), 1.7);
}

TEST(CooledBodies, steps_through_the_whole_transition_are_stable) {
  CoolingBody body(reference_law(), half_plate(6e-3, 6), Geometry::axisymmetric, kelvin + 900);
  hold_symmetry(body);
  const auto even = [&](double celsius) { return Eigen::VectorXd::Constant(body.mesh.node_count(), kelvin + celsius); };
  const auto uneven = [&](double celsius) {
    Eigen::VectorXd temperature = even(celsius);
    for (Index n = 0; n < body.mesh.node_count(); ++n) temperature[n] -= 20 * std::pow(body.mesh.nodes[n][1] / 3e-3, 2);
    return temperature;
  };
  for (int turn = 0; turn < 3; ++turn) {
    body.strain_to(uneven(400), 10);  // 1e3 to beyond 1e15 Pa.s
    body.strain_to(even(20), 10);
    EXPECT_LT(std::abs(body.stress({0, 3e-3}, 2)), 50) << turn;
    EXPECT_LT(body.stress({0, 3e-3}, 2), -1) << turn;
    body.strain_to(even(900), 10);
    EXPECT_LT(std::abs(body.stress({0, 3e-3}, 2)), 1e-3) << turn;
  }
}

}  // namespace
}  // namespace parison::cooling
