// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/case/case_error.hpp"
#include "core/io/json_read.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/comparison/comparison.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::forming {
namespace {

/// A run whose only quantity, and whose even wall, have this value.
FinishedRun run_with(double value, const std::string& accuracy = "draft") {
  FinishedRun run;
  run.name = "run";
  run.accuracy = accuracy;
  run.completed = true;
  run.quantities.values.push_back({"thickness_min", "mm", value, 2});
  run.quantities.profile.assign(profile_points, value);
  run.stages = {{"press", {1}}, {"blow", {value}}};
  return run;
}

/// With coarser runs that have these values, 1.5 and 3 times as coarse.
FinishedRun run_with(double value, double coarse, double coarser) {
  FinishedRun run = run_with(value);
  run.coarser = {run_with(coarse, "draft coarser 1.5"), run_with(coarser, "draft coarser 3")};
  run.coarser[0].factor = 1.5;
  run.coarser[1].factor = 3;
  return run;
}

const Difference& wall(const RunComparison& comparison) {
  return comparison.quantities.at(0);
}

Twin twin_with(double value, std::size_t stages) {
  return {stages, run_with(value).quantities};
}

/// The bar of a difference by another difference of runs so many times as coarse.
double richardson(double difference, double factor) {
  return richardson_estimate(difference, 1, factor, difference_order);
}

TEST(Difference, the_error_that_both_runs_have_cancels) {
  FinishedRun base = run_with(2, 2.3, 2.9), other = run_with(2.1, 2.4, 3.0);
  base.twins = {twin_with(2.0001, 0)};
  const RunComparison comparison = compare_runs(base, other);
  EXPECT_EQ(comparison.bars, BarSource::differences);
  EXPECT_NEAR(wall(comparison).difference, 0.1, 1e-12);
  EXPECT_LT(wall(comparison).bar, 0.01);  // each run alone is off by some 0.9
  EXPECT_EQ(wall(comparison).significance(), Significance::real);
}

TEST(Difference, what_the_coarser_runs_differ_by_otherwise_is_the_error) {
  FinishedRun base = run_with(2, 2, 2), other = run_with(2.1, 2.14, 2.16);
  base.twins = {twin_with(2.0001, 0)};
  const Difference found = wall(compare_runs(base, other));
  EXPECT_NEAR(found.bar, richardson(0.04, 1.5), 1e-9);
  EXPECT_EQ(found.significance(), Significance::within_error);
  EXPECT_GT(richardson(0.04, 1.5), richardson(0.06, 3));
}

TEST(Difference, no_bar_is_smaller_than_what_twins_scatter_by) {
  FinishedRun base = run_with(2, 2, 2), other = run_with(2.1, 2.1, 2.1);
  EXPECT_LT(wall(compare_runs(base, other)).scatter, 0.02);  // the stated one
  base.twins = {twin_with(2.03, 0)};
  const RunComparison comparison = compare_runs(base, other);
  EXPECT_EQ(comparison.scatter, ScatterSource::twins);
  EXPECT_NEAR(wall(comparison).bar, 6.314 * 0.03, 1e-4);  // Student's t of one twin, 90 %
  EXPECT_EQ(wall(comparison).significance(), Significance::within_error);
  base.coarser[0].twins = {twin_with(2.03, 0)};  // of a coarser run, which scatters more
  const double t = 2.920, coarse = 0.03 / std::pow(1.5, difference_order);
  EXPECT_NEAR(wall(compare_runs(base, other)).bar, t * std::sqrt((0.03 * 0.03 + coarse * coarse) / 2), 1e-4);
}

TEST(Difference, a_twin_counts_where_it_left_its_run_before_the_runs_left_each_other) {
  FinishedRun base = run_with(2, 2, 2), other = run_with(2.1, 2.1, 2.1);
  base.twins = {twin_with(2.5, 0), twin_with(2.001, 1), twin_with(3, 2)};
  EXPECT_EQ(stages_in_common(base, other), 1u);  // the press
  EXPECT_NEAR(wall(compare_runs(base, other)).bar, 6.314 * 0.001, 1e-5);
  EXPECT_EQ(compare_runs(base, other, 0).in_common, 0u);  // their cases already differ there
  EXPECT_NEAR(wall(compare_runs(base, other, 0)).bar, 6.314 * 0.5, 1e-3);
  other.stages[0].numbers = {7};
  EXPECT_NEAR(wall(compare_runs(base, other)).bar, 6.314 * 0.5, 1e-3);
}

TEST(Difference, of_runs_made_twice_is_that_of_their_means) {
  FinishedRun base = run_with(2, 2, 2), other = run_with(2.1, 2.1, 2.5);
  base.twins = {twin_with(2.02, 0)};
  other.twins = {twin_with(2.1, 0)};
  base.coarser[0].twins = {twin_with(2.03, 0)};
  EXPECT_EQ(compare_runs(base, other).pairs, 2u);
  const double far = richardson(0.5 - 0.09, 3);  // of coarser runs made once, while no others are
  EXPECT_NEAR(wall(compare_runs(base, other)).bar, std::max(far, richardson(0.01, 1.5)), 1e-9);
  other.coarser[0].twins = {twin_with(2.11, 0)};
  const RunComparison comparison = compare_runs(base, other);
  EXPECT_NEAR(wall(comparison).base, 2.01, 1e-12);
  EXPECT_NEAR(wall(comparison).difference, 0.09, 1e-12);
  EXPECT_NEAR(comparison.profile.difference[200], 0.09, 1e-12);
  const double finer = std::pow(1.5, difference_order), t = 2.132;  // four twins
  const double squares = 0.02 * 0.02 + std::pow(0.03 / finer, 2) + std::pow(0.01 / finer, 2);
  EXPECT_NEAR(wall(comparison).bar, t * std::sqrt(squares / 4 / 2), 1e-4);
  EXPECT_EQ(comparison.repeated, "all tools 0.01 K warmer from the start");
  const RunComparison single = compare_runs(base, other, 2, Repeats::ignored);
  EXPECT_EQ(single.pairs, 1u);
  EXPECT_EQ(single.repeated, "");
  EXPECT_EQ(single.twins, comparison.twins);  // they still tell the scatter
  EXPECT_NEAR(wall(single).base, 2, 1e-12);
  base.twins[0].warmer_gob = true;
  EXPECT_EQ(compare_runs(base, other).repeated, "the gob 0.01 K warmer from the start");
  other.twins = {twin_with(2.1, 1)};  // from another stage on: no pair
  EXPECT_EQ(compare_runs(base, other).pairs, 1u);
}

TEST(Difference, without_coarser_runs_there_is_no_bar_and_no_verdict) {
  const RunComparison comparison = compare_runs(run_with(2), run_with(3));
  EXPECT_EQ(comparison.bars, BarSource::none);
  EXPECT_EQ(wall(comparison).significance(), Significance::unknown);
  EXPECT_FALSE(std::isfinite(comparison.profile.bar[100]));
}

TEST(Difference, of_runs_at_other_accuracies_the_bars_add_up) {
  FinishedRun base = run_with(2, 2.1, 2.2), other = run_with(2.3, 2.4, 2.5);
  other.accuracy = "standard";
  base.quantities.values[0].error = 0.1;
  other.quantities.values[0].error = 0.05;
  const RunComparison comparison = compare_runs(base, other);
  EXPECT_EQ(comparison.bars, BarSource::both_bars);
  EXPECT_NEAR(wall(comparison).bar, 0.15, 1e-12);
}

TEST(Difference, of_runs_without_a_coarser_one_near_enough_in_common_the_bars_add_up) {
  FinishedRun base = run_with(2, 2.1, 2.2), other = run_with(2.3, 2.4, 2.5);
  base.quantities.values[0].error = 0.1;
  other.quantities.values[0].error = 0.05;
  EXPECT_EQ(compare_runs(base, other).bars, BarSource::differences);
  other.coarser[0].factor = partner_factors[0];  // in common are the runs three times as coarse
  EXPECT_EQ(compare_runs(base, other).bars, BarSource::both_bars);
  base.coarser[0].factor = partner_factors[0];
  EXPECT_EQ(compare_runs(base, other).bars, BarSource::differences);
}

TEST(Difference, the_wall_is_compared_place_by_place) {
  FinishedRun base = run_with(2, 2.3, 2.9), other = run_with(2.1, 2.4, 3.0);
  base.quantities.profile[0] = std::nan("");
  base.twins = {twin_with(2.0001, 0)};
  const ProfileComparison walls = compare_runs(base, other).profile;
  EXPECT_FALSE(std::isfinite(walls.difference[0]));
  EXPECT_NEAR(walls.difference[200], 0.1, 1e-12);
  EXPECT_LT(walls.bar[200], 0.01);
}

/// Without the run that is broken.
Comparison compared_alone(const FinishedRun& base, const FinishedRun& other) {
  Comparison comparison{base, {}};
  comparison.others.push_back({"thicker", {}, "", compare_runs(base, other)});
  return comparison;
}

Comparison compared(const FinishedRun& base, const FinishedRun& other) {
  Comparison comparison{base, {}};
  comparison.others.push_back(
      {"thicker", {{"tool.blank.temperature", "460 degC", "440 degC"}}, "", compare_runs(base, other)});
  comparison.others.push_back({"broken", {}, "blow at 0.1 s: the glass tore", std::nullopt});
  return comparison;
}

TEST(Comparison, the_last_table_says_by_how_much_for_sure_and_a_run_that_failed_is_a_row_with_its_reason) {
  FinishedRun base = run_with(2, 2, 2), other = run_with(2.1, 2.11, 2.11);
  base.twins = {twin_with(2.0001, 0)};
  const Comparison comparison = compared(base, other);
  const std::string ranking = ranking_table(comparison, "thickness_min");
  EXPECT_NE(ranking.find("+0.100 mm +- 0.030: real, for sure more by at least 0.070 mm"), std::string::npos) << ranking;
  EXPECT_NE(ranking.find("broken    no result: blow at 0.1 s: the glass tore"), std::string::npos) << ranking;
  EXPECT_EQ(ranking.find("\nwall thickness, least: 2 mm in run; each change"), 0u) << ranking;
  const std::string tables = comparison_tables(comparison);
  EXPECT_NE(tables.find("  wall thickness, least         2.000"), std::string::npos) << tables;
  EXPECT_NE(tables.find("tool.blank.temperature: 460 degC -> 440 degC"), std::string::npos) << tables;
  EXPECT_NE(tables.find("no results: blow at 0.1 s"), std::string::npos) << tables;
}

TEST(Comparison, a_long_reason_of_a_run_that_failed_stays_in_its_column) {
  Comparison comparison = compared(run_with(2, 2, 2), run_with(2.1, 2.1, 2.1));
  std::string reason = "stage blow at 0.1 s: ";
  for (int i = 0; i < 40; ++i) reason += "no step of the time converges; ";
  comparison.others[1].reason = reason;
  const std::string ranking = ranking_table(comparison, "thickness_min");
  std::istringstream lines(ranking.substr(ranking.find("  broken ")));
  std::string line, joined;
  for (int count = 0; std::getline(lines, line); ++count) {
    EXPECT_LE(line.size(), 120u) << line;
    EXPECT_EQ(line.substr(0, 12), count == 0 ? "  broken    " : "            ") << line;
    joined += (count == 0 ? "" : " ") + line.substr(12);
  }
  EXPECT_EQ(joined, "no result: " + reason);
}

TEST(Comparison, flags_warnings_and_failed_checks_are_told_with_the_runs_that_have_them) {
  const auto remarks = [](const std::string& flags, const std::string& warnings, const std::string& checks) {
    return read_remarks(core::read_json(
        fmt::format(R"({{"flags": [{}], "warnings": [{}], "checks": [{}]}})", flags, warnings, checks), "summary"));
  };
  const std::string hot =
      R"({"name": "tool_surface_above", "tool": "ring", "unit": "degC", "limit": 600, "value": 612})";
  const std::string thin = R"({"name": "wall_below", "unit": "mm", "limit": 1.5, "value": 1.42})";
  const auto check = [](const std::string& verdict) {
    return R"({"name": "work_balance", "value": 0.021, "limit": 0.01, "unit": "%", "verdict": ")" + verdict + "\"}";
  };
  FinishedRun base = run_with(2), other = run_with(2.1);
  Comparison comparison = compared(base, other);
  EXPECT_NE(comparison_tables(comparison).find("flags and warnings: none in any run; no check failed"),
            std::string::npos);
  comparison.base.remarks = remarks(hot, R"("1 fold of 2 mm3 was closed; look there")", check("inside"));
  comparison.others[0].run.remarks = remarks(
      thin, R"("1 fold of 3 mm3 was closed; look there", "the ring still moves at 0.2 s")", check("not trustworthy"));
  EXPECT_EQ(remark_lines(comparison),
            "\nflags, warnings and failed checks:\n"
            "  only in run\n"
            "    flag tool_surface_above of ring: 612 degC, limit 600 degC\n"
            "  in all runs\n"
            "    warning 1 fold of 2 mm3 was closed\n"
            "  only in thicker\n"
            "    flag wall_below: 1.42 mm, limit 1.5 mm\n"
            "    warning the ring still moves at 0.2 s\n"
            "    failed check work_balance is 2.1 %, the limit is 1 %: not trustworthy\n");
  comparison.others.push_back({"third", {}, "", comparison.others[0].result});
  comparison.others.back().run.remarks =
      remarks(R"({"name": "wall_below", "unit": "mm", "limit": 1.5, "value": 1.3})", "", check("beyond"));
  EXPECT_NE(remark_lines(comparison)
                .find("  in thicker, third, not in run\n"
                      "    flag wall_below: 1.42 mm, limit 1.5 mm (thicker)\n"
                      "    flag wall_below: 1.3 mm, limit 1.5 mm (third)\n"),
            std::string::npos)
      << remark_lines(comparison);
  comparison.others.pop_back();
  comparison.others[0].run.remarks = comparison.base.remarks;
  EXPECT_EQ(remark_lines(comparison),
            "\nflags, warnings and failed checks:\n"
            "  in all runs\n"
            "    flag tool_surface_above of ring: 612 degC, limit 600 degC\n"
            "    warning 1 fold of 2 mm3 was closed\n");
}

TEST(Comparison, a_quantity_that_is_not_there_is_refused_with_the_nearest) {
  try {
    require_quantity("thicknes_min", run_with(2).quantities.values);
    ADD_FAILURE();
  } catch (const core::CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"thickness_min\"?"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(require_quantity("thickness_min", run_with(2).quantities.values));
}

TEST(Comparison, the_plot_has_a_line_for_each_run_and_a_band_for_each_difference) {
  const std::string plot = profile_plot(compared(run_with(2, 2, 2), run_with(2.1, 2.1, 2.1)));
  EXPECT_EQ(plot.rfind("<svg", 0), 0u);
  std::size_t paths = 0;
  for (std::size_t at = 0; (at = plot.find("<path", at)) != plot.npos; ++at) ++paths;
  EXPECT_EQ(paths, 4u);
  FinishedRun gob = run_with(2);
  gob.quantities.profile.clear();
  EXPECT_EQ(profile_plot(compared(gob, gob)), "");
}

/// Those that runs of a case may have.
std::vector<Quantity> possible() {
  return {{"thickness_min", "mm", 0, 0}, {"heat_blank", "J", 0, 0}};
}

TEST(Resolution, goes_finer_until_the_bars_are_as_small_as_asked_for) {
  ResolutionControl control("0.02 mm", possible());
  EXPECT_EQ(control.accuracy(), "draft coarser 2");
  double factor = 2;
  for (int round = 0; !control.finished(); ++round) {
    ASSERT_LT(round, 8);
    const double off = 0.005 * factor;  // the bar goes with the edges
    control.add(compared_alone(run_with(2, 2, 2), run_with(2.1, 2.1 + off, 2.1 + off)));
    EXPECT_NEAR(control.bar(), std::max(richardson(off, 1.5), 0.0146), 1e-4);
    factor = std::stod(control.accuracy().substr(14));
  }
  EXPECT_TRUE(control.reached());
  EXPECT_GE(control.rounds(), 2);
}

TEST(Resolution, what_scatter_hides_at_any_accuracy_is_given_up) {
  ResolutionControl control("thickness_min=0.001 mm", possible());
  for (int round = 0; !control.finished() && round < 20; ++round)
    control.add(compared(run_with(2, 2, 2), run_with(2.1, 2.1, 2.1)));
  EXPECT_TRUE(control.finished());
  EXPECT_FALSE(control.reached());
}

/// A comparison whose bar of the thinnest wall goes with what the coarser runs differ by.
Comparison off_by(double off) {
  return compared_alone(run_with(2, 2, 2), run_with(2.1, 2.1 + off, 2.1 + off));
}

TEST(Resolution, bars_that_do_not_shrink_with_edges_and_steps_are_given_up_with_what_was_reached) {
  ResolutionControl control("0.05 mm", possible());
  control.add(off_by(0.2), 10);
  EXPECT_EQ(control.gives_up(), "");
  const double bar = control.bar(), finer = 2 / std::stod(control.accuracy().substr(14));
  EXPECT_NEAR(control.expected_bar(), bar / finer, 1e-3 * bar);
  EXPECT_NEAR(control.expected_cpu(), 10 * std::pow(finer, 2.5), 1);
  control.add(off_by(0.18), 100);
  EXPECT_TRUE(control.finished());
  EXPECT_FALSE(control.reached());
  EXPECT_NE(control.gives_up().find("was to be expected: finer rounds are not likely to get to 0.05"),
            std::string::npos)
      << control.gives_up();
}

TEST(Resolution, a_size_that_would_cost_many_times_the_last_round_is_given_up) {
  ResolutionControl control("0.001 mm", possible());
  control.add(off_by(0.5), 10);
  EXPECT_FALSE(control.finished());
  control.add(off_by(0.25), 100);
  EXPECT_TRUE(control.finished());
  EXPECT_NE(control.gives_up().find("times the CPU time of the last round, more than 100 times"), std::string::npos)
      << control.gives_up();
}

TEST(Resolution, below_what_any_bar_can_be_is_refused_before_the_runs_or_given_up_after_the_first) {
  std::vector<Quantity> known = possible();
  known[0].scale = 3;
  try {
    ResolutionControl("0.0002 mm", known);
    ADD_FAILURE();
  } catch (const core::CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("is below 0.0003 mm"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(ResolutionControl("0.0003 mm", known));
  ResolutionControl control("0.0001 mm", possible());  // of a wall of 2 mm
  EXPECT_EQ(control.too_small(), "");
  control.add(compared_alone(run_with(2, 2, 2), run_with(2.1, 2.1, 2.1)));
  EXPECT_TRUE(control.finished());
  EXPECT_FALSE(control.reached());
  EXPECT_NE(control.too_small().find("is below 0.0002 mm"), std::string::npos) << control.too_small();
}

TEST(Resolution, asks_for_small_bars_of_all_variants) {
  const auto with_second = [](double off) {
    Comparison comparison = compared_alone(run_with(2, 2, 2), run_with(2.1, 2.1, 2.1));
    comparison.others.push_back(
        {"second", {}, "", compare_runs(run_with(2, 2, 2), run_with(2.1, 2.1 + off, 2.1 + off))});
    return comparison;
  };
  ResolutionControl control("0.02 mm", possible());
  control.add(with_second(0.1));
  EXPECT_FALSE(control.reached());  // the bar of the first is small enough
  EXPECT_NEAR(control.bar(), richardson(0.1, 1.5), 1e-9);
  control.add(with_second(0));
  EXPECT_TRUE(control.reached());
}

TEST(Resolution, is_not_reached_while_a_variant_has_no_bar_and_given_up_where_it_stops_twice_beyond_draft) {
  const Comparison with_broken = compared(run_with(2, 2, 2), run_with(2.1, 2.1, 2.1));
  ResolutionControl control("0.02 mm", possible());
  control.add(with_broken);
  EXPECT_LT(control.bar(), 0.02);
  EXPECT_FALSE(control.reached());
  EXPECT_FALSE(control.finished());
  EXPECT_EQ(control.without_bar(), std::vector<std::string>{"broken"});
  while (!control.finished()) control.add(with_broken);
  EXPECT_FALSE(control.reached());
  EXPECT_EQ(control.rounds(), 4);
  ResolutionControl cured("0.02 mm", possible());
  cured.add(with_broken);
  Comparison unchanged = with_broken;
  unchanged.others[1].unchanged = true;  // nothing is asked of a variant that changes nothing
  cured.add(unchanged);
  EXPECT_TRUE(cured.reached());
}

TEST(Resolution, a_size_that_is_none_another_unit_and_an_unknown_quantity_are_refused_before_anything_runs) {
  for (const char* wrong : {"", "mm", "0 mm", "-1 mm", "3 K", "thickness_min=2 J", "heat_blank=2 mm", "heat_blanc=2 J"})
    EXPECT_THROW(ResolutionControl(wrong, possible()), core::CaseError) << wrong;
  ResolutionControl other("heat_blank=50 J", possible());
  EXPECT_EQ(other.unit(), "J");
  EXPECT_THROW(other.add(compared(run_with(2, 2, 2), run_with(3, 3, 3))), core::CaseError);  // the run has no such heat
}

/// Of this model of radiation, with what the best one was found to move the wall.
FinishedRun run_of_model(double value, const std::string& model, double moved) {
  FinishedRun run = run_with(value);
  run.quantities.values[0].model = moved;
  run.quantities.models = {{"radiation", model, "transfer"}};
  return run;
}

std::string told_of_models(const FinishedRun& base, const FinishedRun& other) {
  return models_line(compare_runs(base, other), base, other);
}

TEST(Difference, one_below_what_the_best_model_was_found_to_move_is_told_and_so_are_two_models) {
  const FinishedRun base = run_of_model(2, "rosseland", 0.9), best = run_of_model(2.2, "transfer", 0);
  const RunComparison near = compare_runs(base, run_of_model(2.1, "rosseland", 0.95));
  EXPECT_DOUBLE_EQ(wall(near).model, 0.95);
  EXPECT_EQ(shown(wall(near)).model, "0.95");
  const std::string smaller = told_of_models(base, run_of_model(2.1, "rosseland", 0.95));
  EXPECT_NE(smaller.find("found to move: wall\n    thickness, least"), std::string::npos) << smaller;
  const std::string larger = told_of_models(base, run_of_model(3, "rosseland", 0.9));
  EXPECT_EQ(larger, "  model of both: radiation rosseland (best: transfer)\n");
  EXPECT_NE(told_of_models(base, best)
                .find("the models differ: radiation rosseland (best: transfer) in the base, "
                      "radiation transfer here"),
            std::string::npos);
  EXPECT_EQ(told_of_models(best, best), "");
  for (const auto& [a, b] : {std::pair{base, run_of_model(2, "none", NAN)}, {run_of_model(2, "none", NAN), base}})
    EXPECT_EQ(shown(wall(compare_runs(a, b))).model, "?");
}

}  // namespace
}  // namespace parison::forming
