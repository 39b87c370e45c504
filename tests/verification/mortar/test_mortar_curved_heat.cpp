// SPDX-License-Identifier: GPL-3.0-or-later
// Steady heat through curved contact: a sphere in a spherical cup, a cylinder in a sleeve.
#include "figure.hpp"
#include "mortar_cases.hpp"

namespace parison::mortar_test {
namespace {

constexpr double inner = 0.02, contact_radius = 0.03, outer = 0.045, h = 5000;
const std::array<double, 2> k{2.77, 37};

/// Angle and minus the radius to a place; angle 0 points down the axis.
Point around(const Point& x) {
  return -x[1] * Point(std::sin(x[0]), -std::cos(x[0]));
}

/// How the meshes differ from touching ones.
struct Flaws {
  bool chords = false;            ///< all edges straight
  double gap = 0;                 ///< the outer body is this much wider, m; negative: the bodies overlap
  double transition_gap = 50e-6;  ///< m
};

/// Heat from the inner body, 1150 degC inside, to the outer, 485 degC outside; the contact is `first` against `second`
/// edges. A sphere turns round the axis; a cylinder, a quarter of it, is planar.
double heat_across(Geometry geometry, int first, int second, Index slave, const Flaws& flaws = {}) {
  const double end = geometry == Geometry::axisymmetric ? M_PI : M_PI / 2;
  const auto widened = [&](const Point& x) { return around({x[0], x[1] - flaws.gap}); };
  core::Mesh ball = mapped(divide(0, end, first), divide(-contact_radius, -inner, 8), around);
  core::Mesh cup = mapped(divide(0, end, second), divide(-outer, -contact_radius, 8), widened);
  if (flaws.chords) ball = faceted(ball), cup = faceted(cup);
  Pair pair(geometry, ball, cup, k);
  const double facing = slave == 0 ? contact_radius + flaws.gap : contact_radius;  // the master's exact profile
  const double sign = slave == 0 ? 1 : -1;
  pair.join(
      slave, flaws.transition_gap, [&](const Point& x) { return sign * (facing - x.norm()); },
      [](const Point&) { return 1e5; });
  pair.problem.law = thermal::test::constant_conductance(h);
  pair.problem.bodies[0].prescribed[Side::top] = 1423;
  pair.problem.bodies[1].prescribed[Side::bottom] = 758;
  std::vector<Eigen::VectorXd> start;
  for (const auto& mesh : pair.mesh) start.push_back(Eigen::VectorXd::Constant(mesh.node_count(), 1000));
  return sign * solve(pair, start, 1e3).flows.across.sum();
}

double exact_heat(Geometry geometry) {
  if (geometry == Geometry::axisymmetric)
    return 4 * M_PI * (1423 - 758) /
           ((1 / inner - 1 / contact_radius) / k[0] + 1 / (h * contact_radius * contact_radius) +
            (1 / contact_radius - 1 / outer) / k[1]);
  return M_PI / 2 * (1423 - 758) /
         (std::log(contact_radius / inner) / k[0] + 1 / (h * contact_radius) + std::log(outer / contact_radius) / k[1]);
}

const char* name(Geometry geometry) {
  return geometry == Geometry::axisymmetric ? "sphere in a cup" : "cylinder in a sleeve";
}

TEST(MortarCurved, the_exact_heat_crosses_three_to_one_both_ways_to_a_thousandth) {
  tests::Figure heat("sphere in a cup, cylinder in a sleeve, 3:1 both ways: heat off by");
  for (const auto geometry : {Geometry::axisymmetric, Geometry::planar})
    for (const auto& [first, second] : {std::pair{6, 18}, {18, 6}, {12, 36}, {36, 12}})
      for (const Index slave : {0, 1}) {
        const double error = heat_across(geometry, first, second, slave) / exact_heat(geometry) - 1;
        std::printf("%s, %d/%d edges, slave %s: heat off by %.1e\n", name(geometry), first, second,
                    slave == 0 ? "inside" : "outside", error);
        heat.add(std::abs(error));
      }
  heat.at_most(1e-3);
}

TEST(MortarCurved, gaps_and_overlaps_to_a_micrometre_change_the_heat_by_less_than_a_thousandth) {
  tests::Figure change("the same: gaps and overlaps of 1e-15 to 1e-6 m change the heat by");
  for (const auto geometry : {Geometry::axisymmetric, Geometry::planar})
    for (const auto& [first, second] : {std::pair{8, 24}, {24, 8}})
      for (const Index slave : {0, 1}) {
        const double touching = heat_across(geometry, first, second, slave);
        double largest = 0;
        for (const double size : {1e-15, 1e-13, 1e-11, 1e-9, 1e-8, 1e-7, 1e-6})
          for (const double gap : {size, -size})
            largest =
                std::max(largest, std::abs(heat_across(geometry, first, second, slave, {false, gap}) / touching - 1));
        std::printf("%s, %d/%d edges, slave %s: gaps and overlaps to 1e-6 m change the heat by %.1e\n", name(geometry),
                    first, second, slave == 0 ? "inside" : "outside", largest);
        change.add(largest);
      }
  change.at_most(1e-3);
}

/// Chords part and overlap by their sagitta, 0.02 to 0.6 mm here against a transition of 10 um: were contact lost
/// there, most of the heat would be. The same chords with a transition of 10 mm, which never opens, are the measure.
TEST(MortarCurved, chords_that_part_or_overlap_by_their_sagitta_keep_the_heat) {
  tests::Figure change("the same: chords that part by more than the transition change the heat by");
  for (const auto geometry : {Geometry::axisymmetric, Geometry::planar})
    for (const auto& [first, second] : {std::pair{10, 10}, {9, 13}, {8, 24}, {24, 8}})
      for (const Index slave : {0, 1}) {
        const double closed = heat_across(geometry, first, second, slave, {true, 0, 0.01});
        const double heat = heat_across(geometry, first, second, slave, {true, 0, 10e-6});
        std::printf("%s, %d/%d chords, slave %s: heat changes by %.1e\n", name(geometry), first, second,
                    slave == 0 ? "inside" : "outside", heat / closed - 1);
        change.add(std::abs(heat / closed - 1));
      }
  change.at_most(1e-3);
}

}  // namespace
}  // namespace parison::mortar_test
