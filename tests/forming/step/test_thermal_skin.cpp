// SPDX-License-Identifier: GPL-3.0-or-later
// Heat at extremes of a scene whose meshes the program chooses, against two half-spaces brought together.
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/run/folder_run.hpp"

namespace parison::forming {
namespace {

struct Contact {
  double h = 2000, time = 1, tool_conductivity = 46, jump = 600;
};

/// Heat of the disc and its plate over the exact one, less 1. Neither skin reaches an end in the times here.
double error(const Contact& contact) {
  auto text = replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }\n", "");
  text = text.substr(0, text.find("[[stage]]\nname = \"press\"")) + text.substr(text.find("[[probe]]"));
  text = replaced("duration = \"1 s\"", fmt::format("duration = \"{:g} s\"", contact.time), text);
  text = replaced("h = \"2000 W/m2/K\"", fmt::format("h = \"{:g} W/m2/K\"", contact.h), text);
  text = replaced("\"46 W/m/K\"", fmt::format("\"{:g} W/m/K\"", contact.tool_conductivity), text);
  text =
      replaced("temperature = \"1000 degC\"", fmt::format("temperature = \"{:.12g} degC\"", 400 + contact.jump), text);
  const auto outcome = run_in_folder(scene_of(text), tests::absent_folder());
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

}  // namespace
}  // namespace parison::forming
