// SPDX-License-Identifier: GPL-3.0-or-later
// Bars from quantities of coarser runs.
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "core/io/json_read.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/report/model_bars.hpp"
#include "forming/report/summary.hpp"

namespace parison::forming {
namespace {

TEST(Accuracy, a_profile_is_compared_away_from_where_the_wall_ends) {
  std::vector<double> a(profile_points, 2.0), b = a;
  for (int i = 0; i < 40; ++i) a[i] = NAN;
  a[41] = 20;  // beside the end: left aside
  a[200] = 2.1;
  const auto difference = compare_profiles(a, b);
  EXPECT_NEAR(difference.max, 0.05, 1e-12);
  EXPECT_NEAR(difference.where, 0.5, 1e-12);
  EXPECT_TRUE(std::isnan(compare_profiles({}, b).mean));
}

/// Runs 1, 1.5 and 3 times as coarse of quantities whose errors grow with this order.
ErrorBars bars_of_order(double order, double shift_of_second = 0) {
  const auto run = [&](double factor) {
    const double grows = std::pow(factor, order);
    return Quantities{{{"heat_a", "J", 100 + grows, 100},
                       {"heat_b", "J", 50 + (0.8 + shift_of_second) * grows - shift_of_second, 50},
                       {"time_a", "s", 1 + 0.02 * grows, 1}},
                      {}};
  };
  std::vector<CoarserRun> coarser;
  for (const double factor : coarser_factors) coarser.push_back({factor, run(factor)});
  return error_bars(run(1), coarser);
}

TEST(Accuracy, a_bar_holds_errors_of_low_and_of_second_order_and_is_less_than_eight_times_as_wide) {
  const double errors[] = {1, 0.8, 0.02};
  for (const double order : {0.8, 1.0, 2.0}) {
    const ErrorBars bars = bars_of_order(order);
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(bars.quantities.values[i].error, errors[i]);
      EXPECT_LT(bars.quantities.values[i].error, 8 * errors[i]);
    }
  }
}

TEST(Accuracy, heats_that_agree_by_chance_get_the_usual_bar_of_heats) {
  const ErrorBars bars = bars_of_order(1, -0.8);  // all runs give the second heat alike
  EXPECT_GT(bars.quantities.values[1].error, 0.2 * bars.quantities.values[0].error);
}

TEST(Accuracy, a_bar_is_never_below_the_resolution_and_missing_where_no_coarser_run_has_the_quantity) {
  const Quantities run{{{"heat_a", "J", 100, 100}, {"heat_b", "J", 50, 50}}, {}};
  const Quantities other{{{"heat_a", "J", 100, 100}}, {}};
  const ErrorBars bars = error_bars(run, {{1.5, other}});
  EXPECT_NEAR(bars.quantities.values[0].error, 1e-4 * std::sqrt(100 * 150), 1e-12);
  EXPECT_TRUE(std::isnan(bars.quantities.values[1].error));
  EXPECT_TRUE(std::isnan(bars.profile_mean));
}

TEST(Accuracy, without_the_coarsest_run_the_same_difference_makes_a_wider_bar) {
  EXPECT_GT(richardson_estimate(1, 1, 1.5), 3 * richardson_estimate(1, 1, 3));
  EXPECT_NEAR(richardson_estimate(1, 1, 3), 0.96, 0.01);
}

TEST(Accuracy, a_run_that_agrees_with_a_coarser_one_by_chance_gets_the_bar_of_the_coarser_ones) {
  const double coarse = richardson_estimate(0.2, 1.5, 3), fine = richardson_estimate(0.1, 1, 1.5);
  EXPECT_NEAR(bar_of_values({{1, 5}, {1.5, 4.99}, {3, 5.19}}), coarse, 1e-12);  // goes down and up
  EXPECT_NEAR(bar_of_values({{1, 5}, {1.5, 5.1}, {3, 5.3}}), fine, 1e-12);      // goes one way
  EXPECT_TRUE(std::isnan(bar_of_values({{1, 5}})));
  EXPECT_TRUE(std::isnan(bar_of_values({{1, 5}, {3, NAN}})));
}

TEST(Accuracy, a_bar_by_one_coarser_run_alone_is_wider_as_that_of_two_grids_is) {
  const double alone = 2.4 * richardson_estimate(0.1, 1, 3);
  EXPECT_NEAR(bar_of_values({{1, 5}, {3, 5.1}}), alone, 1e-12);
  EXPECT_NEAR(bar_of_values({{1, 5}, {1.5, NAN}, {3, 5.1}}), alone, 1e-12);
  EXPECT_LT(bar_of_values({{1, 5}, {1.5, 5}, {3, 5.1}}), alone);
  const auto run = [](double heat, double wall) {
    return Quantities{{{"heat_a", "J", heat, heat}}, std::vector<double>(profile_points, wall)};
  };
  const ErrorBars bars = error_bars(run(100, 2), {{3, run(101, 2.02)}});
  EXPECT_NEAR(bars.quantities.values[0].error, 10 * alone, 1e-9);
  EXPECT_NEAR(bars.profile_mean, 0.1 * alone, 1e-9);
  EXPECT_NEAR(bars.profile_max, 0.1 * alone, 1e-9);
  EXPECT_NEAR(bars.heat, 0.1 * alone, 1e-9);
}

TEST(Accuracy, the_table_says_what_an_accuracy_asked_for_is_that_of) {
  const auto told = [](double wall, double heat) {
    ErrorBars bars{{}, wall, wall, heat, {}, AccuracyRecord{0.02, {}}};
    const std::string table = error_table(bars);
    const auto begin = table.find("accuracy asked for: ");
    return table.substr(begin, table.find('\n', begin) - begin);
  };
  EXPECT_EQ(told(0.01, 0.01), "accuracy asked for: 2 % of the wall in the mean and of the heat into tools");
  EXPECT_EQ(told(0.01, NAN), "accuracy asked for: 2 % of the wall in the mean");
  EXPECT_EQ(told(NAN, 0.01), "accuracy asked for: 2 % of the heat into tools");
  EXPECT_EQ(told(NAN, NAN),
            "accuracy asked for: 2 % of each of the quantities above, as there is no wall and no heat into tools");
}

TEST(Accuracy, the_table_says_which_check_finer_runs_do_not_mend_and_what_was_reached) {
  ErrorBars bars{{}, 0.01, 0.01, 0.01, {}, AccuracyRecord{0.02, {{1, 0, true, 0.0045, {"flow_resolution is 35 %"}}}}};
  EXPECT_EQ(error_table(bars).find("finer runs"), std::string::npos);
  bars.control->not_mended = {"flow_resolution"};
  EXPECT_NE(error_table(bars).find("finer runs do not bring flow_resolution within the limit, so none was made; the "
                                   "error reached is estimated at 0.45 %"),
            std::string::npos);
}

const char* const measured = R"({ "some_models": { "scenes": [
  { "models": { "cheap": { "thickness": 0.1, "thinnest": 0.3, "heat": 0.04, "skin_K": 20 } } },
  { "models": { "cheap": { "thickness": 0.2, "heat": 0.02, "skin_K": 50 } } } ] } })";

Quantities wall_and_heat() {
  Quantities run{{{"thickness_mean", "mm", 3, 3},
                  {"thickness_min", "mm", 2, 2},
                  {"glass_mean", "degC", 800, 1000},
                  {"heat_a", "J", 90, 90},
                  {"heat_b", "J", 10, 10},
                  {"time_a", "s", 1, 1}},
                 {}};
  run.models = {{"radiation", "rosseland", "transfer"}};
  return run;
}

TEST(Models, a_model_is_off_by_the_most_of_all_scenes_and_one_that_was_not_measured_by_nobody_knows_what) {
  const ModelDifference found = model_difference(measured, "some_models", "cheap");
  EXPECT_DOUBLE_EQ(found.thickness, 0.2);
  EXPECT_DOUBLE_EQ(found.thinnest, 0.3);
  EXPECT_DOUBLE_EQ(found.heat, 0.04);
  EXPECT_DOUBLE_EQ(found.temperature, 50);
  EXPECT_TRUE(std::isnan(model_difference(measured, "some_models", "other").heat));
  EXPECT_TRUE(std::isnan(model_difference(measured, "other_models", "cheap").heat));
}

TEST(Models, each_quantity_gets_what_its_kind_was_moved_by_and_nothing_by_the_best_models) {
  Quantities run = wall_and_heat();
  add_model_bars({model_difference(measured, "some_models", "cheap"), {0.1, 0.1, 0.01, 5}}, run);
  EXPECT_NEAR(run.find("thickness_mean")->model, 0.9, 1e-12);
  EXPECT_NEAR(run.find("thickness_min")->model, 0.8, 1e-12);
  EXPECT_NEAR(run.find("glass_mean")->model, 55, 1e-12);
  EXPECT_NEAR(run.find("heat_b")->model, 0.05 * std::sqrt(10 * 100), 1e-12);
  EXPECT_TRUE(std::isnan(run.find("time_a")->model));
  add_model_bars({}, run);
  for (const Quantity& quantity : run.values) EXPECT_EQ(quantity.model, 0);
}

TEST(Models, rosseland_has_a_figure_of_every_kind_and_transfer_is_the_best) {
  EXPECT_NE(models_move_text({{"radiation", "rosseland", "transfer"}}).find("thinnest place"), std::string::npos);
  EXPECT_EQ(models_move_text({{"radiation", "none", "transfer"}}), "not measured");
  EXPECT_EQ(models_move_text({{"radiation", "transfer", "transfer"}}), "");
  EXPECT_EQ(models_text({{"radiation", "rosseland", "transfer"}}), "radiation rosseland (best: transfer)");
}

std::string models_of_scene(const std::string& from, const std::string& to) {
  return models_text(models_of(scene_of(replaced(from, to))));
}

TEST(Models, a_scene_has_those_of_its_parts_and_contact_is_by_the_law_of_most_tools) {
  const std::string density = ", density constant (best: expansion)";
  EXPECT_EQ(models_of_scene("", ""),
            "radiation none (best: transfer), contact constant (best: pressure-viscosity)" + density);
  EXPECT_EQ(models_of_scene("law = \"constant\"\nh = \"2000 W/m2/K\"", "law = \"gap\""),
            "radiation none (best: transfer), contact gap (best: pressure-viscosity)" + density);
  const std::string followed =
      "law = \"pressure-viscosity\"\nh0 = \"500 W/m2/K\"\nh1 = \"20000 W/m2/K\"\np_ref = \"0.2 MPa\"\n"
      "eta_ref = \"1e3 Pa.s\"\na = 1\nb = 0.25";
  EXPECT_EQ(models_of_scene("law = \"constant\"\nh = \"2000 W/m2/K\"", followed),
            "radiation none (best: transfer), contact pressure-viscosity" + density);
  EXPECT_EQ(models_of_scene("[material.soft]\n",
                            "air = { temperature = \"50 degC\", h = \"20 W/m2/K\", ambient = \"50 degC\" }\n"
                            "[material.soft]\nemissivity = 0.9\n"),
            "radiation none (best: transfer), contact constant (best: pressure-viscosity)" + density +
                ", enclosure false (best: true)");
}

TEST(Models, each_poorer_model_has_a_figure_of_every_kind) {
  for (const ModelUse& poorer :
       {ModelUse{"contact", "constant", "pressure-viscosity"}, ModelUse{"contact", "gap", "pressure-viscosity"},
        ModelUse{"density", "constant", "expansion"}, ModelUse{"enclosure", "false", "true"}})
    for (const char* kind : {"wall", "thinnest place", "heat into tools", "skins"})
      EXPECT_NE(models_move_text({poorer}).find(kind), std::string::npos) << poorer.part << ' ' << poorer.used;
}

TEST(Models, the_table_of_error_bars_has_a_column_of_them_and_names_the_model) {
  Quantities run = wall_and_heat();
  add_model_bars({{0.1, 0.25, 0.01, 5}}, run);
  const std::string table = error_table(error_bars(run, {{1.5, run}}));
  EXPECT_NE(table.find("numerical     model"), std::string::npos) << table;
  EXPECT_NE(table.find("       0.5 mm\n"), std::string::npos) << table;
  EXPECT_NE(table.find("         ? s\n"), std::string::npos) << table;
  EXPECT_NE(table.find("model: radiation rosseland (best: transfer)"), std::string::npos) << table;
}

TEST(Models, bars_and_names_go_through_the_summary_and_error_bars_keep_them) {
  Quantities run = wall_and_heat();
  add_model_bars({{0.1, 0.25, 0.01, 5}}, run);
  core::JsonWriter json;
  add_quantities(json, error_bars(run, {{1.5, run}}).quantities);
  const Quantities found = read_quantities(core::read_json(json.finish(), "summary"));
  EXPECT_DOUBLE_EQ(found.find("thickness_min")->model, 0.5);
  EXPECT_TRUE(std::isnan(found.find("time_a")->model));
  ASSERT_EQ(found.models.size(), 1u);
  EXPECT_EQ(models_text(found.models), models_text(run.models));
}

}  // namespace
}  // namespace parison::forming
