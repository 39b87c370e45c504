// SPDX-License-Identifier: GPL-3.0-or-later
// Patch test.
#include "figure.hpp"
#include "mortar_cases.hpp"

namespace parison::mortar_test {
namespace {

struct Shape {
  const char* name;
  Map map;
  std::vector<double> joints;  ///< columns that both meshes have
};

double roof(double x) {
  return x < 0.3 ? 0.4 * x : x < 0.65 ? 0.12 - 0.25 * (x - 0.3) : 0.0325 + 0.7 * (x - 0.65);
}

const std::vector<Shape> shapes{
    {"flat", [](const Point& x) { return x; }, {0, 1}},
    {"tilted", [](const Point& x) { return Point(0.2 + 0.9 * x[0] - 0.3 * x[1], 0.3 * x[0] + 0.9 * x[1]); }, {0, 1}},
    {"faceted", [](const Point& x) { return Point(x[0], x[1] + roof(x[0])); }, {0, 0.3, 0.65, 1}}};

/// Columns between the joints, `count` in all or a little more, unevenly spaced.
std::vector<double> columns(const std::vector<double>& joints, int count, double growth) {
  std::vector<double> x{joints[0]};
  for (std::size_t i = 1; i < joints.size(); ++i) {
    const int n = std::max(1, static_cast<int>(std::lround(count * (joints[i] - joints[i - 1]))));
    const auto part = divide(joints[i - 1], joints[i], n, growth);
    x.insert(x.end(), part.begin() + 1, part.end());
  }
  return x;
}

/// Largest error relative to the temperature's range.
double patch_error(const Shape& shape, Geometry geometry, int first, int second, Index slave) {
  const std::array<double, 2> k{2.77, 37};
  Pair pair(geometry, mapped(columns(shape.joints, first, 1.1), divide(0, 0.5, 2), shape.map),
            mapped(columns(shape.joints, second, 0.93), divide(-0.5, 0, 2), shape.map), k);
  // Heat flows down through the contact; across it too where depth is not a ring.
  const Point q(geometry == Geometry::planar ? 150 : 0, -1000);
  const auto exact = [&](Index b, const Point& x) { return (b == 0 ? 1150 : 485) - q.dot(x) / k[b]; };
  const double sign = slave == 0 ? 1 : -1;  // h from the exact flux and jump, whatever they are
  pair.join(
      slave, 1e-3, [](const Point&) { return 0.0; }, [](const Point&) { return 1e5; });
  pair.problem.law = thermal::test::pointwise([&](const core::InterfacePoint& point, double) {
    const double flux = sign * q.dot(facet_normal(pair.mesh[slave], point));
    return core::Conductance{flux / (exact(0, point.position) - exact(1, point.position)), 0};
  });
  std::vector<Eigen::VectorXd> start;
  for (const Index b : {0, 1}) {
    pair.add_flux(b, pair.free_sides(b), [&](const Point&, const Point& normal) { return -q.dot(normal); });
    start.push_back(thermal::test::sample(pair.mesh[b], [&](const Point& x) { return exact(b, x); }));
  }
  const Solved solved = solve(pair, start, 10);
  double error = 0, low = 1e9, high = -1e9;
  for (const Index b : {0, 1}) {
    error = std::max(error, (solved.temperature[b] - start[b]).lpNorm<Eigen::Infinity>());
    low = std::min(low, start[b].minCoeff());
    high = std::max(high, start[b].maxCoeff());
  }
  return error / (high - low);
}

TEST(MortarPatch, a_linear_temperature_passes_any_straight_interface_to_round_off) {
  tests::Figure patch(
      "patch test, flat, tilted and faceted, planar and axisymmetric, both roles, of the temperature range");
  for (const auto geometry : {Geometry::planar, Geometry::axisymmetric})
    for (const Shape& shape : shapes) {
      double largest = 0;
      for (const auto& [first, second] :
           {std::pair{20, 20}, {20, 7}, {7, 20}, {20, 13}, {13, 20}, {3, 17}, {1, 9}, {9, 1}, {4, 4}})
        for (const Index slave : {0, 1})
          largest = std::max(largest, patch_error(shape, geometry, first, second, slave));
      std::printf("patch, %s, %s: %.1e of the temperature range\n", shape.name,
                  geometry == Geometry::planar ? "planar" : "axisymmetric", largest);
      patch.add(largest);
    }
  patch.at_most(1e-11);
}

}  // namespace
}  // namespace parison::mortar_test
