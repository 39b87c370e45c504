// SPDX-License-Identifier: GPL-3.0-or-later
// Heat of bodies in space that touch and move: nothing is lost.
#include <gtest/gtest.h>

#include "contact/solid/solid_conductance.hpp"
#include "contact/solid/solid_mortar.hpp"
#include "figure.hpp"
#include "solid/solid_meshes.hpp"

namespace parison::thermal::test {
namespace {

constexpr double side = 0.01;

/// Hot glass, light that conducts, on a tool whose properties vary; the mould does not reach to the glass's edge.
struct Pressing {
  Material glass_material{2500,
                          {{300, 900, 1500}, {900, 1200, 1400}},
                          {{300, 1500}, {1.0, 2.0}},
                          Radiation{1.5, 400, true, Radiation::Model::rosseland, {}, {}}};
  Material tool_material{7800, {{300, 1000}, {450, 600}}, {{300, 1000}, {25, 30}}, {}};
  Block glass = block(4, 4, 3, [](const Vector3& x) -> Vector3 {
    return {side * x[0], side * x[1], 0.3 * side * x[2] * (1 + 0.2 * x[0])};
  });
  core::PrismMesh tool = core::sweep(rectangle(divide(side, 1.7 * side, 3), divide(-side, 0, 3, 0.6)), 0, 1.2 * side, 3,
                                     [](double r, double z, double y) -> Vector3 {
                                       return {r - side, y, z};
                                     });
  Eigen::VectorXd glass_mass = masses(glass.mesh, core::hexahedron_table(), glass_material);
  Eigen::VectorXd tool_mass = masses(tool, core::prism_table(), tool_material);
  std::vector<Eigen::VectorXd> temperature{Eigen::VectorXd::Constant(glass.mesh.node_count(), 1400),
                                           Eigen::VectorXd::Constant(tool.node_count(), 700)};

  /// The bodies as they lie now, with their interface and a law that depends on pressure and temperature.
  SolidProblem problem() const {
    SolidProblem made{
        {solid_body(glass.mesh, glass.faces, glass_mass, glass_material), solid_body(tool, tool_mass, tool_material)},
        {},
        {}};
    const auto state = [this](Index face, const std::array<double, 2>& place) {
      return contact::ContactState{
          core::face_place(glass.mesh.nodes, glass.faces[face], place[0], place[1]).position[2], 2e5};
    };
    made.interface =
        contact::build_interface(contact::solid_surface(0, glass.mesh.nodes, glass.faces, {z_low}),
                                 {{contact::solid_surface(1, tool.nodes, tool.faces, {top}), 0, 1e-4, state}});
    made.law = in_space(
        [law = contact::InterfaceConductance({contact::PressureViscosityConductance{}},
                                             contact::conductance_points(made.interface.points))](
            double, const std::vector<core::InterfacePoint>&, const InterfaceTemperatures& at, Eigen::ArrayXd& h,
            Eigen::ArrayXd* dh_dT) {
          law(25 - at.slave / 100, h, dh_dT);
          if (dh_dT) *dh_dT /= -100;
        },
        contact::conductance_points(made.interface.points));
    return made;
  }
};

double total(const SolidProblem& problem, const std::vector<Eigen::VectorXd>& temperature) {
  return heat_content(problem.bodies[0], temperature[0]) + heat_content(problem.bodies[1], temperature[1]);
}

TEST(SolidBalance, an_insulated_pair_keeps_its_heat_while_the_glass_moves) {
  Pressing pressing;
  auto& temperature = pressing.temperature;
  SolidStepMatrix matrix;
  const double before = total(pressing.problem(), temperature);
  double exchanged = 0;
  Index substeps = 0;
  tests::Figure mismatch("heat out of glass against that into the tool, in space: off by");
  for (int step = 0; step < 5; ++step) {
    const SolidProblem problem = pressing.problem();
    const StepOutcome end = advance(problem, 0.1 * step, temperature, 0.1, {}, matrix);
    ASSERT_TRUE(end.converged) << end.reason;
    temperature = end.temperature;
    exchanged += end.balance.pairs[0].heat;
    substeps += end.substeps + end.rejected;
    mismatch.add(flux_mismatch(end.balance));
    for (auto& x : pressing.glass.mesh.nodes) x[0] *= 1.02, x[1] *= 1.01, x[2] /= 1.02 * 1.01;
  }
  EXPECT_GT(exchanged, 5);
  EXPECT_EQ(matrix.analyses, 1);
  EXPECT_LT(matrix.factorisations, substeps);  // one serves while the stages converge with it
  EXPECT_LT(temperature[0].minCoeff(), 1300);
  tests::expect_at_most("heat of an insulated pair in space: lost, share of what passed",
                        std::abs(total(pressing.problem(), temperature) - before) / exchanged, 1e-12);
  mismatch.at_most(1e-12);
}

TEST(SolidBalance, what_a_body_stores_is_what_came_through_its_surfaces) {
  Pressing pressing;
  SolidProblem problem = pressing.problem();
  problem.bodies[0].exchange.assign(6, SurfaceExchange{50, 320, 0.9, 400});
  problem.bodies[1].exchange.assign(4, SurfaceExchange{20, 300, 0, 300});
  problem.bodies[1].prescribed.resize(4);
  problem.bodies[1].prescribed[bottom] = core::TimeFunction(core::Table{{0, 1}, {700, 650}});
  SolidStepMatrix matrix;
  const StepOutcome end = advance(problem, 0, pressing.temperature, 0.4, {}, matrix);
  ASSERT_TRUE(end.converged) << end.reason;
  EXPECT_GT(end.substeps, 1);
  const double passed = end.balance.pairs[0].heat;
  for (Index body = 0; body < 2; ++body) {
    EXPECT_LT(std::abs(imbalance(end.balance, body)), 1e-11 * passed);
    const double stored = heat_content(problem.bodies[body], end.temperature[body]) -
                          heat_content(problem.bodies[body], pressing.temperature[body]);
    EXPECT_NEAR(end.balance.bodies[body].content_change, stored, 1e-10 * passed);
  }
  EXPECT_GT(end.balance.bodies[0].to_air, 0);
  EXPECT_LT(end.balance.bodies[1].from_prescribed, 0);
}

TEST(SolidBalance, a_contact_that_opens_conducts_as_its_gap_at_the_time) {
  Pressing pressing;
  SolidProblem problem = pressing.problem();
  for (auto& point : problem.interface.points) point.opening = 1e-5, point.closing_rate = 3;
  const contact::GapConductance gap{2.5e-7, 4e-5, 0.25, 1, 0.9, 0};
  const auto points = contact::conductance_points(problem.interface.points);
  const contact::InterfaceConductance law({gap}, points);
  problem.law = in_space(
      [&](double time, const std::vector<core::InterfacePoint>& at, const InterfaceTemperatures& temperature,
          Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dT) {
        law.set_gap_conductance(time, at, temperature.slave, temperature.master, h, dh_dT);
      },
      points);
  SolidStepMatrix matrix;
  const StepOutcome end = advance(problem, 0, pressing.temperature, 1e-6, {}, matrix);
  ASSERT_TRUE(end.converged) << end.reason;
  double exact = 0;
  for (const auto& point : problem.interface.points)
    exact += point.area * point.contact_weight * gap.at_opening(1e-5, 1400.0, 700.0) * 700 * 1e-6;
  EXPECT_NEAR(end.balance.pairs[0].heat, exact, 1e-2 * exact);
}

TEST(SolidBalance, contact_replaces_the_exchange_with_the_air) {
  Pressing pressing;
  SolidProblem problem = pressing.problem();
  problem.bodies[0].exchange.assign(6, std::nullopt);
  problem.bodies[0].exchange[z_low] = SurfaceExchange{100, 300, 0, 300};
  SolidStepMatrix matrix;
  const StepOutcome end = advance(problem, 0, pressing.temperature, 1e-6, {}, matrix);
  ASSERT_TRUE(end.converged) << end.reason;
  const double open = side * side * (1 - 0.7);  // the mould ends at 0.7 of the side
  EXPECT_NEAR(end.balance.bodies[0].to_air, 1e-6 * 100 * 1100 * open, 1e-3 * 1e-6 * 100 * 1100 * open);
}

TEST(SolidBalance, a_kept_factor_changes_no_result) {
  Pressing pressing;
  SolidProblem problem = pressing.problem();
  problem.bodies[1].prescribed.resize(4);
  SolidStepMatrix kept;
  std::vector<Eigen::VectorXd> temperature = pressing.temperature;
  for (const bool held : {false, true}) {
    if (held) problem.bodies[1].prescribed[bottom] = core::TimeFunction(690);
    for (const double dt : {0.002, 0.0025, 0.002}) {
      SolidStepMatrix fresh;
      const StepOutcome with = advance(problem, 0, temperature, dt, one_step(), kept);
      const StepOutcome without = advance(problem, 0, temperature, dt, one_step(), fresh);
      ASSERT_TRUE(with.converged && without.converged) << with.reason << without.reason;
      for (Index body = 0; body < 2; ++body)
        EXPECT_LT((with.temperature[body] - without.temperature[body]).lpNorm<Eigen::Infinity>(), 1e-7);
      temperature = with.temperature;
    }
  }
  EXPECT_LE(kept.factorisations, 3);
}

TEST(SolidBalance, an_inverted_cell_is_named) {
  Pressing pressing;
  pressing.glass.mesh.nodes[pressing.glass.mesh.cells[5][13]][2] += side;
  SolidStepMatrix matrix;
  const StepOutcome end = advance(pressing.problem(), 0, pressing.temperature, 0.1, {}, matrix);
  EXPECT_FALSE(end.converged);
  EXPECT_NE(end.reason.find("cell 5 of body 0"), std::string::npos) << end.reason;
}

}  // namespace
}  // namespace parison::thermal::test
