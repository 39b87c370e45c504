// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <random>
#include <vector>

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

/// Changes a byte, a number or the entity that is referred to, cuts a piece out or doubles one.
std::string damaged(std::string text, std::mt19937_64& draw) {
  const std::string signs = "0123456789.-#(),$*ENA '";
  const std::vector<std::string> numbers = {"0.", "1.E300", "-1.E-300", "1.E15", "#1", "#0", "#999999999", "()", "$"};
  const std::size_t data = text.find("DATA;"), at = data + draw() % (text.size() - data);
  const std::size_t length = std::min<std::size_t>(1 + draw() % 60, text.size() - at);
  switch (draw() % 4) {
    case 0:
    case 1:
      text[at] = signs[draw() % signs.size()];
      break;
    case 2: {
      const std::size_t begin = text.find_first_of("0123456789#", at), end = text.find_first_of(",)=", begin);
      if (end != text.npos) text.replace(begin, end - begin, numbers[draw() % numbers.size()]);
      break;
    }
    default:
      draw() % 2 ? text.erase(at, length) : text.insert(at, text.substr(at, length));
  }
  return text;
}

/// CPU time of this process and of the children that ended, s.
double cpu_seconds() {
  double sum = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    ::getrusage(who, &used);
    for (const timeval& time : {used.ru_utime, used.ru_stime})
      sum += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return sum;
}

/// PARISON_DAMAGED in the environment, or enough for a quick test.
int damaged_files() {
  const char* wanted = std::getenv("PARISON_DAMAGED");
  return wanted ? std::atoi(wanted) : 60;
}

TEST(DamagedStep, whatever_is_changed_the_program_lives_and_says_what_is_wrong_in_one_sentence) {
  const std::string whole = bundled_step();
  ASSERT_EQ(complaint_about_step(whole), "");
  std::mt19937_64 draw(2);
  int refused = 0, deaths = 0;
  double longest = 0;
  for (int i = 0; i < damaged_files(); ++i) {
    const double start = cpu_seconds();
    const std::string said = complaint_about_step(damaged(whole, draw));
    longest = std::max(longest, cpu_seconds() - start);
    EXPECT_EQ(said.find('\n'), said.npos) << said;
    refused += !said.empty();
    deaths += said.find("cannot be read by the CAD kernel (it was ended by \"") != said.npos;
  }
  std::printf("%d damaged files: %d refused, the CAD kernel died of %d; longest %.1f s\n", damaged_files(), refused,
              deaths, longest);
  EXPECT_GT(refused, 5);
  EXPECT_GT(deaths, 0);  // the kernel is as it was; otherwise this test tests nothing
  EXPECT_LT(longest, 10);
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
