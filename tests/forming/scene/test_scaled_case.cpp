// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <regex>
#include <vector>

#include "../scene_text.hpp"
#include "core/io/files.hpp"

namespace parison::forming {
namespace {

constexpr const char* of_its_size = R"([numerics]
surface_size = "0.9 mm"
skin_size = "0.7 mm"
)";

/// A case in millimetres with all lengths in another unit, speeds too.
std::string in_unit(const std::string& text, const std::string& unit) {
  return std::regex_replace(text, std::regex(R"(\bmm\b)"), unit);
}

/// The complaint about a case, without numbers and units of length, which depend on the size.
std::string verdict(const std::string& text) {
  return std::regex_replace(complaint_about(text), std::regex(R"(-?\d+(\.\d+)?(e[-+]?\d+)?|\b[umd]m\b)"), "#");
}

/// A case and what its complaint contains; nothing: it is accepted.
struct Judged {
  std::string text, sentence;
};

void expect_same_verdicts(const std::vector<Judged>& cases) {
  for (const auto& [text, sentence] : cases) {
    const std::string original = verdict(text);
    EXPECT_EQ(original.empty(), sentence.empty()) << original;
    EXPECT_NE(original.find(sentence), original.npos) << sentence << "\n" << original;
    for (const char* unit : {"um", "dm"}) EXPECT_EQ(verdict(in_unit(text, unit)), original) << unit;
  }
}

/// The small scene, its glass 22.4 mm across, with one part of text replaced.
std::string with(const std::string& from, const std::string& to) {
  return replaced(from, to) + of_its_size;
}

/// The same with an offset of the plunger that starts at this height, mm.
std::string moved(const std::string& start) {
  return with("motion.plunger = { force = \"-5 N\", speed_limit = \"10 mm/s\" }",
              "motion.plunger = { offset = [[\"0 s\", \"" + start + " mm\"], [\"1 s\", \"9 mm\"]] }");
}

TEST(Scaling, a_case_file_of_any_size_is_accepted_or_refused_alike) {
  const std::string surface = "(0, 0) (20, 0) (20, 10) (0, 10) mm", top = "(30, 0) (0, 0) mm", probe = "(0, 5) mm";
  const auto plate = [&](const std::string& z) { return with(top, "(30, " + z + ") (0, " + z + ") mm"); };
  expect_same_verdicts({
      {with("small", "small"), ""},
      {plate("0.0003"), ""},
      {plate("0.0004"), "overlaps the glass at the start"},
      {moved("10.0003"), ""},
      {moved("10.0004"), "the tool is at # # then"},
      {with(probe, "(0, 10.0003) mm"), ""},
      {with(probe, "(0, 10.0004) mm"), "outside \"glass\""},
      {with(surface, "(0, 0) (20, 0) (20, 10) (-0.000009, 10) mm"), ""},
      {with(surface, "(0, 0) (20, 0) (20, 10) (-0.00004, 10) mm"), "wrong side of the axis"},
      {with(surface, "(0, 0) (20, 0) (20, 10) (0, 10) (0, 9.99997) mm"), ""},
      {with(surface, "(0, 0) (20, 0) (20, 10) (0, 10) (0, 9.9999) mm"), "\"surface\" runs along the axis"},
      {with(surface, "(0, 0) (20, 0) (20, 10) (20.00002, 10) (0, 10) mm"), ""},
      {with(surface, "(0, 0) (20, 10) (20, 0) (0, 10) mm"), "crosses itself"},
  });
}

/// The small scene with the top of its plate from a drawing, in a file beside the case; the gap that is closed unless a
/// case says so is 0.01 mm whatever the size, and this one says none.
std::string with_drawing(const std::string& name, const std::string& from = "(30, 0)") {
  return with("path = \"(30, 0) (0, 0) mm\"", "path = { file = \"" + name +
                                                  "\", unit = \"mm\", gap = \"0 mm\", from = \"" + from +
                                                  " mm\", to = \"(0, 0) mm\" }");
}

/// A drawing of the plate's top in two lines, the second beginning at (x, y).
std::string file_of(const std::string& name, const char* x, const char* y) {
  std::string text = "0\nSECTION\n2\nENTITIES\n";
  for (const auto& [a, b, c, d] :
       std::vector<std::array<const char*, 4>>{{"30", "0", "15", "0"}, {x, y, "0", "0"}, {"0", "0", "0", "0"}})
    text += std::string("0\nLINE\n10\n") + a + "\n20\n" + b + "\n11\n" + c + "\n21\n" + d + "\n";
  core::write_text(write_scene(small_scene) + "/" + name, text + "0\nENDSEC\n0\nEOF\n");
  return name;
}

TEST(Scaling, a_drawing_of_any_size_is_accepted_or_refused_alike) {
  const std::string whole = file_of("whole.dxf", "15.00002", "0");
  expect_same_verdicts({
      {with_drawing(whole), ""},
      {with_drawing(whole, "(30, 0.008)"), ""},
      {with_drawing(whole, "(30, 0.02)"), "away from the drawing"},
      {with_drawing(file_of("gap.dxf", "15.0002", "0")), "leave a gap of"},
      {with_drawing(file_of("wide.dxf", "14.6", "0")), "leave a gap of"},
      {with_drawing(file_of("apart.dxf", "14.4", "0")), "several outlines were found"},
  });
}

}  // namespace
}  // namespace parison::forming
