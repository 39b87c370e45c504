// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/math/dual.hpp"

namespace parison::core {
namespace {

/// Uses every operation.
template <typename Number>
Number every_operation(const Number& x, const Number& y) {
  using std::exp, std::log;
  return 2.0 + 3.0 / (x * y + 0.5 * x) - exp((y - 1.0) / 2.0) * log(x / y) + (x - y) * (x - 1.0);
}

TEST(Dual, derivatives_agree_with_finite_differences) {
  const double x = 1.3, y = 0.7, step = 1e-6;
  const auto f = [](double a, double b) { return every_operation(a, b); };
  const auto dual = every_operation(Dual<double, Eigen::Array2d>{x, {1, 0}}, Dual<double, Eigen::Array2d>{y, {0, 1}});
  EXPECT_EQ(dual.value, f(x, y));
  EXPECT_NEAR(dual.derivative[0], (f(x + step, y) - f(x - step, y)) / (2 * step), 1e-8);
  EXPECT_NEAR(dual.derivative[1], (f(x, y + step) - f(x, y - step)) / (2 * step), 1e-8);
  EXPECT_GT(dual.derivative.abs().minCoeff(), 0.1);
}

TEST(Dual, of_arrays_is_the_dual_of_each_entry) {
  using Values = Eigen::Array<double, 3, 1>;
  const Values x(1.3, 2.1, 0.4), y(0.7, 0.2, 5.0);
  const auto all = every_operation(Dual<Values>{x, Values::Ones()}, Dual<Values>{y, Values::Zero()});
  for (int i = 0; i < 3; ++i) {
    const auto each = every_operation(Dual<double>{x[i], 1}, Dual<double>{y[i], 0});
    EXPECT_NEAR(all.value[i], each.value, 1e-14 * std::abs(each.value));
    EXPECT_NEAR(all.derivative[i], each.derivative, 1e-14 * std::abs(each.derivative));
  }
}

TEST(Dual, bounds_and_choices_have_no_derivative_where_the_constant_holds) {
  const Dual<double> x{3, 1};
  EXPECT_EQ(min(x, 5.0).derivative, 1);
  EXPECT_EQ(min(x, 2.0).value, 2);
  EXPECT_EQ(min(x, 2.0).derivative, 0);
  EXPECT_EQ(choose(true, x, 7.0).derivative, 1);
  EXPECT_EQ(choose(false, x, 7.0).value, 7);
  EXPECT_EQ(choose(false, x, 7.0).derivative, 0);
}

}  // namespace
}  // namespace parison::core
