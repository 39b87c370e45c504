// SPDX-License-Identifier: GPL-3.0-or-later
// Glass on steel.
#include <gtest/gtest.h>

#include "figure.hpp"
#include "thermal/bodies.hpp"
#include "thermal/time/ida.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

constexpr double radius = 0.02, celsius = 273.15;
struct Row {
  double time, glass, steel, heat;
};
/// Exact for the finite heights: degC and J/m2.
const std::vector<Row> exact{{0.5, 785.5102, 566.1886, 763661},
                             {1, 742.0877, 575.8608, 1236161},
                             {2, 706.4829, 583.7917, 1941847},
                             {5, 671.5318, 591.5769, 3393853},
                             {10, 652.8883, 595.7298, 5060352}};

/// The paper's two cylinders, graded to the interface at z = 0.
struct Cylinders {
  Material glass{2500, core::constant(1282), core::constant(2.77), {}};
  Material steel{7800, core::constant(620), core::constant(37), {}};
  core::Mesh upper, lower;
  Problem problem;
  std::vector<Eigen::VectorXd> start;

  Cylinders(int across, int along, double growth) {
    std::vector<double> below = divide(0, -0.03, along, growth);
    std::reverse(below.begin(), below.end());
    upper = rectangle(divide(0, radius, across), divide(0, 0.02, along, growth));
    lower = rectangle(divide(0, radius, across), below);
    problem.geometry = core::Geometry::axisymmetric;
    problem.bodies = {body(upper, glass), body(lower, steel)};
    problem.interface = stack(upper, lower, problem.geometry);
    problem.law = constant_conductance(5000);
    start = {Eigen::VectorXd::Constant(upper.node_count(), 1150 + celsius),
             Eigen::VectorXd::Constant(lower.node_count(), 485 + celsius)};
  }
  Cylinders(const Cylinders&) = delete;

  /// Largest deviation along the contact.
  double deviation(Index which, const Eigen::VectorXd& temperature, double expected) const {
    const core::Mesh& mesh = which == 0 ? upper : lower;
    double largest = 0;
    for (Index i = 0; i < mesh.node_count(); ++i)
      if (std::abs(mesh.nodes[i][1]) < 1e-12)
        largest = std::max(largest, std::abs(temperature[i] - celsius - expected));
    return largest;
  }
  /// Worst deviation of both sides; the heat is compared at once.
  double compare(const Row& row, const std::vector<Eigen::VectorXd>& temperature, double heat) const {
    const double area = M_PI * radius * radius;
    EXPECT_NEAR(heat / area / row.heat, 1, 2e-4) << row.time;
    return std::max(deviation(0, temperature[0], row.glass), deviation(1, temperature[1], row.steel));
  }
};

TEST(Contact, glass_on_steel_follows_the_exact_solution_by_TR_BDF2) {
  const Cylinders c(4, 40, 1.15);
  tests::Figure off("glass on steel, TR-BDF2: off by", "K");
  StepOptions options;
  options.tolerance = 0.02;
  StepMatrix matrix;
  HeatBalance balance;
  auto temperature = c.start;
  double time = 0;
  for (const Row& row : exact) {
    const StepOutcome outcome = advance(c.problem, 0, temperature, row.time - time, options, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    temperature = outcome.temperature;
    options.initial_substep = outcome.next_substep;
    add(balance, outcome.balance);
    time = row.time;
    off.add(c.compare(row, temperature, balance.pairs[0].heat));
  }
  off.at_most(0.1);
}

TEST(Contact, glass_on_steel_follows_the_exact_solution_by_IDA) {
  const Cylinders c(4, 40, 1.15);
  tests::Figure off("glass on steel, IDA: off by", "K");
  IdaIntegrator integrator(c.problem, 0, c.start, {0.01});
  HeatBalance balance;
  for (const Row& row : exact) {
    const IdaOutcome outcome = integrator.advance_to(row.time);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    add(balance, outcome.balance);
    off.add(c.compare(row, outcome.temperature, balance.pairs[0].heat));
  }
  off.at_most(0.1);
}

/// The interface of two bodies after the upper one slid along the lower.
std::vector<core::InterfacePoint> slid(const std::vector<core::InterfacePoint>& points, const core::Mesh& lower,
                                       int edges) {
  std::vector<core::InterfacePoint> moved = points;
  for (core::InterfacePoint& point : moved)
    for (std::size_t e = 0; e < lower.boundary_edges().size(); ++e)
      if (lower.boundary_edges()[e].nodes[2] == point.master_nodes[2]) {
        const auto& to = lower.boundary_edges()[e + edges];
        if (to.boundary_id == lower.boundary_edges()[e].boundary_id) point.master_nodes = to.nodes;
        break;
      }
  return moved;
}

TEST(Contact, the_pattern_bears_a_slide_by_an_edge_but_not_by_two) {
  Cylinders c(8, 6, 1.15);
  const auto at_rest = c.problem.interface;
  StepMatrix matrix;
  prepare(matrix, make_heat_system(c.problem));
  const auto couplings = matrix.couplings;
  for (const int edges : {1, 2}) {
    c.problem.interface = slid(at_rest, c.lower, edges);
    const StepOutcome kept = advance(c.problem, 0, c.start, 0.05, {}, matrix);
    EXPECT_EQ(matrix.couplings == couplings, edges == 1);
    StepMatrix none, same;
    same.couplings = couplings;
    const StepOutcome again = advance(c.problem, 0, c.start, 0.05, {}, same),
                      fresh = advance(c.problem, 0, c.start, 0.05, {}, none);
    ASSERT_TRUE(kept.converged && again.converged && fresh.converged);
    for (const Index body : {0, 1}) {
      EXPECT_TRUE(kept.temperature[body] ==
                  again.temperature[body]);  // a function of the couplings given, to the last bit
      EXPECT_LT((kept.temperature[body] - fresh.temperature[body]).lpNorm<Eigen::Infinity>(), 1e-8);
    }
  }
}

TEST(Contact, couplings_of_another_mesh_are_dropped) {
  const Cylinders fine(8, 6, 1.15), coarse(4, 6, 1.15);
  StepMatrix matrix;
  prepare(matrix, make_heat_system(fine.problem));
  prepare(matrix, make_heat_system(coarse.problem));
  StepMatrix fresh;
  prepare(fresh, make_heat_system(coarse.problem));
  EXPECT_EQ(matrix.couplings, fresh.couplings);
  EXPECT_EQ(matrix.order, fresh.order);
}

TEST(Contact, coupling_steps_of_50_ms_need_about_one_substep_each) {
  const Cylinders c(4, 40, 1.15);
  StepOptions options;
  StepMatrix matrix;
  auto temperature = c.start;
  HeatBalance balance;
  Index substeps = 0, factorisations = 0;
  for (int step = 0; step < 200; ++step) {
    const StepOutcome outcome = advance(c.problem, 0, temperature, 0.05, options, matrix);
    ASSERT_TRUE(outcome.converged) << outcome.reason;
    temperature = outcome.temperature;
    options.initial_substep = outcome.next_substep;
    add(balance, outcome.balance);
    substeps += outcome.substeps;
    factorisations += outcome.factorisations;
  }
  EXPECT_LT(c.compare(exact.back(), temperature, balance.pairs[0].heat), 0.1);
  EXPECT_LT(substeps, 260);
  EXPECT_LT(factorisations, 60);  // the factor is kept while the step stays
}

}  // namespace
}  // namespace parison::thermal::test
