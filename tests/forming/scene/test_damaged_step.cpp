// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "../scene_text.hpp"
#include "core/io/files.hpp"

namespace parison::forming {
namespace {

std::string bundled_step() {
  return core::read_text(std::string(PARISON_SOURCE_DIR) + "/cases/jar/blank.step");
}

/// The complaint about the small scene with a tool whose inner side is drawn in a STEP file of this text.
std::string complaint_about_step(const std::string& text) {
  const std::string scene = replaced(
      "[[interface]]\n",
      "[[tool]]\nname = \"blank\"\nmaterial = \"iron\"\ntemperature = \"400 degC\"\nfriction = \"slip\"\n"
      "position = \"200 mm\"\nboundary = [\n"
      "{ name = \"inner\", condition = \"contact\", path = { file = \"damaged.step\", from = \"(31, 14) mm\", "
      "via = \"(28, 68) mm\", to = \"(0, 98) mm\" } },\n"
      "{ name = \"axis\", condition = \"symmetry\", path = \"(0, 123) mm\" },\n"
      "{ name = \"outer\", condition = \"insulated\", path = \"(56, 123) (56, 14) (31, 14) mm\" } ]\n[[interface]]\n");
  core::write_text(write_scene(scene) + "/damaged.step", text);
  return complaint_about(scene);
}

TEST(DamagedStep, whatever_byte_is_changed_the_program_lives_and_says_what_is_wrong_in_one_sentence) {
  const std::string whole = bundled_step();
  ASSERT_EQ(complaint_about_step(whole), "");
  const std::string signs = "0123456789.-#(),$*ENA '";
  const std::size_t data = whole.find("DATA;");
  std::mt19937_64 draw(2);
  int refused = 0, deaths = 0;
  for (int i = 0; i < 60; ++i) {
    std::string damaged = whole;
    damaged[data + draw() % (whole.size() - data)] = signs[draw() % signs.size()];
    const std::string said = complaint_about_step(damaged);
    EXPECT_EQ(said.find('\n'), said.npos) << said;
    refused += !said.empty();
    deaths += said.find("cannot be read by the CAD kernel (it was ended by \"") != said.npos;
  }
  EXPECT_GT(refused, 5);
  EXPECT_GT(deaths, 0);  // the kernel is as it was; otherwise this test tests nothing
}

TEST(DamagedStep, a_file_that_is_cut_off_is_refused) {
  const std::string whole = bundled_step(), said = complaint_about_step(whole.substr(0, whole.size() / 2));
  EXPECT_NE(said.find("damaged.step\" ends without END-ISO-10303-21, so a part of it is missing"), said.npos) << said;
}

TEST(DamagedStep, coordinates_that_are_no_numbers_are_refused) {
  const std::string whole = bundled_step();
  for (const char* number : {"NAN", "1E400", "1.E200"}) {
    std::string damaged = whole;
    for (std::size_t at = 0; (at = damaged.find("CARTESIAN_POINT('',(", at)) != damaged.npos;) {
      at += 20;
      damaged.replace(at, damaged.find(',', at) - at, number);
    }
    EXPECT_NE(complaint_about_step(damaged), "") << number;
  }
}

}  // namespace
}  // namespace parison::forming
