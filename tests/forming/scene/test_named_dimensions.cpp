// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"

namespace parison::forming {
namespace {

const std::string with_names = replaced("[[tool]]", "[dimension]\nr = \"20 mm\"\nh = \"r/2\"\n[[tool]]");

TEST(NamedDimensions, paths_arcs_and_quantities_use_them) {
  const Scene plain = scene_of(small_scene);
  for (const char* path : {"(0, 0) (r, 0) (r, h) (0, h)", "(0, 0) (r, 0) (20, (r + 0 mm)/2) (0, min(h, r)) mm"}) {
    const Scene named = scene_of(replaced("(0, 0) (20, 0) (20, 10) (0, 10) mm", path, with_names));
    ASSERT_EQ(named.glass.profile.segments.size(), plain.glass.profile.segments.size());
    for (std::size_t i = 0; i < plain.glass.profile.segments.size(); ++i)
      EXPECT_LT((named.glass.profile.segments[i].end - plain.glass.profile.segments[i].end).norm(), 1e-15);
  }
  const Scene arc = scene_of(replaced("path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"",
                                      "path = \"arc centre (0, h) radius h from -90 deg to 45 deg*2\"", with_names));
  EXPECT_NEAR(outline_volume(arc.glass.profile, arc.geometry), 4 * M_PI / 3 * 1e-6, 1e-9);
  const Scene moved = scene_of(replaced("position = \"10 mm\"", "position = \"h + 1 mm\"", with_names));
  EXPECT_DOUBLE_EQ(moved.tools[1].position, 0.011);
}

TEST(NamedDimensions, a_key_of_the_case_behind_their_heading_is_told_as_that) {
  const auto message = complaint_about("[dimension]\nr = \"20 mm\"\nair = { h = \"20 W/m2/K\" }\n" + small_scene);
  EXPECT_NE(message.find("dimension.air: a table was found, allowed are quantities such as \"24 mm\"; keys that follow "
                         "[dimension] belong to it up to the next heading"),
            message.npos)
      << message;
}

TEST(NamedDimensions, zeros_alone_need_no_unit) {
  EXPECT_EQ(complaint_about(replaced("path = \"(0, 0) mm\", condition = \"symmetry\" },\n]\n[[tool]]\nname = \"plate\"",
                                     "path = \"(0, 0)\", condition = \"symmetry\" },\n]\n[[tool]]\nname = \"plate\"")),
            "");
  EXPECT_NE(complaint_about(replaced("(20, 0) (20, 10) (0, 10) mm", "(20, 0) (20, 10) (0, 10)")), "");
}

TEST(NamedDimensions, one_that_is_set_changes_all_that_uses_it) {
  const auto folder =
      write_scene(replaced("(0, 0) (20, 0) (20, 10) (0, 10) mm", "(0, 0) (r, 0) (r, h) (0, h)", with_names));
  const Scene scene = read_scene(folder, "draft", {"dimension.r=10 mm"});
  EXPECT_NEAR(outline_volume(scene.glass.profile, scene.geometry), M_PI * 1e-4 * 0.005, 1e-12);
  EXPECT_EQ(scene.dimensions.at(1).given, "10 mm");
}

TEST(NamedDimensions, unknown_ones_in_a_path_are_told_with_line_and_names) {
  const std::string text =
      replaced("(0, 0) (20, 0) (20, 10) (0, 10) mm", "(0, 0) (rr, 0) (20, 10) (0, 10) mm", with_names);
  EXPECT_EQ(complaint_about(text), std::to_string(line_of("(rr, 0)", text)) +
                                       ": glass.boundary.path: \"rr\" is no quantity: there is no dimension \"rr\", "
                                       "allowed are h, r");
}

}  // namespace
}  // namespace parison::forming
