// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "forming/step/flow/fixed_point.hpp"

namespace parison::forming {
namespace {

TEST(FixedPoint, an_iteration_that_diverges_in_two_directions_converges_in_four) {
  Eigen::VectorXd factors = Eigen::VectorXd::Constant(20, 1e-4), offset = Eigen::VectorXd::LinSpaced(20, 1, 3);
  factors[3] = -6;
  factors[11] = -2.5;
  const auto map = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return factors.cwiseProduct(x) + offset; };
  const Eigen::VectorXd exact = offset.array() / (1 - factors.array());
  FixedPoint iteration;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(20);
  for (int i = 0; i < 4; ++i) x = iteration.next(x, map(x));
  EXPECT_LT((x - exact).norm(), 1e-3 * exact.norm());
}

TEST(FixedPoint, one_iteration_is_the_plain_one_and_a_map_that_repeats_itself_is_kept) {
  const Eigen::VectorXd x = Eigen::VectorXd::Ones(4), mapped = 2 * x;
  FixedPoint iteration;
  EXPECT_EQ(iteration.next(x, mapped), mapped);
  EXPECT_TRUE(iteration.next(mapped, mapped).allFinite());
  EXPECT_TRUE(iteration.next(mapped, mapped).isApprox(mapped));
}

}  // namespace
}  // namespace parison::forming
