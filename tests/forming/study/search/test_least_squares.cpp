// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "forming/study/search/minimum/least_squares.hpp"
#include "forming/study/search/minimum/scalar_search.hpp"

namespace parison::forming {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Ending = LeastSquaresResult::Ending;

/// A curve that bends, with as much noise as asked for, of the same value at the same place.
VectorXd bent(const VectorXd& x, double noise) {
  VectorXd residual(40);
  for (Eigen::Index i = 0; i < 40; ++i) {
    const double s = double(i) / 39;
    residual[i] = 0.3 * (std::sin(x[0] + s) - std::sin(1 + s)) + 0.2 * s * (x[1] - 2) +
                  0.1 * s * s * (x[2] * x[2] - 1) + noise * std::sin(1e4 * (x.sum() + s));
  }
  return residual;
}

struct Curve {
  double noise = 0;
  std::size_t runs = 0, batches = 0;
  std::function<bool(const VectorXd&)> fails = [](const VectorXd&) { return false; };

  Residuals residuals() {
    return [this](const std::vector<VectorXd>& places) {
      std::vector<std::optional<VectorXd>> found;
      ++batches;
      for (const VectorXd& x : places) {
        ++runs;
        found.push_back(fails(x) ? std::nullopt : std::optional(bent(x, noise)));
      }
      return found;
    };
  }
};

LeastSquaresOptions options() {
  return {VectorXd::Constant(3, 0.2), VectorXd::Constant(3, 3), VectorXd::Constant(3, 0.1), 60, 0, 0, 1e-3};
}
const VectorXd start = (VectorXd(3) << 0.5, 1, 2).finished(), answer = (VectorXd(3) << 1, 2, 1).finished();

TEST(LeastSquares, finds_the_place_where_the_residual_is_zero) {
  Curve curve;
  const auto found = least_squares(start, options(), curve.residuals());
  EXPECT_LT((found.at - answer).norm(), 0.02) << found.at.transpose();
  EXPECT_EQ(found.runs, curve.runs);
  EXPECT_LE(curve.runs, 60u);
}

TEST(LeastSquares, steps_wider_than_the_noise_find_it_in_noise) {
  Curve curve;
  curve.noise = 0.002;  // of a residual of some 0.1
  LeastSquaresOptions wide = options(), narrow = options();
  wide.least_gain = narrow.least_gain = 0.01;
  narrow.step *= 1e-4;
  const auto found = least_squares(start, wide, curve.residuals());
  EXPECT_LT((found.at - answer).norm(), 0.15) << found.at.transpose();
  const auto lost = least_squares(start, narrow, curve.residuals());
  EXPECT_GT(lost.residual.norm(), 1.5 * found.residual.norm());
}

TEST(LeastSquares, all_runs_of_a_jacobian_are_asked_for_at_once) {
  Curve curve;
  LeastSquaresOptions few = options();
  few.runs = 5;
  least_squares(start, few, curve.residuals());
  EXPECT_EQ(curve.runs, 5u);
  EXPECT_EQ(curve.batches, 3u);  // the start, three beside it, a step
}

TEST(LeastSquares, a_run_that_fails_is_tried_from_the_other_side) {
  Curve curve;
  curve.fails = [](const VectorXd& x) { return x[0] > 0.55 && x[0] < 0.65; };
  const auto found = least_squares(start, options(), curve.residuals());
  EXPECT_LT((found.at - answer).norm(), 0.05) << found.at.transpose();
}

TEST(LeastSquares, what_cannot_begin_or_is_stopped_says_so) {
  Curve curve;
  curve.fails = [](const VectorXd&) { return true; };
  EXPECT_EQ(least_squares(start, options(), curve.residuals()).ending, Ending::start_failed);
  const auto none = [](const std::vector<VectorXd>&) { return std::vector<std::optional<VectorXd>>{}; };
  EXPECT_EQ(least_squares(start, options(), none).ending, Ending::stopped);
}

TEST(LeastSquares, bounds_hold_and_the_rest_is_the_best_beside_them) {
  const MatrixXd jacobian = (MatrixXd(2, 2) << 1, 1, 0, 1).finished();
  const VectorXd residual = (VectorXd(2) << -3, -1).finished();  // without bounds 2, 1
  const VectorXd low = VectorXd::Constant(2, -5), high = (VectorXd(2) << 1, 5).finished();
  const VectorXd step = bounded_step(jacobian, residual, 0, low, high);
  EXPECT_DOUBLE_EQ(step[0], 1);
  EXPECT_NEAR(step[1], 1.5, 1e-12);
}

/// Wants x = 3 and has the limit x <= 2, as a last residual that counts above zero alone.
TEST(LeastSquares, limits_count_only_where_they_are_missed) {
  const Residuals residuals = [](const std::vector<VectorXd>& places) {
    std::vector<std::optional<VectorXd>> found;
    for (const VectorXd& x : places) found.push_back((VectorXd(2) << x[0] - 3, 10 * (x[0] - 2)).finished());
    return found;
  };
  LeastSquaresOptions limited{
      VectorXd::Constant(1, -9), VectorXd::Constant(1, 9), VectorXd::Constant(1, 0.1), 40, 1, 0, 1e-4};
  const auto found = least_squares(VectorXd::Constant(1, -4), limited, residuals);
  EXPECT_GT(found.at[0], 1.99);
  EXPECT_LT(found.at[0], 2.02);
}

TEST(ScalarSearch, the_least_value_under_a_limit_is_found) {
  const auto ask = [](const VectorXd& x) -> std::optional<ScalarValue> {
    if (x[0] < 0.05) return std::nullopt;
    return ScalarValue{x[0] + 2 * x[1], VectorXd::Constant(1, 1 - x[0] * x[1])};  // least at x0 = sqrt(2)
  };
  ScalarOptions options{VectorXd::Constant(2, 0.01), VectorXd::Constant(2, 4), VectorXd::Constant(2, 0.1), 100, 1};
  double best = 1e9;
  std::size_t runs = 0;
  const auto ending = scalar_search(
      VectorXd::Constant(2, 2), options,
      [&](const VectorXd& x) {
        ++runs;
        const auto found = ask(x);
        if (found && found->excess[0] <= 1e-9) best = std::min(best, found->value);
        return found;
      },
      [] { return false; });
  EXPECT_EQ(ending, ScalarEnding::converged);
  EXPECT_NEAR(best, 2 * std::sqrt(2.0), 0.03);
  EXPECT_LT(runs, 80u);
}

TEST(ScalarSearch, it_stops_when_asked_to) {
  std::size_t runs = 0;
  const auto ask = [&](const VectorXd& x) -> std::optional<ScalarValue> {
    ++runs;
    return ScalarValue{x.squaredNorm(), VectorXd(0)};
  };
  const ScalarOptions options{VectorXd::Constant(2, -1), VectorXd::Constant(2, 4), VectorXd::Constant(2, 0.1), 100, 0};
  EXPECT_EQ(scalar_search(VectorXd::Constant(2, 2), options, ask, [&] { return runs == 3; }), ScalarEnding::stopped);
  EXPECT_EQ(runs, 3u);
}

}  // namespace
}  // namespace parison::forming
