// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "../scene_text.hpp"
#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/calibration.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/describe/model_sensitivity.hpp"
#include "forming/study/accuracy_control.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/tradeoff.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

Scene bundled(const std::string& name, const std::string& accuracy, const std::vector<std::string>& overrides = {}) {
  return read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/" + name, accuracy, overrides);
}

TEST(Accuracy, the_presets_are_three_points_of_one_scale) {
  for (const auto& [name, level] : {std::pair{"draft", 0}, std::pair{"standard", 1}, std::pair{"fine", 2}})
    for (const Setting& setting : settings())
      EXPECT_EQ(accuracy_preset(name).*setting.value, setting.levels[level]) << setting.key;
  EXPECT_NEAR(accuracy_at(0.5).surface_size, std::sqrt(accuracy_at(0).surface_size * accuracy_at(1).surface_size),
              1e-15);
}

TEST(Accuracy, a_finer_level_is_nowhere_coarser) {
  for (double level = -2; level < 3; level += 0.1) {
    const Accuracy coarse = accuracy_at(level), fine = accuracy_at(level + 0.1);
    for (const Setting& setting : settings())
      if (setting.order > 0 && setting.levels[0] > 0)
        EXPECT_LT(fine.*setting.value, coarse.*setting.value) << setting.key << " at " << level;
    EXPECT_GT(fine.elements_across, coarse.elements_across);
    EXPECT_GE(fine.passes, coarse.passes);
    EXPECT_LE(fine.initial_step, fine.max_step);
    EXPECT_LE(fine.skin_size, fine.surface_size);
  }
}

TEST(Accuracy, a_smaller_target_is_a_finer_level_whose_expected_error_it_is) {
  double last = -10;
  for (const double target : {0.04, 0.02, 0.01, 0.005, 0.0025}) {
    const double level = level_for(target);
    EXPECT_GT(level, last);
    EXPECT_NEAR(expected_error(level), target, 1e-12);
    EXPECT_NEAR(read_accuracy(fmt::format("{}%", 100 * target)).level, level, 1e-9);
    last = level;
  }
  for (const char* text :
       {"0%", "-1%", "1e9%", "1e-9%", "%", "x%", "0.5", "draft coarser", "draft coarser -2", "rough"})
    EXPECT_THROW(read_accuracy(text), core::CaseError) << text;
}

TEST(Accuracy, a_coarser_scene_has_coarser_meshes_of_its_own_too) {
  const Scene scene = bundled("shell_inflation", "draft"), coarse = bundled("shell_inflation", "draft coarser 2");
  EXPECT_NEAR(coarse.accuracy.strain_per_step, 2 * scene.accuracy.strain_per_step, 1e-12);
  EXPECT_EQ(coarse.glass.mesh.mapped->along_second, scene.glass.mesh.mapped->along_second / 2);
  EXPECT_EQ(read_accuracy(coarsened_text("draft coarser 2", 1.5)).coarsening_factor, 3);
  EXPECT_EQ(*read_accuracy(coarsened_text("1%", 1.5)).target, 0.01);
}

TEST(Accuracy, each_setting_says_who_chose_it) {
  const std::string text = describe_scene(bundled("shell_inflation", "1%", {"numerics.passes=3"}));
  const auto line = [&](const char* key) { return text.substr(text.find(std::string("  ") + key + ' '), 60); };
  EXPECT_NE(line("passes").find("--set"), std::string::npos);
  EXPECT_NE(line("strain_per_step").find("case"), std::string::npos);
  EXPECT_NE(line("surface_size").find("guess"), std::string::npos);
}

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

TEST(Accuracy, a_bar_holds_errors_of_low_and_of_second_order_and_is_less_than_seven_times_as_wide) {
  const double errors[] = {1, 0.8, 0.02};
  for (const double order : {0.8, 1.0, 2.0}) {
    const ErrorBars bars = bars_of_order(order);
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(bars.quantities.values[i].error, errors[i]);
      EXPECT_LT(bars.quantities.values[i].error, 7 * errors[i]);
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
  EXPECT_GT(bar_over_difference(1.5), 3 * bar_over_difference(3));
  EXPECT_NEAR(bar_over_difference(3), 0.86, 0.01);
}

TEST(Accuracy, bars_of_a_small_scene_hold_the_error_against_a_finer_run) {
  const std::string folder = std::string(PARISON_BINARY_DIR) + "/test_accuracy_bars";
  fs::remove_all(folder);
  const auto results = [&](const char* accuracy, const std::string& directory, ErrorBars* bars) {
    const Scene scene = bundled("shell_inflation", accuracy);
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

VariantResult variant(const char* accuracy, double cpu, double error) {
  VariantResult result;
  result.variant = {accuracy, "accuracy", accuracy, {}, ""};
  result.completed = true;
  result.cpu = cpu;
  result.profile = {error, error, 0};
  result.heat = NAN;
  return result;
}

TEST(Accuracy, the_best_line_and_the_error_law_are_found) {
  const auto law = [](double level) { return 0.02 * (std::exp2(-1.5 * level) - std::exp2(-1.5 * 2)); };
  std::vector<VariantResult> results = {variant("fine", 1000, 0), variant("draft coarser 2", 1, law(-1)),
                                        variant("draft", 10, law(0)), variant("standard", 100, law(1))};
  results.front().variant.group = "reference";
  results.push_back(variant("draft", 30, law(0)));
  results.back().variant.group = "mesh";
  mark_front(results);
  EXPECT_TRUE(results[2].on_front);
  EXPECT_FALSE(results[4].on_front || results[0].on_front);
  EXPECT_NEAR(over_front(results, results[4]), 3, 1e-9);
  const ErrorLaw found = fit_error_law(results, [](const VariantResult& r) { return r.profile.mean; });
  EXPECT_NEAR(found.order, 1.5, 0.011);
  EXPECT_NEAR(found.at_draft, 0.02, 5e-4);
}

TEST(Accuracy, inertia_that_matters_is_warned_of) {
  const Scene jar = bundled("jar", "draft");
  EXPECT_EQ(describe_sensitivity(jar).find("warning"), std::string::npos);
  const Scene fast = bundled("shell_inflation", "draft", {"material.liquid.viscosity.value=1 Pa.s"});
  EXPECT_NE(describe_sensitivity(fast).find("warning: inertia is neglected"), std::string::npos);
}

const PartSensitivity& part(const std::vector<PartSensitivity>& parts, const std::string& name) {
  return *std::find_if(parts.begin(), parts.end(), [&](const PartSensitivity& p) { return p.name == name; });
}

TEST(Accuracy, held_tools_bring_standing_glass_the_heat_of_the_exact_solution) {
  // Two half-spaces, h 5000, 10 s, crystal glass on steel, by hand: 1.808 over 1.523.
  const auto parts = model_sensitivity(bundled("contact_cylinders", "draft"));
  EXPECT_NEAR(part(parts, "warming of tools").heat, 0.187, 0.002);
}

TEST(Accuracy, what_tools_press_on_both_sides_has_a_wall_of_theirs) {
  const auto blown = model_sensitivity(bundled("jar", "draft")),
             pressed = model_sensitivity(bundled("tumbler", "draft"));
  for (const char* name :
       {"surface tension", "gravity", "friction on tools", "internal radiation", "surface radiation"})
    EXPECT_LT(part(pressed, name).thickness, 0.1 * part(blown, name).thickness) << name;
  EXPECT_GT(part(pressed, "internal radiation").heat, 0.1);
}

TEST(Accuracy, what_has_no_time_changes_nothing_and_tools_that_stand_press_nothing) {
  const std::string sag =
      small_scene.substr(0, small_scene.find("[[stage]]\nname = \"press\"")) + "gravity = \"-9.81 m/s2\"\n";
  const auto at = [&](const char* duration, const std::string& more = "", const char* h = "2000") {
    std::string text = replaced("duration = \"1 s\"", fmt::format("duration = \"{}\"", duration), sag);
    text = replaced("h = \"2000 W/m2/K\"", fmt::format("h = \"{} W/m2/K\"", h), text);
    return model_sensitivity(scene_of(text + more));
  };
  for (const char* name :
       {"surface tension", "gravity", "friction on tools", "internal radiation", "warming of tools"}) {
    EXPECT_LT(part(at("1 ms"), name).thickness, 0.01) << name;
    EXPECT_GE(part(at("10 s"), name).thickness, part(at("1 ms"), name).thickness) << name;
  }
  const auto static_stage = at("0.5 s", "motion.plate = { offset = \"0 mm\" }\n"), still = at("0.5 s");
  EXPECT_EQ(part(static_stage, "gravity").thickness, part(still, "gravity").thickness);
  for (const auto& p : at("10 s", "", "1e-6")) EXPECT_TRUE(std::isfinite(p.heat) && p.heat < 1.001) << p.name;
}

TEST(Accuracy, parts_that_a_case_switches_off_are_called_neglected) {
  std::vector<std::string> slip{"material.flint.radiation.thin_wall=false", "air.h=0 W/m2/K"};
  for (const char* tool : {"ring", "plate", "blank", "plunger", "blow_mould"})
    slip.push_back(fmt::format("tool.{}.friction=slip", tool));
  const std::string text = describe_sensitivity(bundled("jar", "draft", slip));
  for (const char* name : {"thin-wall limit", "friction on tools", "cooling by air"})
    EXPECT_NE(text.find(fmt::format("  {:<20}neglected", name)), std::string::npos) << text;
  EXPECT_NE(text.find("parison audit"), std::string::npos);
  EXPECT_EQ(text.find('%'), std::string::npos) << "no estimate that is not proved";
}

TEST(Accuracy, a_case_that_maps_its_mesh_is_held_against_a_finer_one) {
  const Scene cylinders = bundled("contact_cylinders", "fine"),
              finer = bundled("contact_cylinders", usual_reference(cylinders));
  EXPECT_GT(finer.glass.mesh.mapped->along_second, cylinders.glass.mesh.mapped->along_second);
  EXPECT_EQ(usual_reference(bundled("jar", "draft")), "fine");
}

TEST(Accuracy, both_ends_of_the_targets_that_the_error_names_are_taken) {
  for (const char* text : {"0.13%", "7%"}) EXPECT_NO_THROW(read_accuracy(text)) << text;
  for (const char* text : {"0.129%", "7.01%"}) EXPECT_THROW(read_accuracy(text), core::CaseError) << text;
}

TEST(Accuracy, settings_that_make_no_sense_are_refused) {
  for (const char* text : {"elements_across=0.1", "max_cells=1", "surface_size=1 m", "strain_per_step=10",
                           "tool_growth=100", "quality_floor=0.95", "solution_error=-0.1"}) {
    EXPECT_THROW(bundled("jar", "draft", {std::string("numerics.") + text}), core::CaseError) << text;
  }
  try {
    bundled("jar", "draft", {"numerics.surface_size=1 m"});
  } catch (const core::CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("1000 mm was found, allowed are values from 0.0001 mm to 100 mm"),
              std::string::npos)
        << error.what();
  }
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

TEST(AccuracyControl, two_runs_that_agree_by_chance_are_not_enough) {
  AccuracyControl control(0.01);
  const double first = control.factor();
  control.add(off_by(0.05, 1, 1), 1);
  control.add(off_by(0.05, 1, 1), 1);
  EXPECT_FALSE(control.record().reached());
  ASSERT_FALSE(control.finished());
  control.add(off_by(0.05, 1, control.factor() / first), 1);
  EXPECT_FALSE(control.record().reached()) << "the third is far from both";
}

TEST(AccuracyControl, refines_after_a_run_that_stopped_and_gives_up_after_seven) {
  AccuracyControl control(0.01);
  double last = 2 * control.factor();
  while (!control.finished()) {
    EXPECT_LT(control.factor(), last);
    last = control.factor();
    control.add(std::nullopt, 1);
  }
  EXPECT_EQ(control.record().runs.size(), 7u);
  EXPECT_FALSE(control.record().reached());
}

TEST(Accuracy, the_study_of_the_jar_has_a_variant_for_each_part_of_its_model) {
  std::vector<Variant> study = standard_study(bundled("jar", "draft"), "fine");
  EXPECT_EQ(base_variant(study, "draft"), "draft");
  for (const char* name : {"standard", "mesh_x2", "passes_2", "temperature_order_1", "no_radiation", "no_thin_wall",
                           "fixed_tools", "no_tension", "no_air_cooling", "no_gravity", "all_slip", "all_stick"})
    EXPECT_EQ(std::count_if(study.begin(), study.end(), [&](const Variant& r) { return r.name == name; }), 1) << name;
  for (const Variant& one : study) EXPECT_NO_THROW(bundled("jar", one.accuracy, one.overrides)) << one.name;
}

}  // namespace
}  // namespace parison::forming
