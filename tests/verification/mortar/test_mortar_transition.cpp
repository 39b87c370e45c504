// SPDX-License-Identifier: GPL-3.0-or-later
// Contact that closes, spreads, shrinks and opens between the steps of a transient run.
#include <set>

#include "contact/conductance/conductance.hpp"
#include "figure.hpp"
#include "forming/flow/material.hpp"
#include "mortar_cases.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::mortar_test {
namespace {

constexpr double radius = 0.02, dome = 1e-4, transition_gap = 50e-6;

/// Glass at 1150 degC over two domed tools at 485 degC, an inner disc and an outer ring that meet between glass nodes
/// and rise and fall out of time; all insulated. Contact spreads from the middle of the dome outwards.
struct Press {
  thermal::Material glass{2500, core::constant(1282), core::constant(2.77), {}};
  thermal::Material steel{7800, core::constant(620), core::constant(37), {}};
  contact::PressureViscosityConductance law;
  flow::Viscosity viscosity{-2.309, 3922, 564.15, {}};
  core::Mesh upper;
  std::array<core::Mesh, 2> tool;
  std::vector<Eigen::VectorXd> temperature;
  thermal::StepMatrix matrix;
  double initial_substep = 0;

  static double height(double r) { return -dome * r * r / (radius * radius); }
  Press(int glass_edges, int tool_edges) {
    const double seam = 0.0117;
    const auto domed = [](const Point& x) { return Point(x[0], x[1] + height(x[0])); };
    upper = thermal::test::rectangle(divide(0, radius, glass_edges), divide(0, 0.02, 10, 1.4));
    auto below = divide(0, -0.03, 9, 1.4);
    std::reverse(below.begin(), below.end());
    tool = {mapped(divide(0, seam, tool_edges), below, domed), mapped(divide(seam, radius, tool_edges), below, domed)};
    temperature = {Eigen::VectorXd::Constant(upper.node_count(), 1423),
                   Eigen::VectorXd::Constant(tool[0].node_count(), 758),
                   Eigen::VectorXd::Constant(tool[1].node_count(), 758)};
  }
  Press(const Press&) = delete;

  thermal::StepOutcome step(const std::array<double, 2>& lift, double dt, std::set<Index>& touching) {
    std::array<core::Mesh, 2> moved = tool;
    std::vector<contact::Master> masters;
    Eigen::VectorXd pressure = Eigen::VectorXd::Zero(upper.node_count());
    for (const Index t : {0, 1}) {
      for (Point& x : moved[t].nodes) x[1] += lift[t];
      const double from = moved[t].nodes.front()[0], to = t == 0 ? tool[1].nodes.front()[0] : radius;
      const Eigen::VectorXd gap = thermal::test::sample(upper, [&](const Point& x) {
        const double foot = std::clamp(x[0], from, to);
        return std::hypot(x[0] - foot, x[1] - height(foot) - lift[t]) * (x[1] < height(foot) + lift[t] ? -1 : 1);
      });
      for (Index i = 0; i < gap.size(); ++i)
        if (upper.nodes[i][1] == 0) pressure[i] = std::max(pressure[i], -5e9 * gap[i]);
      masters.push_back(
          {contact::make_surface(1 + t, moved[t], {false, false, true, false}, Point::Zero()), gap, transition_gap, 0});
    }
    thermal::Problem problem{
        Geometry::axisymmetric,
        {thermal::test::body(upper, glass), thermal::test::body(moved[0], steel), thermal::test::body(moved[1], steel)},
        {},
        {}};
    const auto slave = contact::make_surface(0, upper, {true, false, false, false}, Point::Zero());
    problem.interface = contact::build_interface(slave, pressure, masters, problem.geometry);
    problem.law = thermal::test::pointwise([&](const core::InterfacePoint& point, double T) {
      const auto value = contact::conductance(law, point.pressure, viscosity(T));
      return core::Conductance{value.h, value.dh_deta * viscosity.derivative(T)};
    });
    touching.clear();
    for (const auto& point : problem.interface) touching.insert(point.slave_nodes.begin(), point.slave_nodes.end());
    thermal::StepOptions options;
    options.initial_substep = initial_substep;
    auto outcome = thermal::advance(problem, 0, temperature, dt, options, matrix);
    temperature = outcome.temperature;
    initial_substep = outcome.next_substep;
    return outcome;
  }
  double heat() const {
    double sum = 0;
    const std::array<const core::Mesh*, 3> meshes{&upper, &tool[0], &tool[1]};
    for (const Index b : {0, 1, 2}) {
      const auto view = thermal::test::body(*meshes[b], b == 0 ? glass : steel);
      sum += thermal::heat_content(view, Geometry::axisymmetric, temperature[b]);
    }
    return sum;
  }
};

void expect_conserved(int glass_edges, int tool_edges) {
  Press press(glass_edges, tool_edges);
  const double whole = press.heat();
  double exchanged = 0, lost = 0, mismatch = 0;
  Index substeps = 0, rejected = 0, solves = 0, factorisations = 0, max_substeps = 0, joined = 0, left = 0, closed = 0;
  std::set<Index> before, now;
  for (int i = 0; i < 40; ++i) {
    const double t = i / 20.0;  // twice closed and open
    const auto outcome =
        press.step({-40e-6 + 2.4e-4 * std::sin(2 * M_PI * t), -40e-6 + 2.4e-4 * std::sin(2 * M_PI * t - 1)}, 0.05, now);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    for (const Index node : now) joined += before.count(node) == 0;
    for (const Index node : before) left += now.count(node) == 0;
    before = now;
    closed += !now.empty();
    if (!now.empty()) mismatch = std::max(mismatch, flux_mismatch(outcome.balance));
    for (const auto& pair : outcome.balance.pairs) exchanged += std::abs(pair.heat);
    lost = std::max(lost, std::abs(press.heat() - whole));
    substeps += outcome.substeps;
    rejected += outcome.rejected;
    solves += outcome.solves;
    factorisations += outcome.factorisations;
    max_substeps = std::max(max_substeps, outcome.substeps);
  }
  std::printf(
      "%d/2x%d edges: %d nodes joined, %d left, in contact in %d of 40 steps; heat exchanged %.0f J, total "
      "changed by %.1e J of %.0f J; flux out against in %.1e\n",
      glass_edges, tool_edges, joined, left, closed, exchanged, lost, whole, mismatch);
  std::printf("  %d substeps (%d at most in a step), %d rejected, %.1f solves a substep, %d factorisations\n", substeps,
              max_substeps, rejected, double(solves) / (substeps + rejected), factorisations);
  EXPECT_GT(exchanged, 1000);
  EXPECT_GT(std::min(joined, left), 2 * glass_edges);
  EXPECT_LT(closed, 40);
  EXPECT_GT(mismatch, 0);
  const std::string meshes =
      fmt::format("contact that opens and closes, {} against {} edges: ", glass_edges, 2 * tool_edges);
  tests::expect_at_most(meshes + "change of the total heat", lost / whole, 1e-12);
  tests::expect_at_most(meshes + "flux out against flux in at every step", mismatch, 1e-13);
  EXPECT_LT(max_substeps, 40);
  EXPECT_LT(solves, 16 * (substeps + rejected));
}

TEST(MortarTransition, contact_that_opens_and_closes_neither_makes_nor_destroys_heat) {
  expect_conserved(14, 5);
  expect_conserved(5, 14);
}

}  // namespace
}  // namespace parison::mortar_test
