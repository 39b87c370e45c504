// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmsh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "../../scene_text.hpp"
#include "core/io/files.hpp"

namespace parison::forming {
namespace {

const std::string blank_points =
    "[\"(31, 14) (29.5, 20) (27.5, 84) mm\", \"arc centre (13.5, 84) mm radius 14 mm from 0 deg to 90 deg\", "
    "\"(0, 98) mm\"]";

/// The small scene and a blank whose inner side is `path`, the rest of its outline drawn by points.
std::string with_blank(const std::string& path) {
  return replaced("[[interface]]\n",
                  "[[tool]]\nname = \"blank\"\nmaterial = \"iron\"\ntemperature = \"400 degC\"\nfriction = \"slip\"\n"
                  "position = \"200 mm\"\nboundary = [\n"
                  "{ name = \"inner\", condition = \"contact\", path = " +
                      path +
                      " },\n"
                      "{ name = \"axis\", condition = \"symmetry\", path = \"(0, 123) mm\" },\n"
                      "{ name = \"outer\", condition = \"insulated\", path = \"(56, 123) (56, 14) (31, 14) mm\" } ]\n"
                      "[[interface]]\n");
}

core::Profile blank_of(const std::string& path) {
  return scene_of(with_blank(path)).tools.back().profile;
}

std::string file_beside_case(const std::string& name, const std::string& text) {
  core::write_text(write_scene(small_scene) + "/" + name, text);
  return name;
}

std::string bundled(const std::string& name) {
  return std::string(PARISON_SOURCE_DIR) + "/cases/jar/" + name;
}

std::string drawing(const std::string& file, const std::string& more, const std::string& to = "(0, 98) mm") {
  return "{ file = \"" + file + "\", " + more + "from = \"(31, 14) mm\", to = \"" + to + "\" }";
}

const std::string round_the_inside = "via = \"(28, 68) mm\", ",
                  dxf_blank = "unit = \"mm\", layer = \"BLANK\", " + round_the_inside;

/// A STEP file with what `draw` adds to an empty model, in mm.
std::string step_file(const std::string& name, const std::function<void()>& draw) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::model::add(name);
  draw();
  gmsh::model::occ::synchronize();
  const std::string file = file_beside_case(name, "");
  gmsh::write(write_scene(small_scene) + "/" + file);
  gmsh::clear();
  return file;
}

void expect_same_outline(const core::Profile& found, const core::Profile& wanted) {
  ASSERT_EQ(found.segments.size(), wanted.segments.size());
  for (std::size_t i = 0; i < wanted.segments.size(); ++i) {
    const core::Segment &a = found.segments[i], &b = wanted.segments[i];
    EXPECT_EQ(a.is_arc, b.is_arc) << i;
    EXPECT_EQ(a.boundary_id, b.boundary_id) << i;
    EXPECT_LT((a.centre - b.centre).norm(), 1e-9) << i;
    EXPECT_NEAR(a.radius, b.radius, 1e-9) << i;
    for (const double t : {0.0, 0.3, 0.5, 1.0})
      EXPECT_LT((core::point_at(a, t) - core::point_at(b, t)).norm(), 1e-9) << i;
  }
}

std::string pairs(const std::vector<std::pair<int, std::string>>& groups) {
  std::string text = "0\nSECTION\n2\nENTITIES\n";
  for (const auto& [code, value] : groups) text += std::to_string(code) + "\n" + value + "\n";
  return text + "0\nENDSEC\n0\nEOF\n";
}

TEST(Section, the_blank_of_the_jar_from_step_and_dxf_is_that_of_the_points) {
  const core::Profile wanted = blank_of(blank_points);
  expect_same_outline(blank_of(drawing(bundled("blank.step"), round_the_inside)), wanted);
  expect_same_outline(blank_of(drawing(bundled("blank.dxf"), dxf_blank)), wanted);
}

TEST(Section, polylines_with_bulges_give_the_arcs_of_the_blank_whichever_way_they_are_drawn) {
  char exact[40];
  std::snprintf(exact, sizeof exact, "%.17g", std::tan(M_PI / 8));
  const core::Profile wanted = blank_of(blank_points);
  const std::string light = pairs({{0, "LWPOLYLINE"},
                                   {90, "5"},
                                   {70, "0"},
                                   {10, "31"},
                                   {20, "14"},
                                   {10, "29.5"},
                                   {20, "20"},
                                   {10, "27.5"},
                                   {20, "84"},
                                   {42, exact},
                                   {10, "13.5"},
                                   {20, "98"},
                                   {10, "0"},
                                   {20, "98"}});
  expect_same_outline(blank_of(drawing(file_beside_case("light.dxf", light), "unit = \"mm\", ")), wanted);
  const std::string old =
      pairs({{0, "POLYLINE"}, {66, "1"},     {70, "0"},    {0, "VERTEX"}, {10, "0"},
             {20, "9.8"},     {0, "VERTEX"}, {10, "1.35"}, {20, "9.8"},   {42, std::string("-") + exact},
             {0, "VERTEX"},   {10, "2.75"},  {20, "8.4"},  {0, "VERTEX"}, {10, "2.95"},
             {20, "2"},       {0, "VERTEX"}, {10, "3.1"},  {20, "1.4"},   {0, "SEQEND"}});
  expect_same_outline(blank_of(drawing(file_beside_case("old.dxf", old), "unit = \"cm\", ")), wanted);
}

TEST(Section, a_section_may_be_drawn_in_any_coordinate_plane) {
  const core::Profile wanted = blank_of(blank_points);
  namespace occ = gmsh::model::occ;
  const auto plane = [&](const std::string& name, const std::function<void(double, double)>& point) {
    return step_file(name, [&] {
      for (const auto& [r, z] : {std::pair{31, 14}, {29, 20}, {27, 84}, {13, 84}, {13, 98}, {0, 98}})
        point(r == 29 ? 29.5 : r == 27 ? 27.5 : r == 13 ? 13.5 : r, z);
      occ::addLine(1, 2), occ::addLine(2, 3), occ::addCircleArc(3, 4, 5), occ::addLine(5, 6);
    });
  };
  expect_same_outline(blank_of(drawing(plane("xz.step", [](double r, double z) { occ::addPoint(r, 0, z); }), "")),
                      wanted);
  expect_same_outline(blank_of(drawing(plane("yz.stp", [](double r, double z) { occ::addPoint(0, r, z); }), "")),
                      wanted);
  const std::string oblique =
      drawing(plane("oblique.step", [](double r, double z) { occ::addPoint(0.8 * r, 0.6 * r, z); }), "");
  EXPECT_NE(complaint_about(with_blank(oblique)).find("oblique.step\" lie in no coordinate plane"), std::string::npos);
}

TEST(Section, a_part_of_a_drawing_may_begin_and_end_within_a_curve) {
  const core::Profile cut = blank_of("[" + drawing(bundled("blank.step"), "via = \"(30, 18) mm\", ", "(27.5, 84) mm") +
                                     ", { file = \"" + bundled("blank.dxf") +
                                     "\", unit = \"mm\", layer = \"BLANK\", from = \"(27.5, 84) mm\", via = \"(10, 98) "
                                     "mm\", to = \"(5, 98) mm\" }, \"(0, 98) mm\"]");
  const core::Profile whole = blank_of(blank_points);
  EXPECT_EQ(cut.segments.size(), whole.segments.size() + 1);
  EXPECT_NEAR(core::signed_area(cut), core::signed_area(whole), 1e-12);
}

TEST(Section, a_closed_outline_is_walked_either_way_or_all_round) {
  file_beside_case("plate.dxf", pairs({{0, "LWPOLYLINE"},
                                       {70, "1"},
                                       {10, "0"},
                                       {20, "0"},
                                       {10, "30"},
                                       {20, "0"},
                                       {10, "30"},
                                       {20, "-10"},
                                       {10, "0"},
                                       {20, "-10"}}));
  const auto plate_of = [](const std::string& via, const std::string& rest) {
    const std::string text = replaced("path = \"(30, 0) (0, 0) mm\"",
                                      "path = { file = \"plate.dxf\", unit = \"mm\", from = \"(30, 0) mm\", via = \"" +
                                          via + " mm\", to = \"(0, 0) mm\" }");
    return scene_of(replaced("\"rest\", path = \"(30, -10) mm\"", "\"rest\", path = \"" + rest + " mm\"", text))
        .tools[0]
        .profile;
  };
  EXPECT_NEAR(core::signed_area(plate_of("(15, 0)", "(30, -10)")), 300e-6, 1e-15);
  const std::string round =
      replaced("path = \"(30, 0) (0, 0) mm\"",
               "path = { file = \"plate.dxf\", unit = \"mm\", from = \"(0, -10) mm\", via = \"(30, -5) mm\", "
               "to = \"(0, 0) mm\" }");
  const std::string closed =
      replaced("  { name = \"rest\", path = \"(30, -10) mm\", condition = \"insulated\" },\n", "", round);
  const core::Profile whole = scene_of(closed).tools[0].profile;
  EXPECT_EQ(whole.segments.size(), 4u);
  EXPECT_NEAR(core::signed_area(whole), 300e-6, 1e-15);
}

struct Refused {
  std::string path, sentence;
};

TEST(Section, of_several_views_that_with_the_first_place_is_taken_with_a_note_unless_they_are_beyond_the_axis) {
  const core::Profile wanted = blank_of(blank_points);
  const std::string sheet = core::read_text(bundled("blank.dxf"));  // blank, and a centre line on the axis
  const auto with_circle = [&](const std::string& r) {
    const std::string circle = "  0\nCIRCLE\n  8\nVIEW\n 10\n" + r + "\n 20\n60\n 40\n5\n", end = "  0\nENDSEC\n";
    std::string text = sheet;
    const auto at = text.rfind(end);
    EXPECT_NE(at, text.npos);
    const std::string file = file_beside_case("views.dxf", text.insert(std::min(at, text.size()), circle));
    return scene_of(with_blank(drawing(file, "unit = \"mm\", " + round_the_inside)));
  };
  const Scene right = with_circle("80"), left = with_circle("-80");
  expect_same_outline(right.tools.back().profile, wanted);
  expect_same_outline(left.tools.back().profile, wanted);
  ASSERT_EQ(right.tools.back().drawing_notes.size(), 1u);
  const std::string note = right.tools.back().drawing_notes[0];
  EXPECT_NE(note.find("the outline through (31, 14) mm was taken, "), std::string::npos) << note;
  EXPECT_NE(note.find(" curves of others were left out"), std::string::npos) << note;
  EXPECT_EQ(left.tools.back().drawing_notes, std::vector<std::string>{});
}

TEST(Section, the_place_that_chooses_the_way_round_may_lie_next_to_it) {
  const std::string beside = "via = \"(28, 60) mm\", unit = \"mm\", layer = \"BLANK\", ",
                    between = "via = \"(42, 60) mm\", unit = \"mm\", layer = \"BLANK\", ";
  expect_same_outline(blank_of(drawing(bundled("blank.dxf"), beside)), blank_of(blank_points));
  const std::string said = complaint_about(with_blank(drawing(bundled("blank.dxf"), between)));
  EXPECT_NE(said.find("away from one way round the outline and 14 mm from the other, allowed is a place on or next to"),
            said.npos)
      << said;
}

TEST(Section, what_is_no_section_is_refused_with_a_sentence) {
  const auto dxf = [](const std::string& name, const std::vector<std::pair<int, std::string>>& groups) {
    return drawing(file_beside_case(name, pairs(groups)), "unit = \"mm\", ");
  };
  const std::vector<std::pair<int, std::string>> line{{0, "LINE"}, {10, "31"}, {20, "14"}, {11, "0"}, {21, "98"}};
  auto gap = line, two = line, spline = line, word = line;
  for (const auto& group :
       std::vector<std::pair<int, std::string>>{{0, "LINE"}, {10, "0.02"}, {20, "98"}, {11, "0"}, {21, "120"}})
    gap.push_back(group);
  for (const auto& group : std::vector<std::pair<int, std::string>>{{0, "CIRCLE"}, {10, "60"}, {20, "60"}, {40, "5"}})
    two.push_back(group);
  spline.push_back({0, "SPLINE"});
  word[2].second = "ninety";
  const std::string broken = file_beside_case("broken.step", "solid cube\n");
  namespace occ = gmsh::model::occ;
  const std::string solid = step_file("solid.step", [] { occ::addBox(0, 0, 0, 1, 1, 1); });
  const std::string empty = step_file("empty.step", [] { occ::addPoint(31, 14, 0); });
  std::vector<double> nearest, parameter;
  const std::string curved = step_file("curved.step", [&] {
    for (const double x : {0.0, 1.0, 2.0, 3.0}) occ::addPoint(x, x * x * x, 0);
    const int cubic = occ::addSpline({1, 2, 3, 4});
    occ::synchronize();
    gmsh::model::getClosestPoint(1, cubic, {31, 14, 0}, nearest, parameter);
  });
  const double away = std::hypot(nearest.at(0) - 31, nearest.at(1) - 14);
  for (const Refused& wrong : std::vector<Refused>{
           {drawing("absent.step", ""), "absent.step\", allowed is a drawing with its path relative to the case file"},
           {drawing("absent.dxf", "unit = \"mm\", "),
            "absent.dxf\", allowed is a drawing with its path relative to the case file"},
           {drawing("blank.dwg", ""), "\"blank.dwg\" was found, allowed are drawings named .step, .stp or .dxf"},
           {drawing(broken, ""), "is no STEP file (its first line does not say ISO-10303-21)"},
           {drawing(solid, ""),
            "a solid without any surface of revolution was found, allowed are solids around an axis"},
           {drawing(empty, ""), "no curves were found in"},
           {drawing(curved, ""),
            fmt::format("(31, 14) mm is {:.3g} mm away from the drawing, allowed are points on it", away)},
           {drawing(bundled("blank.step"), ""),
            "a closed outline can be followed to this point in two directions, allowed is \"to\" together with a "
            "\"via\""},
           {drawing(bundled("blank.step"), round_the_inside + "unit = \"mm\", "),
            "a unit was found, allowed only for DXF files"},
           {drawing(bundled("blank.dxf"), "unit = \"kg\", "), "is a mass"},
           {drawing(bundled("blank.dxf"), "unit = \"mm\", layer = \"MOULD\", "),
            "no lines or arcs were found on layer \"MOULD\""},
           {drawing(bundled("blank.dxf"), dxf_blank, "(0, 90) mm"),
            "(0, 90) mm is 8 mm away from the drawing, allowed are points on it"},
           {dxf("gap.dxf", gap), "leave a gap of 0.02 mm at (0, 98) mm, allowed are ends that meet to 0.01 mm"},
           {drawing(file_beside_case("two.dxf", pairs(two)), "unit = \"mm\", ", "(65, 60) mm"),
            "several outlines were found in the drawing, one with 1 curves and 2 more curves; the one next to (31, 14) "
            "mm "
            "is open and ends at"},
           {dxf("spline.dxf", spline), "spline.dxf:16: tool.boundary.path.file: a SPLINE without control points"},
           {dxf("word.dxf", word),
            "word.dxf:10: tool.boundary.path.file: \"ninety\" was found, allowed is a number"}}) {
    const std::string said = complaint_about(with_blank(wrong.path));
    EXPECT_NE(said.find(wrong.sentence), said.npos) << wrong.path << "\n" << said;
    EXPECT_EQ(said.find('\n'), said.npos) << said;
  }
}

}  // namespace
}  // namespace parison::forming
