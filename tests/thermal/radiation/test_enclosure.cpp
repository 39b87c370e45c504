// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that see each other, in the heat equations.
#include <gtest/gtest.h>

#include <cstdio>

#include "figure.hpp"
#include "thermal/radiation/glass_on_tool.hpp"
#include "thermal/time/step_matrix.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

enum class Glass { grey, transfer };

/// A disc of glass above a tool; the interface closes a little of it, as if a drop hung down.
struct GlassAboveTool : GlassOnTool {
  GlassAboveTool(Geometry geometry, Glass kind, double gap = 0.004, double closed = 0.2,
                 const std::vector<Band>& bands = flint, double index = 1.518)
      : GlassOnTool(geometry, bands, 320, 0.9, Model::transfer) {
    glass.radiation->refractive_index = index;
    if (kind == Glass::grey) glass.radiation.reset();
    for (BodyView& view : problem.bodies) {
      view.light.surroundings.assign(4, core::TimeFunction(320));
      view.light.surroundings[left].reset();
      view.exchange.assign(4, SurfaceExchange{40, 320, has_light(*view.material) ? 0 : view.light.emissivity, 320});
      view.exchange[left].reset();
    }
    problem.bodies[1].light.offset = -gap;
    problem.enclosure = true;
    if (closed == 0) problem.interface.clear();
    for (auto& point : problem.interface) point.contact_weight = closed;
  }
};

TEST(Enclosure, nothing_flows_where_all_is_at_one_temperature) {
  for (const Glass kind : {Glass::grey, Glass::transfer}) {
    const GlassAboveTool pair(Geometry::axisymmetric, kind);
    const HeatSystem system = make_heat_system(pair.problem);
    ASSERT_FALSE(system.enclosure->patches.empty());
    const double scale = evaluate_flows(system, 0, Eigen::VectorXd::Constant(system.size(), 1400)).to_air.maxCoeff();
    const Response response = evaluate(system, 0, Eigen::VectorXd::Constant(system.size(), 320));
    EXPECT_GT(scale, 10);
    EXPECT_LT(response.power.lpNorm<Eigen::Infinity>(), 1e-11 * scale);
    EXPECT_LT(response.flows.from_enclosure.lpNorm<Eigen::Infinity>(), 1e-11 * scale);
  }
}

TEST(Enclosure, the_derivative_is_that_of_finite_differences) {
  const double step = 0.5, small = 1e-2;
  for (const Glass kind : {Glass::grey, Glass::transfer}) {
    const GlassAboveTool pair(Geometry::axisymmetric, kind);
    const HeatSystem system = make_heat_system(pair.problem);
    const Eigen::VectorXd T = scattered(system, pair.start);
    std::mt19937 random(2);
    Eigen::VectorXd direction(system.size());
    for (double& d : direction) d = std::uniform_real_distribution<double>(-1, 1)(random);
    const auto residual = [&](double shift) -> Eigen::VectorXd {
      const Response response = evaluate(system, 0, T + shift * direction);
      return response.content - step * response.power;
    };
    const Eigen::VectorXd difference = (residual(small) - residual(-small)) / (2 * small);
    Linearisation derivatives = linearise(system, 0, T);
    const Eigen::VectorXd product = apply(system, derivatives, step, direction);
    const double size = difference.lpNorm<Eigen::Infinity>();
    EXPECT_LT((product - difference).lpNorm<Eigen::Infinity>(), 1e-7 * size);
    derivatives.enclosure.setZero();
    if (kind == Glass::transfer) derivatives.light[0].from_surfaces[1].setZero();
    EXPECT_GT((apply(system, derivatives, step, direction) - product).lpNorm<Eigen::Infinity>(), 1e-6 * size);
  }
}

TEST(Enclosure, a_step_of_ten_seconds_converges_and_is_balanced) {
  tests::Figure open("heat balance of a step of 10 s with an enclosure, over the content's change: open by");
  for (const Glass kind : {Glass::grey, Glass::transfer}) {
    const GlassAboveTool pair(Geometry::axisymmetric, kind);
    StepMatrix matrix;
    StepOptions options;
    options.tolerance = 1e9;
    const StepOutcome outcome = advance(pair.problem, 0, pair.start, 10, options, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    EXPECT_EQ(outcome.substeps, 1);
    EXPECT_GT(outcome.balance.bodies[1].from_enclosure, 0);
    for (const Index b : {0, 1})
      open.add(std::abs(imbalance(outcome.balance, b) / outcome.balance.bodies[b].content_change));
  }
  open.at_most(1e-9);
}

TEST(Enclosure, the_order_in_time_is_two) {
  tests::Figure order("heat with an enclosure: order in time of TR-BDF2");
  for (const Glass kind : {Glass::grey, Glass::transfer}) {
    const GlassAboveTool pair(Geometry::axisymmetric, kind);
    std::vector<Eigen::VectorXd> found;
    for (const int substeps : {8, 16, 32, 128}) {
      StepMatrix matrix;
      StepOptions options;
      options.tolerance = 1e9;
      options.initial_substep = options.max_substep = 0.5 / substeps;
      const StepOutcome outcome = advance(pair.problem, 0, pair.start, 0.5, options, matrix);
      ASSERT_TRUE(outcome.converged) << outcome.reason;
      found.push_back(outcome.temperature[0]);
    }
    const auto error = [&](int i) { return (found[i] - found[3]).lpNorm<Eigen::Infinity>(); };
    order.add(std::log2(error(1) / error(2)));
  }
  order.at_least(1.8);
}

/// Light that comes to each body from the others, W.
Eigen::VectorXd enclosed(const Problem& problem, double glass, double tool) {
  const HeatSystem system = make_heat_system(problem);
  Eigen::VectorXd T = Eigen::VectorXd::Constant(system.size(), tool);
  T.head(system.first_unknown[1]).setConstant(glass);
  return evaluate_flows(system, 0, T).from_enclosure;
}

TEST(Enclosure, two_plates_close_together_exchange_as_grey_walls_do) {
  // Cold surroundings of all but 0 K, so that what comes from the other wall is all that comes.
  GlassAboveTool pair(Geometry::planar, Glass::grey, 2e-5, 0);
  for (BodyView& view : pair.problem.bodies)
    for (const Side side : {bottom, right, top}) {
      view.light.surroundings[side] = core::TimeFunction(1);
      view.exchange[side]->ambient_temperature = core::TimeFunction(1);
    }
  const Eigen::VectorXd heat = enclosed(pair.problem, 1400, 740);
  const double E1 = stefan_boltzmann * std::pow(1400, 4), E2 = stefan_boltzmann * std::pow(740, 4), area = 0.02;
  // Net exchange of the tool: what it receives less what it emits.
  const double net = heat[1] - 0.8 * area * E2, exact = area * (E1 - E2) / (1 / 0.9 + 1 / 0.8 - 1);
  tests::expect_at_most("two grey plates a thousandth of their width apart, infinite plates: heat off by",
                        100 * std::abs(net / exact - 1), 0.3, "%");
}

TEST(Enclosure, black_glass_by_rays_sends_the_tool_what_an_opaque_black_surface_sends) {
  GlassAboveTool by_rays(Geometry::axisymmetric, Glass::transfer, 0.004, 0, {{everything, 2000}}, 1);
  GlassAboveTool opaque(Geometry::axisymmetric, Glass::grey, 0.004, 0);
  opaque.problem.bodies[0].light.emissivity = 1;
  for (const Side side : {bottom, right, top}) opaque.problem.bodies[0].exchange[side]->emissivity = 1;
  const Eigen::VectorXd a = enclosed(by_rays.problem, 1400, 740), b = enclosed(opaque.problem, 1400, 740);
  std::printf("to glass %.4f %.4f W, to tool %.4f %.4f W\n", a[0], b[0], a[1], b[1]);
  EXPECT_NEAR(a[1] / b[1], 1, 0.01);
  EXPECT_NEAR(a[0] / b[0], 1, 0.01);
}

TEST(Enclosure, through_clear_glass_the_tool_sees_the_room) {
  GlassAboveTool clear(Geometry::axisymmetric, Glass::transfer, 0.004, 0, {{everything, 0.1}}, 1);
  GlassAboveTool dark(Geometry::axisymmetric, Glass::transfer, 0.004, 0, {{everything, 2000}}, 1);
  EXPECT_LT(enclosed(clear.problem, 1400, 740)[1], 0.01 * enclosed(dark.problem, 1400, 740)[1]);
  EXPECT_GT(enclosed(clear.problem, 1400, 740)[1], 0);
}

TEST(Enclosure, a_tool_that_is_not_in_place_is_not_seen) {
  GlassAboveTool pair(Geometry::axisymmetric, Glass::grey, 0.004, 0);
  const double seen = enclosed(pair.problem, 1400, 740)[0];
  pair.problem.bodies[1].light.in_place = false;
  pair.problem.bodies[1].light.surroundings.clear();
  EXPECT_GT(seen, 0);
  EXPECT_EQ(enclosed(pair.problem, 1400, 740)[0], 0);
}

TEST(Enclosure, a_cavity_whose_views_cannot_be_closed_is_refused_with_the_place) {
  GlassAboveTool pair(Geometry::axisymmetric, Glass::grey, 0.004, 0);
  core::Mesh inside_out = *pair.problem.bodies[1].mesh;
  double low = 1, high = -1;
  for (const Point& x : inside_out.nodes) low = std::min(low, x[1]), high = std::max(high, x[1]);
  for (Point& x : inside_out.nodes) x[1] = low + high - x[1];
  const core::Mesh* sound = pair.problem.bodies[1].mesh;
  for (const core::Mesh* mesh : {sound, static_cast<const core::Mesh*>(&inside_out)}) {
    pair.problem.bodies[1].mesh = mesh;
    StepMatrix matrix;
    const StepOutcome outcome = advance(pair.problem, 0, pair.start, 0.1, {}, matrix);
    EXPECT_EQ(outcome.converged, mesh == sound) << outcome.reason;
    if (mesh == sound) continue;
    EXPECT_NE(outcome.reason.find("the views of the open surfaces cannot be closed"), std::string::npos)
        << outcome.reason;
    EXPECT_NE(outcome.reason.find("mm, allowed are 1 %"), std::string::npos) << outcome.reason;
  }
}

/// Light between a cup of glass and a rod in it, by a mesh of its own.
Eigen::VectorXd cup_and_rod(int along, int across) {
  const Material glass{2400, core::constant(1300), core::constant(1.3), {}},
      iron{7200, core::constant(500), core::constant(40), {}};
  const core::Mesh wall = rectangle(divide(0.02, 0.025, across), divide(0, 0.08, along)),
                   rod = rectangle(divide(0, 0.012, 3), divide(0, 0.05, along - 3));
  Problem problem{Geometry::axisymmetric, {open_body(wall, glass, 320), open_body(rod, iron, 320, 0.8)}, {}, {}};
  problem.bodies[1].light.surroundings[left].reset();
  problem.enclosure = true;
  const HeatSystem system = make_heat_system(problem);
  const auto warm = [](const Point& x) { return 1200 + 3e3 * x[1]; };
  return evaluate_flows(system, 0, join(system, {sample(wall, warm), Eigen::VectorXd::Constant(rod.node_count(), 700)}))
      .from_enclosure;
}

TEST(Enclosure, another_mesh_changes_the_heat_rates_by_little) {
  tests::Figure off("enclosure: light between a tube and a rod by four meshes: off from that of the finest by", "%");
  const Eigen::VectorXd reference = cup_and_rod(60, 6);
  for (const auto& [along, across] : {std::pair<int, int>{24, 2}, {31, 3}, {45, 4}})
    for (const Index b : {0, 1}) off.add(100 * std::abs(cup_and_rod(along, across)[b] / reference[b] - 1));
  off.at_most(0.3);
}

/// Light that comes to hot glass from itself, W, of rectangles of which some sides may be planes of symmetry.
struct Part {
  double x[2], z[2];
  std::vector<Side> symmetric = {};
};
double light_of_itself(Geometry geometry, const std::vector<Part>& parts) {
  const Material glass{2400, core::constant(1300), core::constant(1.3), {}};
  std::vector<core::Mesh> meshes;
  for (const Part& part : parts) {
    meshes.push_back(rectangle(divide(part.x[0], part.x[1], 4), divide(part.z[0], part.z[1], 16)));
    for (const Side side : part.symmetric) meshes.back().edit().boundaries[side].kind = core::BoundaryKind::symmetry;
  }
  Problem problem{geometry, {}, {}, {}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    problem.bodies.push_back(open_body(meshes[i], glass, 1));
    for (const Side side : parts[i].symmetric) problem.bodies.back().light.surroundings[side].reset();
  }
  problem.enclosure = true;
  const HeatSystem system = make_heat_system(problem);
  return evaluate_flows(system, 0, Eigen::VectorXd::Constant(system.size(), 1000)).from_enclosure.sum();
}

TEST(Enclosure, planes_of_symmetry_are_mirrors) {
  const auto compare = [](Geometry geometry, double share, const std::vector<Part>& part,
                          const std::vector<Part>& whole) {
    const double alone = light_of_itself(geometry, part), all = light_of_itself(geometry, whole);
    ASSERT_GT(all, 0);
    EXPECT_NEAR(alone / (share * all), 1, 0.005);
  };
  const Part wall{{0.02, 0.025}, {0, 0.04}, {bottom}}, rod{{0, 0.005}, {0.01, 0.03}, {left}};
  compare(Geometry::planar, 0.25, {wall, rod},
          {{{0.02, 0.025}, {-0.04, 0.04}},
           {{-0.025, -0.02}, {-0.04, 0.04}},
           {{-0.005, 0.005}, {0.01, 0.03}},
           {{-0.005, 0.005}, {-0.03, -0.01}}});
  compare(Geometry::axisymmetric, 0.5, {wall, rod},
          {{{0.02, 0.025}, {-0.04, 0.04}}, rod, {{0, 0.005}, {-0.03, -0.01}, {left}}});
}

}  // namespace
}  // namespace parison::thermal::test
