// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "flow_case.hpp"

namespace parison::flow {
namespace {

using core::dim;
using core::Geometry;
using Real = long double;
using Vector = std::array<Real, dim>;

/// A smooth flow without divergence, its pressure and its viscosity, and whether points lie on rings around the axis.
struct Manufactured {
  bool rings;
  std::function<Vector(const Vector&)> velocity;
  std::function<Real(const Vector&)> pressure, viscosity;
};

/// Derivative of f along a coordinate: central differences of fourth order.
template <class F>
Real along(const F& f, Vector x, int axis) {
  constexpr Real h = 1e-3L;
  const auto at = [&](Real step) {
    Vector y = x;
    y[axis] += step;
    return f(y);
  };
  return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
}

Real hoop_rate(const Manufactured& flow, const Vector& x) {
  return flow.rings ? flow.velocity(x)[0] / x[0] : 0;
}

Real gradient(const Manufactured& flow, const Vector& x, int component, int axis) {
  return along([&](const Vector& y) { return flow.velocity(y)[component]; }, x, axis);
}

Real stress(const Manufactured& flow, const Vector& x, int i, int j) {
  const Real shear = flow.viscosity(x) * (gradient(flow, x, i, j) + gradient(flow, x, j, i));
  return shear - (i == j ? flow.pressure(x) : 0);
}

/// What must push the glass for it to flow so: -div stress.
Point force(const Manufactured& flow, const Point& at) {
  const Vector x{at[0], at[1]};
  Point result = Point::Zero();
  for (int i = 0; i < dim; ++i) {
    for (int j = 0; j < dim; ++j)
      result[i] -= double(along([&](const Vector& y) { return stress(flow, y, i, j); }, x, j));
    if (flow.rings) result[i] -= double(stress(flow, x, i, 0) / x[0]);
  }
  if (flow.rings) result[0] += double((2 * flow.viscosity(x) * hoop_rate(flow, x) - flow.pressure(x)) / x[0]);
  return result;
}

ExactFlow exact_of(const Manufactured& flow) {
  return {[=](const Point& x) {
            const Vector v = flow.velocity({x[0], x[1]});
            return Point(double(v[0]), double(v[1]));
          },
          [=](const Point& x) {
            return double(flow.pressure({x[0], x[1]}));
          }};
}

/// Errors on a bent square of n x n; where points lie on rings its left side is the axis.
FlowErrors solve_manufactured(const Manufactured& flow, Index n) {
  const auto map = [](double s, double t) { return Point(s * (1 + 0.2 * t * t), t + 0.15 * s * s); };
  FlowProblem problem(tests::structured(n, n, map), flow.rings ? Geometry::axisymmetric : Geometry::planar);
  problem.hold_all(BoundaryCondition::Kind::fixed);
  const auto exact = exact_of(flow);
  for (auto& boundary : problem.problem.boundary_conditions) boundary.velocity = exact.velocity;
  if (flow.rings) problem.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  problem.problem.viscosity = [&](const Point& x) { return double(flow.viscosity({x[0], x[1]})); };
  problem.problem.force = [&](const Point& x) { return force(flow, x); };
  const auto solution = problem.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  return flow_errors(problem, solution, exact);
}

void expect_orders(const char* name, const Manufactured& flow) {
  for (const Vector x : {Vector{0.3L, 0.4L}, Vector{0.9L, 0.1L}})
    EXPECT_LT(std::abs(double(gradient(flow, x, 0, 0) + gradient(flow, x, 1, 1) + hoop_rate(flow, x))), 1e-9);
  FlowErrors last;
  for (const Index n : {8, 16, 32}) {
    const auto errors = solve_manufactured(flow, n);
    const double velocity = std::log2(last.velocity / errors.velocity),
                 pressure = std::log2(last.pressure / errors.pressure);
    std::printf("%s, %2d x %2d: velocity %.3e (order %.2f), pressure %.3e (order %.2f)\n", name, n, n, errors.velocity,
                velocity, errors.pressure, pressure);
    if (n == 32) {
      tests::expect_at_least(fmt::format("manufactured flow, {}: order of the velocity", name), velocity, 2.9);
      tests::expect_at_least(fmt::format("manufactured flow, {}: order of the pressure", name), pressure, 1.9);
    }
    last = errors;
  }
}

TEST(ManufacturedFlow, planar_velocity_is_of_third_order_and_pressure_of_second) {
  // Stream function sin(2x) cos(3y) + x y^2.
  expect_orders("planar", {false,
                           [](const Vector& x) {
                             return Vector{-3 * std::sin(2 * x[0]) * std::sin(3 * x[1]) + 2 * x[0] * x[1],
                                           -2 * std::cos(2 * x[0]) * std::cos(3 * x[1]) - x[1] * x[1]};
                           },
                           [](const Vector& x) { return 3 * std::cos(2 * x[0] + x[1]); },
                           [](const Vector& x) { return std::exp(x[0] - 2 * x[1]); }});
}

TEST(ManufacturedFlow, axisymmetric_velocity_is_of_third_order_and_pressure_of_second) {
  // Stokes stream function r^2 sin(2z) cos(r^2).
  expect_orders("axisymmetric", {true,
                                 [](const Vector& x) {
                                   const Real square = x[0] * x[0];
                                   return Vector{
                                       -2 * x[0] * std::cos(2 * x[1]) * std::cos(square),
                                       2 * std::sin(2 * x[1]) * (std::cos(square) - square * std::sin(square))};
                                 },
                                 [](const Vector& x) { return 3 * std::cos(2 * x[0] * x[0] + x[1]); },
                                 [](const Vector& x) { return std::exp(x[0] * x[0] - 2 * x[1]); }});
}

}  // namespace
}  // namespace parison::flow
