// SPDX-License-Identifier: GPL-3.0-or-later
// Presets, levels and settings of the numerics.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../bundled_scene.hpp"
#include "../scene_text.hpp"
#include "core/case/case_error.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/calibration.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"

namespace parison::forming {
namespace {

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
  const std::string text = describe_scene(
      read_scene(write_scene(small_scene + "[numerics]\nstrain_per_step = 0.04\n"), "1%", {"numerics.max_step=0.1 s"}));
  const auto line = [&](const char* key) { return text.substr(text.find(std::string("  ") + key + ' '), 60); };
  EXPECT_NE(line("max_step").find("--set"), std::string::npos);
  EXPECT_NE(line("strain_per_step").find("case"), std::string::npos);
  EXPECT_NE(line("surface_size").find("guess"), std::string::npos);
}

TEST(Accuracy, both_ends_of_the_targets_that_the_error_names_are_taken) {
  for (const char* text : {"0.13%", "7%"}) EXPECT_NO_THROW(read_accuracy(text)) << text;
  for (const char* text : {"0.129%", "7.01%"}) EXPECT_THROW(read_accuracy(text), core::CaseError) << text;
}

TEST(Accuracy, settings_that_make_no_sense_are_refused) {
  for (const char* text :
       {"elements_across=0.1", "max_cells=1", "surface_size=1 m", "strain_per_step=10", "quality_floor=0.95"}) {
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

}  // namespace
}  // namespace parison::forming
