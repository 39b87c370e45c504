// SPDX-License-Identifier: GPL-3.0-or-later
// Manufactured solutions across non-matching interfaces. The contact carries the exact jump's
// flux h (u1 - u2); what the two exact fluxes differ from it enters as a load on either contact side.
#include "contact/conductance/conductance.hpp"
#include "figure.hpp"
#include "forming/flow/material.hpp"
#include "mortar_cases.hpp"

namespace parison::mortar_test {
namespace {

/// A function with its gradient and Laplacian.
struct Field {
  Scalar value;
  Map gradient;
  Scalar laplacian;
};
/// -k lap u + u = source in both bodies, and the flux h (u1 - u2) across x = 1.
struct Manufactured {
  std::array<Field, 2> u;
  std::array<double, 2> k;
  Scalar pressure;
  std::function<core::Conductance(double pressure, double temperature)> law;  ///< of the first body's side
};

/// The unit squares left and right of x = 1, n1 x n1 and n2 x n2 divisions. The first lies on the slave's place: its
/// bottom side, turned to face +x.
Pair make_squares(int n1, int n2, const std::array<double, 2>& k) {
  const auto turned = [](const Point& x) { return Point(1 - x[1], x[0]); };
  return {Geometry::planar, mapped(divide(0, 1, n1), divide(0, 1, n1), turned),
          mapped(divide(0, 1, n2), divide(-1, 0, n2), turned), k};
}

/// L2 errors of both bodies together.
double error(const Manufactured& m, int n1, int n2, Index slave) {
  Pair pair = make_squares(n1, n2, m.k);
  pair.join(
      slave, 1e-3, [](const Point&) { return 0.0; }, m.pressure);
  pair.problem.law =
      thermal::test::pointwise([&](const core::InterfacePoint& point, double T) { return m.law(point.pressure, T); });
  const auto flux = [&](const Point& x) {
    const double u1 = m.u[0].value(x), u2 = m.u[1].value(x);
    return m.law(m.pressure(x), slave == 0 ? u1 : u2).h * (u1 - u2);
  };
  std::vector<Eigen::VectorXd> zero, guess;
  for (const Index b : {0, 1}) {
    const Field& u = m.u[b];
    const double k = m.k[b], out = b == 0 ? 1 : -1;
    pair.add_source(b, [&](const Point& x) { return u.value(x) - thermal::content_reference - k * u.laplacian(x); });
    pair.add_flux(b, pair.free_sides(b), [&](const Point& x, const Point& n) { return k * u.gradient(x).dot(n); });
    pair.add_flux(b, {b == 0 ? Side::bottom : Side::top},
                  [&](const Point& x, const Point& n) { return k * u.gradient(x).dot(n) + out * flux(x); });
    zero.push_back(Eigen::VectorXd::Constant(pair.mesh[b].node_count(), thermal::content_reference));
  }
  const Solved solved = solve(pair, zero, 1);
  double sum = 0;
  for (const Index b : {0, 1})
    sum += std::pow(thermal::test::distance(pair.mesh[b], Geometry::planar, solved.temperature[b], m.u[b].value), 2);
  return std::sqrt(sum);
}

/// `made(slave)` for each choice of the slave.
void expect_order_three(const std::function<Manufactured(Index)>& made, const char* name) {
  tests::Figure measured(fmt::format("order across the interface, ratios 2:2 to 5:2 both ways, {}", name));
  for (const int finer : {2, 3, 4, 5})
    for (const bool swapped : {false, true})
      for (const Index slave : {0, 1}) {
        const Manufactured m = made(slave);
        if (finer == 2 && swapped) continue;
        std::vector<double> errors;
        for (const int level : {2, 4, 8}) {
          const int a = 2 * level, b = finer * level;
          errors.push_back(error(m, swapped ? b : a, swapped ? a : b, slave));
        }
        const double first = std::log2(errors[0] / errors[1]), second = std::log2(errors[1] / errors[2]);
        std::printf("%s %d:%d slave %d: L2 error %.3e %.3e %.3e, order %.2f %.2f\n", name, swapped ? finer : 2,
                    swapped ? 2 : finer, slave + 1, errors[0], errors[1], errors[2], first, second);
        measured.add(first);
        measured.add(second);
      }
  measured.at_least(2.9);
}

/// MOOSE's: u = x^4 + 2 y^4 + x y^3 on [0,1]^2 and [2,3]x[0,1], -lap u + u = f, h = 1. The second body is moved by -1
/// and so is its u, which leaves the equations as they are and the bodies in touch.
Manufactured moose() {
  const auto shifted = [](double by) {
    return Field{[=](const Point& at) {
                   const double x = at[0] + by, y = at[1];
                   return std::pow(x, 4) + 2 * std::pow(y, 4) + x * y * y * y;
                 },
                 [=](const Point& at) {
                   const double x = at[0] + by, y = at[1];
                   return Point(4 * x * x * x + y * y * y, 8 * y * y * y + 3 * x * y * y);
                 },
                 [=](const Point& at) {
                   const double x = at[0] + by, y = at[1];
                   return 12 * x * x + 24 * y * y + 6 * x * y;
                 }};
  };
  return {{shifted(0), shifted(1)},
          {1, 1},
          [](const Point&) { return 1e5; },
          [](double, double) {
            return core::Conductance{1, 0};
          }};
}

/// Glass at 1040 to 1160 degC on a tool at 440 to 520 degC, lengths in units in which k is 3 and 40; h by the
/// pressure-viscosity law, scaled to compete with k: it varies twofold along the contact.
Manufactured pressure_and_viscosity(Index slave) {
  const auto wave = [](double mean, double size, double a, double b) {
    return Field{
        [=](const Point& x) { return mean + size * std::sin(a * x[0] + 0.3) * std::cos(b * x[1]); },
        [=](const Point& x) {
          return Point(size * a * std::cos(a * x[0] + 0.3) * std::cos(b * x[1]),
                       -size * b * std::sin(a * x[0] + 0.3) * std::sin(b * x[1]));
        },
        [=](const Point& x) { return -size * (a * a + b * b) * std::sin(a * x[0] + 0.3) * std::cos(b * x[1]); }};
  };
  const contact::PressureViscosityConductance law{0.5, 20, 0.2e6, 1e3, 1, 0.25};
  const flow::Viscosity viscosity{-2.309, 3922, 564.15, {}};
  const auto pressure = [](const Point& x) { return 1.5e5 * (1.2 + std::sin(4 * x[1])); };
  const auto conductance = [=](double p, double T) {
    const auto value = contact::conductance(law, p, viscosity(T));
    return core::Conductance{value.h, value.dh_deta * viscosity.derivative(T)};
  };
  const Field glass = wave(1373, 60, 1.7, 2.1), tool = wave(753, 40, 1.3, 2.9);
  if (slave == 0) return {{glass, tool}, {3, 40}, pressure, conductance};
  return {{tool, glass}, {40, 3}, pressure, conductance};
}

TEST(MortarOrders, a_conductance_of_one_keeps_order_three_at_any_ratio) {
  expect_order_three([](Index) { return moose(); }, "h = 1");
}

TEST(MortarOrders, conductance_by_pressure_and_viscosity_keeps_order_three_at_any_ratio) {
  expect_order_three(pressure_and_viscosity, "h(p, eta(T))");
}

}  // namespace
}  // namespace parison::mortar_test
