// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "forming/study/search/goal.hpp"
#include "forming/study/search/minimum/least_squares.hpp"
#include "forming/study/search/minimum/scalar_search.hpp"

namespace parison::forming {
namespace {

using Eigen::VectorXd;

/// A jar's wall by two settings: the one leans it, the other bulges it. The finer accuracy has a thinner heel, by the
/// same everywhere, and more weight.
Outcome run_at(const VectorXd& x, bool fine) {
  Outcome outcome;
  for (std::size_t i = 0; i < wall_places; ++i) {
    const double s = double(i) / double(wall_places - 1);
    outcome.wall.radius.push_back(30 - 5 * s + (fine ? 0.01 * s : 0));
    outcome.wall.height.push_back(100 * (1 - s) - (fine ? 0.02 * s : 0));
    outcome.wall.thickness.push_back(2.5 + 0.4 * (x[0] - 1) * (s - 0.5) + 0.5 * (x[1] * x[1] - 4) * s * (1 - s) -
                                     (fine ? 0.3 * (s - 0.5) + 0.4 * s * (1 - s) : 0));
  }
  const double weight = 200 + 3 * x[0] + 2 * x[1] * x[1] + (fine ? 12 : 0);
  outcome.quantities.values = {{"weight", "g", weight, weight}, {fine ? "fine_only" : "coarse_only", "J", 1, 1}};
  add_wall(outcome.wall, {-1e3, 1e3}, outcome.quantities);
  return outcome;
}

Goal even_wall(double good_enough) {
  Goal goal;
  goal.target = {Target::Kind::even_wall, "", "%", 0, {}, {-1e3, 1e3}, good_enough};
  return goal;
}

const VectorXd start = (VectorXd(2) << 0.2, 1).finished();

/// Least squares at the coarser accuracy, with a correction where there is one.
VectorXd found_by_least_squares(const Goal& goal, const VectorXd& from, const Correction* correction) {
  const LeastSquaresOptions options{VectorXd::Constant(2, 0),         VectorXd::Constant(2, 4),
                                    VectorXd::Constant(2, 0.1),       60,
                                    Eigen::Index(goal.limits.size()), good_norm(goal)};
  return least_squares(from, options,
                       [&](const std::vector<VectorXd>& places) {
                         std::vector<std::optional<VectorXd>> residuals;
                         for (const VectorXd& at : places) {
                           const Outcome run = run_at(at, false);
                           residuals.push_back(
                               worth(goal, correction ? corrected(run, *correction, goal.target.part) : run)->residual);
                         }
                         return residuals;
                       })
      .at;
}

TEST(Fidelity, a_corrected_run_is_the_finer_one_where_both_were_run_and_everywhere_when_they_differ_by_a_constant) {
  const VectorXd other = (VectorXd(2) << 2.5, 0.7).finished();
  const Correction correction = correction_from(run_at(start, false), run_at(start, true));
  for (const VectorXd& at : {start, other}) {
    const Outcome found = corrected(run_at(at, false), correction, {-1e3, 1e3}), fine = run_at(at, true);
    for (std::size_t i = 0; i < wall_places; ++i) {
      EXPECT_NEAR(found.wall.thickness[i], fine.wall.thickness[i], 1e-12);
      EXPECT_NEAR(found.wall.height[i], fine.wall.height[i], 1e-12);
      EXPECT_NEAR(found.wall.radius[i], fine.wall.radius[i], 1e-12);
    }
    for (const char* name : {"weight", "wall_rms", "wall_min"}) {
      ASSERT_TRUE(found.quantities.find(name)) << name;
      EXPECT_NEAR(found.quantities.find(name)->value, fine.quantities.find(name)->value, 1e-10) << name;
    }
    EXPECT_FALSE(found.quantities.find("coarse_only"));
    EXPECT_EQ(found.quantities.values.size(), 3u);
  }
}

TEST(Fidelity, a_corrected_search_finds_the_optimum_of_the_finer_accuracy) {
  const Goal goal = even_wall(0.3);
  const VectorXd coarse = found_by_least_squares(goal, start, nullptr);
  const auto at_coarse = worth(goal, run_at(coarse, false)), at_fine = worth(goal, run_at(coarse, true));
  ASSERT_LE(at_coarse->value, 0.3);
  ASSERT_GT(at_fine->value, 1);
  ASSERT_TRUE(is_misled(goal, *at_coarse, *at_fine));
  const Correction correction = correction_from(run_at(coarse, false), run_at(coarse, true));
  const VectorXd answer = found_by_least_squares(goal, coarse, &correction);
  EXPECT_LE(worth(goal, run_at(answer, true))->value, 0.3);
  const VectorXd closest = found_by_least_squares(even_wall(1e-4), coarse, &correction);
  EXPECT_NEAR(closest[0], 1.75, 1e-3) << closest.transpose();
  EXPECT_NEAR(closest[1], std::sqrt(4.8), 1e-3) << closest.transpose();
}

TEST(Fidelity, a_limit_that_the_finer_accuracy_misses_is_held_by_the_corrected_search) {
  Goal goal;
  goal.target = {Target::Kind::least, "weight", "g", 0, {}, {-1e3, 1e3}, {}};
  goal.limits = {{"wall_min", "mm", 2, true}};
  const auto lightest = [&](const VectorXd& from, const Correction* correction) {
    const ScalarOptions options{VectorXd::Constant(2, 0), VectorXd::Constant(2, 4), VectorXd::Constant(2, 0.1), 200, 1};
    VectorXd best = from;
    std::optional<Worth> least;
    scalar_search(
        from, options,
        [&](const VectorXd& at) -> std::optional<ScalarValue> {
          const Outcome run = run_at(at, false);
          const auto found = worth(goal, correction ? corrected(run, *correction, goal.target.part) : run);
          if (!least || is_better(*found, *least)) {
            least = found;
            best = at;
          }
          return ScalarValue{found->value, found->excess};
        },
        [] { return false; });
    return best;
  };
  const VectorXd coarse = lightest(VectorXd::Constant(2, 2), nullptr);
  const auto at_coarse = worth(goal, run_at(coarse, false)), at_fine = worth(goal, run_at(coarse, true));
  ASSERT_TRUE(at_coarse->holds());
  ASSERT_FALSE(at_fine->holds());
  ASSERT_TRUE(is_misled(goal, *at_coarse, *at_fine));
  const Correction correction = correction_from(run_at(coarse, false), run_at(coarse, true));
  const VectorXd answer = lightest(coarse, &correction);
  EXPECT_TRUE(worth(goal, run_at(answer, true))->holds()) << answer.transpose();
}

TEST(Fidelity, corrects_only_where_the_finer_accuracy_is_worse_and_misses_what_is_wanted) {
  Goal goal = even_wall(5);
  goal.limits = {{"wall_min", "mm", 2, true}};
  const auto of = [](double value, double excess) { return Worth{{}, VectorXd::Constant(1, excess), value}; };
  EXPECT_TRUE(is_misled(goal, of(4.9, -0.1), of(5.1, -0.1)));
  EXPECT_TRUE(is_misled(goal, of(6, -0.1), of(7, -0.1)));
  EXPECT_TRUE(is_misled(goal, of(4, -0.01), of(4, 0.01)));
  EXPECT_TRUE(is_misled(goal, of(4, 0.01), of(4, 0.02)));
  EXPECT_FALSE(is_misled(goal, of(4, -0.1), of(4.9, -0.01)));
  EXPECT_FALSE(is_misled(goal, of(7, -0.1), of(6, -0.1)));
  EXPECT_FALSE(is_misled(goal, of(4, 0.02), of(4, 0.01)));
  EXPECT_FALSE(is_misled(goal, of(6, -0.1), of(6 + 1e-12, -0.1)));
  goal.target.good_enough.reset();
  EXPECT_FALSE(is_misled(goal, of(4, -0.1), of(9, -0.1)));
}

TEST(Fidelity, a_run_without_results_stays_without) {
  const Correction correction = correction_from(run_at(start, false), run_at(start, true));
  const Outcome found = corrected({"the glass tore", {}, {}}, correction, {-1e3, 1e3});
  EXPECT_EQ(found.reason, "the glass tore");
  EXPECT_TRUE(found.quantities.values.empty() && found.wall.thickness.empty());
}

TEST(Fidelity, what_one_of_the_two_runs_lacks_is_not_mixed_with_what_is_corrected) {
  Outcome coarse = run_at(start, false);
  coarse.wall = {};
  const Outcome found = corrected(run_at(start, false), correction_from(coarse, run_at(start, true)), {-1e3, 1e3});
  EXPECT_TRUE(found.wall.thickness.empty());
  EXPECT_FALSE(found.quantities.find("wall_rms"));
  EXPECT_TRUE(found.quantities.find("weight"));
}

}  // namespace
}  // namespace parison::forming
