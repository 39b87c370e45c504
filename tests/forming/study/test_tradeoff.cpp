// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of accuracy against CPU time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../bundled_scene.hpp"
#include "forming/study/convergence_study.hpp"

namespace parison::forming {
namespace {

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

TEST(Accuracy, a_case_that_maps_its_mesh_is_held_against_a_finer_one) {
  const Scene cylinders = bundled("contact_cylinders", "fine"),
              finer = bundled("contact_cylinders", usual_reference(cylinders));
  EXPECT_GT(finer.glass.mesh.mapped->along_second, cylinders.glass.mesh.mapped->along_second);
  EXPECT_EQ(usual_reference(bundled("jar", "draft")), "fine");
}

TEST(Accuracy, the_study_of_the_jar_has_a_variant_for_each_part_of_its_model) {
  std::vector<Variant> study = standard_study(bundled("jar", "draft"), "fine");
  EXPECT_EQ(base_variant(study, "draft"), "draft");
  for (const char* name : {"standard", "mesh_x2", "no_radiation", "rosseland", "one_band", "no_enclosure",
                           "fixed_tools", "no_tension", "no_air_cooling", "no_gravity", "all_slip", "all_stick"})
    EXPECT_EQ(std::count_if(study.begin(), study.end(), [&](const Variant& r) { return r.name == name; }), 1) << name;
  for (const Variant& one : study) EXPECT_NO_THROW(bundled("jar", one.accuracy, one.overrides)) << one.name;
}

}  // namespace
}  // namespace parison::forming
