// SPDX-License-Identifier: GPL-3.0-or-later
// Heat at extremes of a scene whose meshes the program chooses, against two half-spaces brought together.
#include <gtest/gtest.h>

#include <cmath>

#include "../bundled_scene.hpp"
#include "../scene_text.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/skin_size.hpp"

namespace parison::forming {
namespace {

struct Contact {
  double h = 2000, time = 1, tool_conductivity = 46, jump = 600;
};

/// The disc on its plate, which does not flow.
std::string disc_on_plate(const Contact& contact) {
  auto text = replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }\n", "");
  text = text.substr(0, text.find("[[stage]]\nname = \"press\"")) + text.substr(text.find("[[probe]]"));
  text = replaced("duration = \"1 s\"", fmt::format("duration = \"{:g} s\"", contact.time), text);
  text = replaced("h = \"2000 W/m2/K\"", fmt::format("h = \"{:g} W/m2/K\"", contact.h), text);
  text = replaced("\"46 W/m/K\"", fmt::format("\"{:g} W/m/K\"", contact.tool_conductivity), text);
  text =
      replaced("temperature = \"1000 degC\"", fmt::format("temperature = \"{:.12g} degC\"", 400 + contact.jump), text);
  return text;
}

/// Heat of the disc and its plate over the exact one, less 1. Neither skin reaches an end in the times here.
double error(const Contact& contact) {
  const auto outcome = run_in_folder(scene_of(disc_on_plate(contact)), tests::absent_folder());
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_EQ(complaints(outcome.facts.checks), std::vector<std::string>{});
  const double e1 = std::sqrt(1.3 * 2400 * 1300), e2 = std::sqrt(contact.tool_conductivity * 7200 * 490);
  const double b = contact.h * (1 / e1 + 1 / e2), y = b * std::sqrt(contact.time);
  const double scaled = y < 20 ? std::exp(y * y) * std::erfc(y) : 1 / (y * std::sqrt(M_PI));
  const double exact =
      M_PI * 0.02 * 0.02 * contact.h * contact.jump * ((scaled - 1) / (b * b) + 2 * std::sqrt(contact.time / M_PI) / b);
  const double found = outcome.state.tools[0].heat_received / exact - 1;
  std::printf("h %g, %g s, tool %g W/m/K, jump %g K: heat off by %.1e\n", contact.h, contact.time,
              contact.tool_conductivity, contact.jump, found);
  return std::abs(found);
}

TEST(ThermalSkin, the_way_to_the_cold_container_leaves_the_first_meshes_as_they_are) {
  const State formed = initial_state(bundled("nnpb", "draft")),
              on = initial_state(bundled("nnpb", "draft", {"cooling=standard"}));
  EXPECT_EQ(on.glass.mesh.nodes, formed.glass.mesh.nodes);
  for (std::size_t t = 0; t < formed.tools.size(); ++t) EXPECT_EQ(on.tools[t].mesh.nodes, formed.tools[t].mesh.nodes);
}

TEST(ThermalSkin, in_a_tool_that_hardly_conducts_is_resolved) {
  EXPECT_LT(error({2000, 0.2, 46e-3}), 1e-2);
  EXPECT_LT(error({2000, 0.2, 46e-5}), 1e-2);
}

TEST(ThermalSkin, of_a_contact_of_a_millisecond_is_resolved) {
  EXPECT_LT(error({2e4, 1e-3}), 1e-2);
}

TEST(ThermalSkin, a_jump_of_a_millikelvin_gives_heat_in_proportion) {
  EXPECT_LT(error({2000, 0.2, 46, 1e-3}), 1e-2);
}

TEST(ThermalSkin, contact_better_than_perfect_is_perfect_and_ends) {
  EXPECT_LT(error({1e12, 0.2}), 1e-2);
  EXPECT_LT(error({1e18, 0.2}), 1e-2);
}

TEST(ThermalSkin, glass_at_rest_has_more_cells_the_finer_the_preset) {
  for (const double time : {0.02, 0.5, 10.0}) {
    const auto cells = [&](const char* preset) {
      return initial_state(scene_of(disc_on_plate({2000, time}), preset)).glass.mesh.cells().size();
    };
    const auto draft = cells("draft"), standard = cells("standard"), fine = cells("fine");
    std::printf("%g s: %zu, %zu, %zu cells\n", time, draft, standard, fine);
    EXPECT_GT(standard, draft);
    EXPECT_GT(fine, standard);
  }
}

TEST(ThermalSkin, of_a_mapped_mesh_knows_how_its_divisions_grow) {
  const auto four_sides =
      replaced(R"({ name = "surface", path = "(0, 0) (20, 0) (20, 10) (0, 10) mm", condition = "contact" })",
               R"({ name = "bottom", path = "(0, 0) (20, 0) mm", condition = "contact" },
         { name = "side", path = "(20, 10) mm", condition = "contact" },
         { name = "surface", path = "(0, 10) mm", condition = "contact" })");
  const auto growth = [&](const std::string& mesh) {
    const auto text = replaced("[glass]\n", "[glass]\nmesh = { " + mesh + " }\n", four_sides);
    return skin_side(scene_of(text), glass_body, 1e-4).growth;
  };
  const double usual = growth("mapped = [29, 2]");
  EXPECT_LT(usual, 1);
  EXPECT_NEAR(growth("mapped = [29, 2], ratio = [1, 20]"), 19, 1e-12);  // the second division is 20 times the first
  EXPECT_NEAR(growth("mapped = [3, 29], ratio = [0.0625, 1]"), 3, 1e-12);
  EXPECT_EQ(growth("mapped = [29, 40], ratio = [1, 20]"), usual);
}

}  // namespace
}  // namespace parison::forming
