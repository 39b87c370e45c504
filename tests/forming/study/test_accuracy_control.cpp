// SPDX-License-Identifier: GPL-3.0-or-later
// Runs for an accuracy that is asked for, and the coarser runs behind error bars.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

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
    const Summary summary = write_summary(directory, scene, outcome.state, outcome.facts);
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

/// Runs that a control makes of a model with that error.
AccuracyRecord controlled(double target, double share, double order) {
  AccuracyControl control(target);
  while (!control.finished()) control.add(off_by(share, order, control.factor()), 1);
  return control.record();
}

TEST(AccuracyControl, reaches_what_is_asked_for_whatever_the_error_of_the_scene) {
  std::vector<double> costs;  // over that of the coarsest run that is good enough
  int reached = 0;
  for (const double target : {0.02, 0.005, 0.002})
    for (const double share : {0.002, 0.01, 0.05})
      for (const double order : {1.2, 1.6, 2.0, 2.5}) {
        if (std::pow(target / share, 1 / order) < 0.1) continue;  // finer than the finest allowed, nearly
        const AccuracyRecord record = controlled(target, share, order);
        EXPECT_TRUE(record.reached()) << target << " " << share << " " << order;
        const double error = share * std::pow(record.runs.back().factor, order);
        EXPECT_LT(error, 2 * target) << share << " " << order;
        reached += error <= target;
        double cost = 0;
        for (const ControlledRun& run : record.runs) cost += std::pow(run.factor, -2.7);
        costs.push_back(cost / std::pow(share / target, 2.7 / order));
      }
  EXPECT_GE(reached, 0.9 * double(costs.size()));
  std::sort(costs.begin(), costs.end());
  EXPECT_LT(costs[costs.size() / 2], 5);
}

TEST(AccuracyControl, an_estimate_is_larger_by_the_scatter_of_the_runs_behind_it) {
  constexpr double share = 0.01, order = 1.5, target = 1e-4;
  const auto estimates = [&](double third) {
    AccuracyControl control(target);
    for (const double scatter : {1.0, 1.0, third}) control.add(off_by(scatter * share, order, control.factor()), 1);
    return control.record().runs;
  };
  const auto law = [&](const ControlledRun& run) { return share * std::pow(run.factor, order); };
  const auto exact = estimates(1);
  const double safety = exact[1].estimate / law(exact[1]);
  EXPECT_GT(safety, 1);
  EXPECT_NEAR(exact[2].estimate, safety * law(exact[2]), 1e-9 * law(exact[2])) << "all on one law";
  // A third run off by less than the law has shows larger differences; the first pair, and that of the first and the
  // last, count a quarter.
  const auto scattered = estimates(0.5);
  const double last = law(scattered[2]);
  const double from_first = (law(scattered[0]) - 0.5 * last) / (law(scattered[0]) - last);
  const double from_second = (law(scattered[1]) - 0.5 * last) / (law(scattered[1]) - last);
  const double mean = std::sqrt((1 + from_first * from_first + 4 * from_second * from_second) / 6);
  EXPECT_GT(scattered[2].estimate, 1.01 * safety * mean * last);
  EXPECT_LT(scattered[2].estimate, 1.5 * safety * mean * last);
}

TEST(AccuracyControl, two_runs_are_enough_only_where_they_are_far_nearer_to_each_other_than_asked_for) {
  constexpr double order = 1.5, target = 0.01;
  const auto is_reached_by_two = [&](double share) {
    AccuracyControl control(target);
    for (int run = 0; run < 2; ++run) control.add(off_by(share, order, control.factor()), 1);
    EXPECT_EQ(control.finished(), control.record().reached());
    return control.record().reached();
  };
  AccuracyControl control(target);
  control.add(off_by(1e-3, order, control.factor()), 1);
  const double second = control.factor(), error = target / std::pow(second, order);
  EXPECT_TRUE(is_reached_by_two(0.3 * error));
  EXPECT_FALSE(is_reached_by_two(0.36 * error)) << "a third of what is asked for is not enough";
}

TEST(AccuracyControl, error_bars_are_by_two_coarser_runs_also_where_the_second_is_many_times_as_coarse) {
  AccuracyControl control(0.01);
  const double first = control.factor();
  control.add(off_by(0.05, 1, 1), 1);
  EXPECT_TRUE(control.coarser().empty());
  control.add(off_by(0.05, 1, 0.5), 1);  // far off: the next is as much finer as any
  EXPECT_EQ(control.coarser().size(), 1u);
  const double last = control.factor();
  control.add(off_by(0.05, 1, 0.1), 1);
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

}  // namespace
}  // namespace parison::forming
