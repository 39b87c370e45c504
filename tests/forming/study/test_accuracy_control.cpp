// SPDX-License-Identifier: GPL-3.0-or-later
// Runs for an accuracy that is asked for, and the coarser runs behind error bars.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "../bundled_scene.hpp"
#include "core/io/files.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/study/accuracy_control.hpp"
#include "forming/study/coarse_run.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

TEST(Accuracy, bars_of_a_small_scene_hold_the_error_against_a_finer_run) {
  const std::string folder = std::string(PARISON_BINARY_DIR) + "/test_accuracy_bars";
  fs::remove_all(folder);
  const auto results = [&](const char* accuracy, const std::string& directory, ErrorBars* bars) {
    const Scene scene = bundled("shell_inflation", accuracy, {"numerics.strain_per_step=0.04"});
    const RunOutcome outcome = run_in_folder(scene, directory);
    const Summary summary = write_summary(directory, scene, outcome);
    if (bars) {
      const auto coarse = coarse_cases(scene, directory);
      EXPECT_EQ(coarse.size(), coarser_factors.size());
      for (const CoarseCase& one : coarse) EXPECT_TRUE(!has_ended(one) && finish(one, {}, {}) && has_ended(one));
      *bars = estimate_errors(summary.quantities, coarse);
    }
    return read_quantities(core::read_json(core::read_text(directory + "/summary.json"), "summary"));
  };
  ErrorBars bars;
  results("draft", folder + "/run", &bars);
  const Quantities fine = results("draft coarser 0.5", folder + "/fine", nullptr);
  ASSERT_EQ(bars.quantities.values.size(), 6u);
  for (const Quantity& quantity : bars.quantities.values)
    EXPECT_LE(std::abs(quantity.value - fine.find(quantity.name)->value), quantity.error) << quantity.name;
  const auto profile = compare_profiles(bars.quantities.profile, fine.profile);
  EXPECT_LE(profile.mean, bars.profile_mean);
  EXPECT_LE(bars.profile_mean, 2e-3);
}

TEST(Accuracy, a_coarser_run_beyond_the_coarsest_accuracy_is_left_out) {
  EXPECT_EQ(coarse_cases(bundled("shell_inflation", "draft coarser 10"), "none").size(), 1u);
}

/// Quantities whose only one is off by c h^order at edges h.
Quantities off_by(double share, double order, double h) {
  Quantities quantities;
  quantities.values.push_back({"radius", "mm", 1 + share * std::pow(h, order), 1});
  return quantities;
}

/// Each error c h^order of a scene, by target, c and order, but those that need the finest accuracy or nearly.
template <class Check>
void for_each_law(Check&& check) {
  for (const double target : {0.02, 0.005, 0.002})
    for (const double share : {0.002, 0.01, 0.05})
      for (const double order : {1.2, 1.6, 2.0, 2.5})
        if (std::pow(target / share, 1 / order) >= 0.1) check(target, share, order);
}

TEST(AccuracyControl, reaches_what_is_asked_for_whatever_the_error_of_the_scene) {
  std::vector<double> costs;  // over that of the coarsest run that is good enough
  int reached = 0;
  for_each_law([&](double target, double share, double order) {
    AccuracyControl control(target);
    double cost = 0;
    while (!control.finished()) {
      cost += std::pow(control.factor(), -2.7);
      control.add(off_by(share, order, control.factor()), 1);
    }
    EXPECT_TRUE(control.record().reached()) << target << " " << share << " " << order;
    const double error = share * std::pow(control.record().runs.back().factor, order);
    EXPECT_LT(error, 2 * target) << share << " " << order;
    reached += error <= target;
    costs.push_back(cost / std::pow(share / target, 2.7 / order));
  });
  EXPECT_GE(reached, 0.9 * double(costs.size()));
  std::sort(costs.begin(), costs.end());
  EXPECT_LT(costs[costs.size() / 2], 5);
}

/// A scene whose wall is off by c h^order, with as much luck beside as runs of scenes show, another for each twentieth.
class LuckyScene {
 public:
  LuckyScene(double share, double order, int seed) : share_(share), order_(order), random_(seed) {}

  const Quantities& run(double factor) {
    const auto [place, is_new] = runs_.try_emplace(factor);
    double luck = 0;
    for (int i = 0; is_new && i < profile_points; ++i) {
      if (i % 20 == 0) luck = 0.4 * normal_(random_);
      place->second.profile.push_back(1 + share_ * std::pow(factor, order_) * (1 + luck));
    }
    return place->second;
  }
  double error(double factor) {
    return compare_profiles(run(factor).profile, std::vector<double>(profile_points, 1.0)).mean;
  }
  /// CPU time of the cheapest run that is good enough, on a grid of factors as one would try by hand.
  double cheapest(double target) {
    double factor = 8;
    while (error(factor) > target) factor /= 1.19;
    return cost(factor);
  }
  static double cost(double factor) { return std::pow(factor, -2.7); }

 private:
  double share_, order_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  std::map<double, Quantities> runs_;
};

TEST(AccuracyControl, reaches_nine_of_ten_at_a_few_times_the_cheapest_cost_where_runs_have_luck) {
  std::vector<double> costs;  // over that of the cheapest run that is good enough
  int reached = 0;
  for_each_law([&](double target, double share, double order) {
    for (int seed = 0; seed < 20; ++seed) {
      LuckyScene scene(share, order, seed);
      AccuracyControl control(target);
      double cost = 0;
      while (!control.finished()) {
        cost += LuckyScene::cost(control.factor());
        control.add(scene.run(control.factor()), 1);
      }
      reached += control.record().reached() && scene.error(control.record().runs.back().factor) <= target;
      costs.push_back(cost / scene.cheapest(target));
    }
  });
  EXPECT_GE(reached, 0.9 * double(costs.size()));
  std::sort(costs.begin(), costs.end());
  EXPECT_LT(costs[costs.size() / 2], 6) << "6.8 where Richardson's estimate takes luck for error";
}

/// Runs whose errors follow the law of the control, c h^1.5, or have luck beside: estimates over true errors.
TEST(AccuracyControl, an_estimate_counts_the_luck_of_runs_that_are_near_each_other) {
  constexpr double share = 0.01, target = 1e-4;
  const auto law = [&](double factor) { return share * std::pow(factor, 1.5); };
  AccuracyControl control(target);
  std::vector<double> factors;
  while (factors.size() < 3) {
    factors.push_back(control.factor());
    control.add(off_by(share, 1.5, factors.back()), 1);
  }
  const std::vector<ControlledRun>& runs = control.record().runs;
  EXPECT_EQ(runs[0].estimate, std::numeric_limits<double>::infinity());
  // The difference of two runs on the law is theirs alone, the luck expected beside makes the constant smaller.
  const auto constant = [&](double coarse, double fine) {
    const double difference = law(coarse) - law(fine);
    return std::sqrt(1.16 / (difference * difference + 0.16 * (law(coarse) * law(coarse) + law(fine) * law(fine)))) *
           difference;
  };
  EXPECT_NEAR(runs[1].estimate, 2.4 * constant(factors[0], factors[1]) * law(factors[1]), 1e-9 * law(factors[1]));
  const double first = constant(factors[0], factors[1]), skip = constant(factors[0], factors[2]),
               last = constant(factors[1], factors[2]);
  const double mean = std::sqrt((0.2 * first * first + 0.2 * skip * skip + last * last) / 1.4);
  EXPECT_NEAR(runs[2].estimate, 1.5 * mean * law(factors[2]), 1e-9 * law(factors[2]));
}

TEST(AccuracyControl, one_lucky_pair_is_outvoted_by_the_others) {
  constexpr double target = 1e-4;
  AccuracyControl control(target);
  const auto add = [&](double luck) { control.add(off_by(0.01 * luck, 1.5, control.factor()), 1); };
  add(1);
  add(1);
  const double second = control.record().runs.back().factor, third = control.factor();
  add(std::pow(second / third, 1.5));  // the same result as the run before
  const ControlledRun& last = control.record().runs.back();
  EXPECT_GT(last.estimate, 0.5 * 0.01 * std::pow(last.factor, 1.5));
}

TEST(AccuracyControl, two_runs_are_enough_only_where_they_are_far_nearer_to_each_other_than_asked_for) {
  constexpr double target = 0.01;
  const auto estimate = [&](double share) {
    AccuracyControl control(target);
    for (int run = 0; run < 2; ++run) control.add(off_by(share, 1.5, control.factor()), 1);
    EXPECT_EQ(control.finished(), control.record().reached());
    return control.record().runs.back().estimate;
  };
  const double of_one_percent = estimate(0.01), limit = 0.01 * target / of_one_percent;
  EXPECT_LE(estimate(0.99 * limit), target);
  EXPECT_GT(estimate(1.01 * limit), target);
  AccuracyControl control(target);
  control.add(off_by(limit, 1.5, control.factor()), 1);
  EXPECT_LT(limit * std::pow(control.factor(), 1.5), 0.65 * target) << "true error of the second run there";
}

TEST(AccuracyControl, never_asks_for_more_than_the_finest_accuracy) {
  AccuracyControl control(0.0013);
  while (!control.finished()) {
    EXPECT_GE(control.factor(), min_coarsening);
    control.add(off_by(10, 0.5, control.factor()), 1);
  }
  EXPECT_FALSE(control.record().reached());
}

TEST(AccuracyControl, error_bars_are_by_two_coarser_runs_also_where_the_second_is_many_times_as_coarse) {
  AccuracyControl control(0.01);
  const double first = control.factor();
  control.add(off_by(0.5, 1, 1), 1);
  EXPECT_TRUE(control.coarser().empty());
  control.add(std::nullopt, 1);
  control.add(std::nullopt, 1);
  control.add(off_by(0.5, 1, 0.5), 1);  // far off: the next is as much finer as any
  EXPECT_EQ(control.coarser().size(), 1u);
  const double last = control.factor();
  control.add(off_by(0.5, 1, 0.1), 1);
  const std::vector<CoarserRun> coarser = control.coarser();
  ASSERT_EQ(coarser.size(), 2u);
  EXPECT_GT(coarser[1].factor, 4) << "the limit of further runs";
  EXPECT_NEAR(coarser[1].factor, first / last, 1e-12);
}

TEST(AccuracyControl, refines_after_a_run_that_stopped_and_gives_up_after_eight) {
  AccuracyControl control(0.01);
  double last = 2 * control.factor();
  while (!control.finished()) {
    EXPECT_LT(control.factor(), last);
    last = control.factor();
    control.add(std::nullopt, 1);
  }
  EXPECT_EQ(control.record().runs.size(), 8u);
  EXPECT_FALSE(control.record().reached());
}

Check resolution(double value) {
  return {"flow_resolution", value, 0.03, 0.5, "%", "", CheckKind::error};
}

TEST(AccuracyControl, a_run_that_its_own_check_condemns_has_not_reached_what_was_asked_for) {
  AccuracyControl control(0.02);
  const auto add = [&](double unresolved) {
    control.add(off_by(1e-4, 1.5, control.factor()), 1, {resolution(unresolved)});
  };
  add(0.9);
  add(0.35);
  const ControlledRun& second = control.record().runs.back();
  EXPECT_LT(second.estimate, 0.02);
  EXPECT_FALSE(control.record().reached());
  EXPECT_FALSE(control.finished()) << "a finer run may mend it";
  ASSERT_EQ(second.condemned_by.size(), 1u);
  EXPECT_EQ(second.condemned_by[0], "flow_resolution is 35 %, the limit is 3 %");
  EXPECT_NEAR(second.factor / control.factor(), 2.3, 1e-9) << "as much finer as any";
  add(0.025);
  EXPECT_TRUE(control.record().reached());
}

TEST(AccuracyControl, a_check_within_its_limit_or_the_error_asked_for_speaks_against_nothing) {
  for (const double value : {0.01, 0.04}) {
    AccuracyControl control(0.05);
    for (int run = 0; run < 2; ++run) control.add(off_by(1e-4, 1.5, control.factor()), 1, {resolution(value)});
    EXPECT_TRUE(control.record().reached()) << value;
  }
}

TEST(AccuracyControl, gives_up_where_finer_runs_do_not_mend_what_a_check_says) {
  // The same, and hardly less: a corner that no mesh resolves, beside a check that mends.
  for (const double fall : {1.0, 0.99}) {
    AccuracyControl stuck(0.02);
    for (const double share : {1.0, fall})
      stuck.add(off_by(1e-4, 1.5, stuck.factor()), 1,
                {{"light", 0.1 * std::pow(stuck.factor(), 2), 0.01, 0.1, "%", "", CheckKind::error},
                 resolution(0.35 * share)});
    EXPECT_TRUE(stuck.finished()) << fall;
    EXPECT_FALSE(stuck.record().reached());
    EXPECT_EQ(stuck.record().not_mended, std::vector<std::string>{"flow_resolution"});
  }
  AccuracyControl fast(0.02);
  for (int run = 0; run < 2; ++run)
    fast.add(off_by(1e-4, 1.5, fast.factor()), 1, {{"inertia", 50.0 - run, 1, 20, "", ""}});
  EXPECT_TRUE(fast.finished());
  EXPECT_FALSE(fast.record().reached());
}

/// A run whose wall is right and whose heats are as given, J; below 100 J a heat is nothing.
Quantities with_heats(const std::vector<double>& heats) {
  Quantities run{{}, std::vector<double>(profile_points, 1.0)};
  for (const double heat : heats) run.values.push_back({"heat_a", "J", heat, std::max(100.0, std::abs(heat))});
  return run;
}

TEST(AccuracyControl, the_relative_error_of_a_heat_that_is_nothing_is_not_chased) {
  EXPECT_EQ(difference_of_runs(with_heats({2}), with_heats({1})), 0);
  EXPECT_EQ(difference_of_runs(with_heats({}), with_heats({})), 0);
  EXPECT_NEAR(difference_of_runs(with_heats({1100}), with_heats({1000})), 0.1, 1e-12);
  Quantities flat = with_heats({1}), other = with_heats({2});
  flat.profile.clear(), other.profile.clear();
  EXPECT_NEAR(difference_of_runs(other, flat), 0.01, 1e-12) << "of what counts as a heat, where there is no wall";
}

}  // namespace
}  // namespace parison::forming
