// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../scene_text.hpp"
#include "forming/remeshing/named_boundary.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {
namespace {

const std::string cases = std::string(PARISON_SOURCE_DIR) + "/cases/";
const std::string one = "duration = \"1 s\"\n", two = "duration = \"2 s\"\n";
const std::string third =
    "[[stage]]\nname = \"open\"\nduration = \"1 s\"\ntools = [\"plate\"]\npressure.inner = \"1 bar\"\n[[probe]]";

/// The stage that names the inner side and the tool that made it: "reheat plunger".
std::string maker(const Scene& scene) {
  for (const Stage& stage : scene.stages)
    for (const NamedBoundary& named : stage.named_boundaries)
      if (named.touched) return stage.name + " " + scene.tools[*named.touched].name + " " + named.name;
  return "";
}

/// Length of the edges of a named boundary, m, and the highest place on it.
std::pair<double, double> extent(const core::Mesh& mesh, const std::string& name) {
  double length = 0, highest = -1;
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.boundaries()[edge.boundary_id].name == name) {
      length += (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).norm();
      highest = std::max({highest, mesh.nodes[edge.nodes[0]][1], mesh.nodes[edge.nodes[1]][1]});
    }
  return {length, highest};
}

TEST(NamedBoundary, the_inner_side_of_the_bundled_cases_is_that_of_plunger_or_pin) {
  EXPECT_EQ(maker(read_scene(cases + "jar", "draft")), "reheat plunger inner");
  EXPECT_EQ(maker(read_scene(cases + "tumbler", "draft")), "cool plunger inner");
  EXPECT_EQ(maker(read_scene(cases + "bottle", "draft")), "corkage pin inner");
}

TEST(NamedBoundary, a_stage_that_loads_the_inner_side_has_it_named_where_the_plunger_has_left) {
  EXPECT_EQ(maker(scene_of(replaced("[[probe]]", third))), "open plunger inner");
  EXPECT_EQ(maker(scene_of(small_scene)), "");
}

TEST(NamedBoundary, what_a_tool_touched_is_named_and_nothing_else) {
  const std::string plate = "name_boundary = [{ name = \"foot\", touched = \"plate\" }]\n";
  const Scene on_plate = scene_of(replaced(two, two + plate));
  const State state = initial_state(on_plate);
  const auto [length, highest] = extent(start_stage(on_plate, state, 1).glass.mesh, "foot");
  EXPECT_NEAR(length, 0.02, 1e-9);
  EXPECT_NEAR(highest, 0, 1e-12);
  EXPECT_EQ(misplaced_boundary(on_plate, state, 1), "");
  // The face of the plunger ends at a radius of 15 mm; edges of 1.6 mm.
  const std::string face_named = "tools = [\"plate\"]\nname_boundary = [{ name = \"face\", touched = \"plunger\" }]\n";
  const Scene pressed =
      scene_of(replaced("[[probe]]", replaced("tools = [\"plate\"]\npressure.inner = \"1 bar\"\n", face_named, third)));
  const auto [face, top] = extent(start_stage(pressed, initial_state(pressed), 2).glass.mesh, "face");
  EXPECT_GT(face, 0.015 - 1.6e-3);
  EXPECT_LE(face, 0.015 + 1e-9);
  EXPECT_NEAR(top, 0.01, 1e-12);
}

TEST(NamedBoundary, an_end_on_the_axis_is_on_the_axis_also_where_the_surface_beside_it_is_nearer) {
  const std::string named = "name_boundary = [{ name = \"face\", from = \"(20, 10) mm\", to = \"(0, 12) mm\" }]\n";
  const Scene scene = scene_of(replaced(two, two + named));
  State state = initial_state(scene);
  for (Point& x : state.glass.mesh.nodes)  // a dent of 2 mm in the middle of the upper face
    if (x[1] > 0.01 - 1e-9 && x[0] < 5e-3) x[1] -= 2e-3 * (1 - x[0] / 5e-3);
  EXPECT_GT(extent(start_stage(scene, state, 1).glass.mesh, "face").first, 0.02);
}

TEST(NamedBoundary, the_inner_side_goes_on_to_where_other_tools_seal_it) {
  // Air that is let in where the plunger was also reaches the rim, down the side, to the plate.
  const Scene pressed = scene_of(replaced("[[probe]]", third));
  State state = initial_state(pressed);
  state.stage = 1;
  const auto [length, top] = extent(start_stage(pressed, state, 2).glass.mesh, "inner");
  EXPECT_NEAR(length, 0.02 + 0.01, 1.7e-3);
  // Off the plate nothing seals: then it is what the plunger touched.
  for (Point& x : state.glass.mesh.nodes) x[1] += 0.3e-3;
  state.tools[1].offset += 0.3e-3;
  EXPECT_NEAR(extent(start_stage(pressed, state, 2).glass.mesh, "inner").first, 0.015, 1.7e-3);
}

TEST(NamedBoundary, where_glass_has_come_off_the_plunger_the_side_goes_on_and_other_tools_part_it) {
  const std::string named = "tools = [\"plate\"]\nname_boundary = [{ name = \"side\", touched = \"plunger\" }]\n";
  const Scene pressed =
      scene_of(replaced("[[probe]]", replaced("tools = [\"plate\"]\npressure.inner = \"1 bar\"\n", named, third)));
  State state = initial_state(pressed);
  state.tools[1].offset = 0.02;  // away from the glass, which remembers its contacts
  int count = 0;
  for (Index n = 0; n < state.glass.mesh.node_count(); ++n) {
    const Point& x = state.glass.mesh.nodes[n];
    if (x[1] > 0.01 - 1e-9 && (x[0] < 0.004 || (x[0] > 0.009 && x[0] < 0.014)))
      state.glass.contact_tool[n] = 1, ++count;
  }
  ASSERT_GT(count, 4);
  EXPECT_GT(extent(start_stage(pressed, state, 2).glass.mesh, "side").first, 0.010);
  for (Index n = 0; n < state.glass.mesh.node_count(); ++n) {
    const Point& x = state.glass.mesh.nodes[n];
    if (x[1] > 0.01 - 1e-9 && x[0] > 0.0045 && x[0] < 0.0085) state.glass.contact_tool[n] = 0;
  }
  EXPECT_LT(extent(start_stage(pressed, state, 2).glass.mesh, "side").first, 0.0055);
}

TEST(NamedBoundary, a_tool_that_no_glass_touches_names_nothing_and_that_is_told) {
  const Scene scene = scene_of(replaced("[[probe]]", third));
  State state = initial_state(scene);
  state.tools[1].offset = 0.02;
  EXPECT_EQ(misplaced_boundary(scene, state, 2),
            "name_boundary inner: no glass touches \"plunger\" at the end of the stage before");
}

TEST(NamedBoundary, mistakes_have_their_sentences) {
  const auto with = [](const std::string& stage, const std::string& keys) {
    const auto text = complaint_about(replaced(stage, stage + "name_boundary = [{ name = \"foot\", " + keys + " }]\n"));
    return text.substr(text.find(' ') + 1);
  };
  EXPECT_EQ(with(one, "touched = \"plate\""),
            "stage.name_boundary.touched: no tool is active in the stage before, allowed is \"from\" with \"to\"");
  EXPECT_EQ(with(two, "touched = \"plat\""),
            "stage.name_boundary.touched: \"plat\" was found (did you mean \"plate\"?), allowed are plate");
  EXPECT_EQ(with(two, "touched = \"plate\", from = \"(0, 0) mm\""),
            "stage.name_boundary.from: a point and \"touched\" were found, allowed is one of them");
  EXPECT_EQ(with(two, "to = \"(0, 0) mm\""),
            "stage.name_boundary.from: missing, the table that starts here needs the key \"from\"");
}

TEST(NamedBoundary, check_tells_of_a_point_that_lies_far_from_glass_and_tools) {
  const auto said = [](const std::string& from) {
    return describe_scene(scene_of(
        replaced(two, two + "name_boundary = [{ name = \"side\", from = \"" + from + "\", to = \"(20, 10) mm\" }]\n")));
  };
  EXPECT_NE(said("(20, 0) mm").find("names side: from (20, 0) to (20, 10) mm"), std::string::npos);
  EXPECT_EQ(said("(20, 0) mm").find("from every tool"), std::string::npos);
  EXPECT_NE(said("(30, 5) mm").find("(30, 5) mm lies 5 mm from the glass as drawn and from every tool"),
            std::string::npos)
      << said("(30, 5) mm");
}

TEST(NamedBoundary, several_tools_that_may_have_made_the_inner_side_are_told) {
  const std::string idle = replaced("motion.plunger = { force = \"-5 N\", speed_limit = \"10 mm/s\" }\n", "",
                                    replaced("[[probe]]", replaced("tools = [\"plate\"]\n", "", third)));
  const auto said = complaint_about(idle);
  EXPECT_NE(
      said.find("stage.pressure.inner: several tools may have made the inner side (plate, plunger), allowed is to say "
                "which: name_boundary = [{ name = \"inner\", touched = \"plate\" }] in the stage after it"),
      said.npos)
      << said;
}

}  // namespace
}  // namespace parison::forming
