// SPDX-License-Identifier: GPL-3.0-or-later
// A wedge of round bodies against the same bodies in the plane.
#include <gtest/gtest.h>

#include "contact/solid/solid_mortar.hpp"
#include "figure.hpp"
#include "solid/solid_meshes.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

TEST(SolidRound, a_wedge_of_round_bodies_cools_as_they_do_in_the_plane) {
  const Material glass{2500,
                       {{300, 900, 1500}, {900, 1200, 1400}},
                       {{300, 1500}, {1.0, 2.0}},
                       Radiation{1.5, 600, true, Radiation::Model::rosseland, {}, {}}};
  const Material tool{7800, {{300, 1000}, {450, 600}}, {{300, 1000}, {25, 30}}, {}};
  constexpr double wedge = 0.5, h = 3000;
  const auto upper = rectangle(divide(0, 0.03, 5), divide(0, 0.004, 4, 1.5));
  const auto lower = rectangle(divide(0, 0.03, 5), divide(-0.02, 0, 5, 0.6));
  const SurfaceExchange air{60, 320, 0.8, 350};
  Problem flat{core::Geometry::axisymmetric, {body(upper, glass), body(lower, tool)}, {}, {}};
  flat.bodies[0].exchange[top] = air;
  flat.bodies[1].exchange[bottom] = SurfaceExchange{500, 300, 0, 300};
  flat.interface = stack(upper, lower, flat.geometry);
  flat.law = constant_conductance(h);
  StepMatrix flat_matrix;
  const StepOutcome exact =
      advance(flat, 0,
              {Eigen::VectorXd::Constant(upper.node_count(), 1400), Eigen::VectorXd::Constant(lower.node_count(), 700)},
              1.5, {0.02}, flat_matrix);
  ASSERT_TRUE(exact.converged) << exact.reason;

  const auto solid_upper = core::sweep(upper, 0, wedge, 2), solid_lower = core::sweep(lower, 0, wedge, 3);
  const auto upper_mass = masses(solid_upper, core::prism_table(), glass);
  const auto lower_mass = masses(solid_lower, core::prism_table(), tool);
  SolidProblem solid{{solid_body(solid_upper, upper_mass, glass), solid_body(solid_lower, lower_mass, tool)}, {}, {}};
  solid.bodies[0].exchange.resize(4);
  solid.bodies[1].exchange.resize(4);
  solid.bodies[0].exchange[top] = air;
  solid.bodies[1].exchange[bottom] = flat.bodies[1].exchange[bottom];
  solid.interface =
      contact::build_interface(contact::solid_surface(0, solid_upper.nodes, solid_upper.faces, {bottom}),
                               {{contact::solid_surface(1, solid_lower.nodes, solid_lower.faces, {top}), 0, 1e-4}});
  double area = 0;
  for (const auto& point : solid.interface.points) area += point.area;
  EXPECT_NEAR(area, 0.5 * wedge * 0.03 * 0.03, 1e-4 * area);
  solid.law = constant_solid_conductance(h);
  SolidStepMatrix matrix;
  const StepOutcome end = advance(solid, 0,
                                  {from_section(solid_upper, Eigen::VectorXd::Constant(upper.node_count(), 1400)),
                                   from_section(solid_lower, Eigen::VectorXd::Constant(lower.node_count(), 700))},
                                  1.5, {0.02}, matrix);
  ASSERT_TRUE(end.converged) << end.reason;
  tests::Figure off("wedge of round bodies against the plane: off by", "K"), heat("heat there: off by"),
      rim("the same towards the rim, where both meshes end in other chords: off by", "K");
  const auto compare = [&](const core::PrismMesh& mesh, const core::Mesh& section, Index b) {
    for (Index n = 0; n < mesh.node_count(); ++n) {
      const Index from = mesh.section_node[n];
      (section.nodes[from][0] < 0.025 ? off : rim).add(std::abs(end.temperature[b][n] - exact.temperature[b][from]));
    }
  };
  compare(solid_upper, upper, 0);
  compare(solid_lower, lower, 1);
  const double share = wedge / (2 * M_PI);
  heat.add(std::abs(end.balance.pairs[0].heat / (share * exact.balance.pairs[0].heat) - 1));
  heat.add(std::abs(end.balance.bodies[0].to_air / (share * exact.balance.bodies[0].to_air) - 1));
  off.at_most(0.2);
  rim.at_most(2);
  heat.at_most(1e-4);
}

}  // namespace
}  // namespace parison::thermal::test
