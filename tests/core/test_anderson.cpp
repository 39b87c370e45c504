// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/linear/anderson.hpp"

namespace parison::core {
namespace {

TEST(AndersonAcceleration, an_iteration_that_diverges_in_two_directions_converges_in_four) {
  Eigen::VectorXd factors = Eigen::VectorXd::Constant(20, 1e-4), offset = Eigen::VectorXd::LinSpaced(20, 1, 3);
  factors[3] = -6;
  factors[11] = -2.5;
  const auto map = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return factors.cwiseProduct(x) + offset; };
  const Eigen::VectorXd exact = offset.array() / (1 - factors.array());
  AndersonAcceleration iteration;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(20);
  for (int i = 0; i < 4; ++i) x = iteration.next(x, map(x));
  EXPECT_LT((x - exact).norm(), 1e-3 * exact.norm());
  AndersonAcceleration by_moves;
  Eigen::VectorXd same = Eigen::VectorXd::Zero(20);
  for (int i = 0; i < 4; ++i) same += by_moves.next_move(map(same) - same);
  EXPECT_LT((same - x).norm(), 1e-9 * x.norm());
}

TEST(AndersonAcceleration, one_iteration_is_the_plain_one_and_a_map_that_repeats_itself_is_kept) {
  const Eigen::VectorXd x = Eigen::VectorXd::Ones(4), mapped = 2 * x;
  AndersonAcceleration iteration;
  EXPECT_EQ(iteration.next(x, mapped), mapped);
  EXPECT_TRUE(iteration.next(mapped, mapped).allFinite());
  EXPECT_TRUE(iteration.next(mapped, mapped).isApprox(mapped));
}

TEST(AndersonAcceleration, what_was_forgotten_counts_no_more) {
  const Eigen::VectorXd x = Eigen::VectorXd::Ones(4), image = 2 * x, other = 5 * x;
  AndersonAcceleration iteration(2);
  iteration.next(x, image);
  EXPECT_NE(iteration.next(image, other), other);
  iteration.forget();
  EXPECT_EQ(iteration.next(image, other), other);
}

TEST(AndersonAcceleration, only_the_last_changes_count) {
  // Of depth one the second change alone explains the residual.
  AndersonAcceleration iteration(1);
  iteration.add(Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 0));
  iteration.add(Eigen::Vector2d(0, 3), Eigen::Vector2d(0, 1));
  const Eigen::VectorXd next = iteration.accelerated(Eigen::Vector2d(7, 7), Eigen::Vector2d(2, 2));
  EXPECT_LT((next - Eigen::Vector2d(7, 1)).norm(), 1e-14);
}

}  // namespace
}  // namespace parison::core
