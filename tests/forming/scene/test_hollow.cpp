// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/container/hollow.hpp"

namespace parison::forming {
namespace {

/// Glass between the axis and the corners given, from the axis to the axis, mm.
core::Profile glass_of(const std::vector<core::Point>& corners) {
  core::Profile profile;
  for (std::size_t i = 0; i < corners.size(); ++i)
    profile.segments.push_back({1e-3 * corners[i], 1e-3 * corners[(i + 1) % corners.size()]});
  return profile;
}

std::optional<Hollow> hollow_of(const std::vector<core::Point>& corners, int up = 1) {
  const core::Profile profile = glass_of(corners);
  return forming::hollow_of(*slices_of({&profile, {true}, 0}), up);
}

/// Volume of a cone and of a frustum, radii and height in mm, ml.
double frustum(double a, double b, double height) {
  return 1e-3 * M_PI / 3 * height * (a * a + a * b + b * b);
}

TEST(Hollow, an_island_of_glass_around_the_axis_takes_its_volume_from_what_a_cup_holds) {
  // A cup of 20 mm inner radius and 30 mm depth on a bottom of 5 mm, with a cone of 10 mm radius and 15 mm height.
  const auto cup = hollow_of({{0, 0}, {25, 0}, {25, 35}, {20, 35}, {20, 5}, {10, 5}, {0, 20}});
  ASSERT_TRUE(cup);
  EXPECT_NEAR(1e3 * cup->rim, 35, 1e-9);
  EXPECT_NEAR(1e6 * cup->capacity, frustum(20, 20, 30) - frustum(10, 0, 15), 1e-6);
  EXPECT_NEAR(1e6 * *cup->to_depth(20e-3), frustum(20, 20, 10) - frustum(10, 10. / 3, 10), 1e-4);
  EXPECT_FALSE(cup->to_depth(30.1e-3));
}

TEST(Hollow, an_island_higher_than_the_brim_does_not_raise_it) {
  const auto cup = hollow_of({{0, 0}, {25, 0}, {25, 35}, {20, 35}, {20, 5}, {10, 5}, {0, 65}});
  ASSERT_TRUE(cup);
  EXPECT_NEAR(1e3 * cup->rim, 35, 1e-9);
  EXPECT_NEAR(1e6 * cup->capacity, frustum(20, 20, 30) - frustum(10, 5, 30), 1e-6);
}

TEST(Hollow, glass_open_below_or_upside_down_holds_nothing_and_a_bubble_in_a_wall_does_not_count) {
  EXPECT_FALSE(hollow_of({{5, 0}, {25, 0}, {25, 35}, {20, 35}, {20, 5}, {5, 5}}));
  EXPECT_FALSE(hollow_of({{0, 0}, {25, 0}, {25, 35}, {20, 35}, {20, 5}, {0, 5}}, -1));
  EXPECT_TRUE(hollow_of({{0, 0}, {25, 0}, {25, -35}, {20, -35}, {20, -5}, {0, -5}}, -1));
  core::Profile ball = glass_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  for (const auto& segment : glass_of({{0, 2}, {8, 2}, {8, 8}, {0, 8}}).segments) ball.segments.push_back(segment);
  EXPECT_FALSE(forming::hollow_of(*slices_of({&ball, {true}, 0}), 1));
}

TEST(ContainerPlan, a_pressed_cup_holds_what_stays_around_the_glass_in_the_recess_of_its_plunger) {
  // The tumbler with a cone of 10 mm radius and 9 mm height cut out of the tip of its plunger.
  const auto text = R"(case = "cup"
geometry = "axisymmetric"
output.fill_level = "5 mm"
[material.soft]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
[glass]
material = "soft"
gob = { mass = "95.5 g", diameter = "40 mm", at = "(0, 0) mm" }
[[tool]]
name = "mould"
friction = "stick"
boundary = [
  { name = "cavity", path = "(0, 0) (25, 0) (25, 40) mm", condition = "contact" },
  { name = "rest", path = "(40, 40) (40, -20) (0, -20) mm", condition = "insulated" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]
[[tool]]
name = "ring"
friction = "stick"
boundary = [
  { name = "under", path = "(20, 40) (25, 40) mm", condition = "contact" },
  { name = "rest", path = "(40, 40) (40, 50) (20, 50) mm", condition = "insulated" },
  { name = "hole", path = "(20, 40) mm", condition = "contact" },
]
[[tool]]
name = "plunger"
friction = "stick"
position = "60 mm"
boundary = [
  { name = "face", path = "(0, 9) (10, 0) (20, 0) (20, 120) mm", condition = "contact" },
  { name = "top", path = "(0, 120) mm", condition = "insulated" },
  { name = "axis", path = "(0, 9) mm", condition = "symmetry" },
]
[[stage]]
name = "press"
duration = "1 s"
tools = ["mould", "ring", "plunger"]
gravity = "-9.81 m/s2"
motion.plunger = { force = "-10 kN", speed_limit = "100 mm/s" }
)";
  const auto plan = plan_container(scene_of(text));
  ASSERT_TRUE(plan && plan->press && plan->capacity && plan->filled);
  const double bottom = 1e3 * plan->press->stop;
  const double around = frustum(20, 20, 40 - bottom) - frustum(10, 0, 9);
  EXPECT_NEAR(1e6 * *plan->capacity, around, 1e-3);
  EXPECT_NEAR(1e6 * *plan->filled, around - frustum(20, 20, 5), 1e-3);
  EXPECT_NEAR(1e6 * (*plan->capacity + plan->glass_volume), frustum(25, 25, 40), 1e-3);
}

}  // namespace
}  // namespace parison::forming
