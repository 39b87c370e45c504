// SPDX-License-Identifier: GPL-3.0-or-later
// Splines and ellipses of drawings and smooth curves through points, as arcs with common tangents.
#include <gmsh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/scene/read/curves/curve_arcs.hpp"

namespace parison::forming {
namespace {

using core::Point;
using core::Segment;

constexpr double tolerance = 1e-6;  // m

/// The largest angle between the tangents where two segments meet, rad.
double largest_kink(const std::vector<Segment>& segments) {
  double kink = 0;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    EXPECT_LT((segments[i].start - segments[i - 1].end).norm(), 1e-12);
    const Point a = core::tangent_at(segments[i - 1], 1), b = core::tangent_at(segments[i], 0);
    kink = std::max(kink, std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b))));
  }
  return kink;
}

/// The largest distance of a curve from the segments, m.
double off(const std::vector<Segment>& segments, const std::function<Point(double)>& curve) {
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    double distance = 1;
    for (const Segment& segment : segments) distance = core::distance(segment, curve(i / 1000.0), distance);
    worst = std::max(worst, distance);
  }
  return worst;
}

TEST(CurvedOutlines, arcs_follow_an_ellipse_within_their_tolerance_without_kinks) {
  const PlaneCurve ellipse = [](double t) -> CurvePoint {
    return {{0.04 * std::cos(t), 0.015 * std::sin(t)}, {-0.04 * std::sin(t), 0.015 * std::cos(t)}};
  };
  std::size_t last = 0;
  for (const double allowed : {1e-5, 1e-6, 1e-7}) {
    const auto arcs = arcs_of(ellipse, 0, M_PI, allowed);
    EXPECT_LT(off(arcs, [&](double s) { return ellipse(M_PI * s).x; }), 1.2 * allowed);
    EXPECT_LT(largest_kink(arcs), 1e-3);
    EXPECT_GT(arcs.size(), last);
    last = arcs.size();
  }
  EXPECT_LT(last, 200u);
}

TEST(CurvedOutlines, a_circle_and_a_line_are_found_again) {
  const auto circle = arcs_of(
      [](double t) -> CurvePoint {
        return {{0.01 + 0.03 * std::cos(t), 0.03 * std::sin(t)}, {-0.03 * std::sin(t), 0.03 * std::cos(t)}};
      },
      0, 1.5, tolerance);
  EXPECT_EQ(circle.size(), 2u);
  for (const Segment& arc : circle) {
    EXPECT_NEAR(arc.radius, 0.03, 1e-12);
    EXPECT_LT((arc.centre - Point(0.01, 0)).norm(), 1e-12);
  }
  for (const Segment& line : arcs_of([](double t) -> CurvePoint { return {{t, 2 * t}, {1, 2}}; }, 0, 1, tolerance))
    EXPECT_FALSE(line.is_arc);
}

TEST(CurvedOutlines, a_curve_through_points_of_a_circle_is_that_circle_nearly) {
  double last = 0;
  for (const int count : {10, 20}) {
    std::vector<Point> points;
    for (int i = 0; i <= count; ++i)
      points.emplace_back(0.03 * std::cos(M_PI / 2 * i / count), 0.03 * std::sin(M_PI / 2 * i / count));
    const auto arcs = smooth_through(points, 1e-8);
    EXPECT_LT(largest_kink(arcs), 1e-3);
    const double worst =
        off(arcs, [](double s) { return Point(0.03 * std::cos(M_PI / 2 * s), 0.03 * std::sin(M_PI / 2 * s)); });
    std::printf("through %d points of a quarter of a circle of 30 mm: off by %.3g um\n", count + 1, 1e6 * worst);
    EXPECT_LT(worst, 1e-5);
    if (last > 0) EXPECT_LT(worst, last / 6);
    last = worst;
  }
}

/// The small scene and a blank whose inner side from (30, 14) to (0, 98) mm is `keys`.
std::string with_blank(const std::string& keys) {
  return replaced("[[interface]]\n",
                  "[[tool]]\nname = \"blank\"\nmaterial = \"iron\"\ntemperature = \"400 degC\"\nfriction = \"slip\"\n"
                  "position = \"200 mm\"\nboundary = [\n{ name = \"inner\", condition = \"contact\", " +
                      keys +
                      " },\n{ name = \"axis\", condition = \"symmetry\", path = \"(0, 123) mm\" },\n"
                      "{ name = \"outer\", condition = \"insulated\", path = \"(56, 123) (56, 14) (30, 14) mm\" } ]\n"
                      "[[interface]]\n");
}

core::Profile blank_of(const std::string& keys, const std::string& file, const std::string& text) {
  const std::string folder = write_scene(with_blank(keys));
  core::write_text(folder + "/" + file, text);
  return read_scene(folder, "draft").tools.back().profile;
}

/// The quarter of an ellipse from (30, 14) to (0, 98) mm, about (0, 14) mm.
Point quarter(double s) {
  return {0.03 * std::cos(M_PI / 2 * s), 0.014 + 0.084 * std::sin(M_PI / 2 * s)};
}

std::vector<Segment> inner_of(const core::Profile& blank) {
  std::vector<Segment> inner;
  for (const Segment& segment : core::signed_area(blank) > 0 ? blank.segments : core::reversed(blank).segments)
    if (segment.boundary_id == 0) inner.push_back(segment);
  return inner;
}

TEST(CurvedOutlines, a_csv_outline_may_be_smooth) {
  std::string table = "r_mm,z_mm\n";
  for (int i = 0; i <= 24; ++i) table += fmt::format("{},{}\n", 1e3 * quarter(i / 24.0)[0], 1e3 * quarter(i / 24.0)[1]);
  const auto plain = inner_of(blank_of("csv = \"inner.csv\"", "inner.csv", table));
  const auto smooth = inner_of(blank_of("csv = \"inner.csv\", smooth = true", "inner.csv", table));
  EXPECT_EQ(plain.size(), 24u);
  EXPECT_GT(off(plain, quarter), 3e-5);
  EXPECT_LT(off(smooth, quarter), 3e-6);
  EXPECT_LT(largest_kink(smooth), 1e-3);
}

/// Pairs of code and value in the ENTITIES section of a DXF file.
std::string dxf(const std::vector<std::pair<int, std::string>>& groups) {
  std::string text = "0\nSECTION\n2\nENTITIES\n";
  for (const auto& [code, value] : groups) text += fmt::format("{}\n{}\n", code, value);
  return text + "0\nENDSEC\n0\nEOF\n";
}

const std::string drawn = "path = { file = \"inner.dxf\", unit = \"mm\", from = \"(30, 14) mm\", to = \"(0, 98) mm\" }";

TEST(CurvedOutlines, a_dxf_ellipse_is_read_within_a_micrometre) {
  const auto inner = inner_of(blank_of(drawn, "inner.dxf",
                                       dxf({{0, "ELLIPSE"},
                                            {10, "0"},
                                            {20, "14"},
                                            {11, "0"},
                                            {21, "84"},
                                            {40, fmt::format("{}", 30.0 / 84)},
                                            {41, fmt::format("{}", -M_PI / 2)},
                                            {42, "0"}})));
  EXPECT_LT(off(inner, quarter), 2e-6);
  EXPECT_LT(largest_kink(inner), 1e-3);
}

TEST(CurvedOutlines, a_rational_dxf_spline_is_the_ellipse_that_it_says) {
  const std::vector<std::pair<int, std::string>> groups{{0, "SPLINE"},
                                                        {70, "4"},
                                                        {71, "2"},
                                                        {40, "0"},
                                                        {40, "0"},
                                                        {40, "0"},
                                                        {40, "1"},
                                                        {40, "1"},
                                                        {40, "1"},
                                                        {41, "1"},
                                                        {41, fmt::format("{}", std::sqrt(0.5))},
                                                        {41, "1"},
                                                        {10, "30"},
                                                        {20, "14"},
                                                        {10, "30"},
                                                        {20, "98"},
                                                        {10, "0"},
                                                        {20, "98"}};
  EXPECT_LT(off(inner_of(blank_of(drawn, "inner.dxf", dxf(groups))), quarter), 2e-6);
}

TEST(CurvedOutlines, a_cubic_dxf_spline_with_an_inner_knot_and_one_through_points_are_read) {
  std::vector<std::pair<int, std::string>> groups{{0, "SPLINE"}, {71, "3"}};
  for (const char* knot : {"0", "0", "0", "0", "1", "2", "2", "2", "2"}) groups.emplace_back(40, knot);
  for (const auto& [r, z] : {std::pair{"30", "14"}, {"30", "40"}, {"28", "70"}, {"20", "98"}, {"0", "98"}}) {
    groups.emplace_back(10, r);
    groups.emplace_back(20, z);
  }
  const auto inner = inner_of(blank_of(drawn, "inner.dxf", dxf(groups)));
  // At the knot: (d2 + (d1 + d2 and d2 + d3 halved))/2 by de Boor's triangle, (1/4) d1 + (1/2) d2 + (1/4) d3.
  const Point middle(1e-3 * (0.25 * 30 + 0.5 * 28 + 0.25 * 20), 1e-3 * (0.25 * 40 + 0.5 * 70 + 0.25 * 98));
  EXPECT_LT(off(inner, [&](double) { return middle; }), 2e-6);
  EXPECT_LT(largest_kink(inner), 1e-3);
  std::vector<std::pair<int, std::string>> through{{0, "SPLINE"}, {71, "3"}};
  for (int i = 0; i <= 24; ++i) {
    through.emplace_back(11, fmt::format("{}", 1e3 * quarter(i / 24.0)[0]));
    through.emplace_back(21, fmt::format("{}", 1e3 * quarter(i / 24.0)[1]));
  }
  EXPECT_LT(off(inner_of(blank_of(drawn, "inner.dxf", dxf(through))), quarter), 3e-6);
}

/// The blocks of a file as pairs, and what is drawn.
std::string dxf_with_blocks(const std::vector<std::pair<int, std::string>>& blocks,
                            const std::vector<std::pair<int, std::string>>& drawn_ones) {
  std::string text = dxf(blocks);
  text.replace(text.find("ENTITIES"), 8, "BLOCKS");
  text.resize(text.rfind("0\nEOF"));
  return text + dxf(drawn_ones);
}

/// Half the quarter of the ellipse, reflected at the axis and about (0, 0), in a block with its base at (5, 0), and
/// another block that has it turned by 90 deg.
const std::vector<std::pair<int, std::string>> nested_blocks{{0, "BLOCK"},
                                                             {2, "HALF"},
                                                             {10, "5"},
                                                             {20, "0"},
                                                             {0, "ELLIPSE"},
                                                             {8, "0"},
                                                             {10, "5"},
                                                             {20, "7"},
                                                             {11, "0"},
                                                             {21, "42"},
                                                             {40, "0.35714285714285715"},
                                                             {41, "0"},
                                                             {42, "1.5707963267948966"},
                                                             {0, "ENDBLK"},
                                                             {0, "BLOCK"},
                                                             {2, "OUTER"},
                                                             {10, "0"},
                                                             {20, "0"},
                                                             {0, "INSERT"},
                                                             {8, "0"},
                                                             {2, "HALF"},
                                                             {10, "0"},
                                                             {20, "0"},
                                                             {50, "90"},
                                                             {0, "ENDBLK"}};

TEST(CurvedOutlines, blocks_within_blocks_come_turned_scaled_and_reflected_to_their_places) {
  const auto outer = [](const std::string& layer, const std::string& turn) {
    return std::vector<std::pair<int, std::string>>{{0, "INSERT"}, {8, layer}, {2, "OUTER"}, {10, "0"},
                                                    {20, "0"},     {41, "-2"}, {42, "2"},    {50, turn}};
  };
  EXPECT_LT(off(inner_of(blank_of(drawn, "inner.dxf", dxf_with_blocks(nested_blocks, outer("BLANK", "90")))), quarter),
            2e-6);
  auto both = outer("OTHER", "0");
  for (const auto& group : outer("BLANK", "90")) both.push_back(group);
  const std::string on_layer =
      "path = { file = \"inner.dxf\", unit = \"mm\", layer = \"BLANK\", from = \"(30, 14) mm\", to = \"(0, 98) mm\" }";
  EXPECT_LT(off(inner_of(blank_of(on_layer, "inner.dxf", dxf_with_blocks(nested_blocks, both))), quarter), 2e-6);
}

TEST(CurvedOutlines, a_reflected_block_turns_the_bulges_of_its_polylines) {
  const std::vector<std::pair<int, std::string>> block{{0, "BLOCK"},      {2, "B"},  {10, "0"},   {20, "0"},
                                                       {0, "LWPOLYLINE"}, {90, "2"}, {10, "-30"}, {20, "14"},
                                                       {42, "-0.2"},      {10, "0"}, {20, "98"},  {0, "ENDBLK"}};
  const auto plain = inner_of(
      blank_of(drawn, "inner.dxf",
               dxf({{0, "LWPOLYLINE"}, {90, "2"}, {10, "30"}, {20, "14"}, {42, "0.2"}, {10, "0"}, {20, "98"}})));
  const auto placed = inner_of(blank_of(
      drawn, "inner.dxf", dxf_with_blocks(block, {{0, "INSERT"}, {2, "B"}, {10, "0"}, {20, "0"}, {41, "-1"}})));
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_LT((placed[0].centre - plain[0].centre).norm(), 1e-12);
  EXPECT_NEAR(placed[0].to - placed[0].from, plain[0].to - plain[0].from, 1e-12);
}

TEST(CurvedOutlines, step_splines_and_ellipses_are_read_within_a_micrometre) {
  namespace occ = gmsh::model::occ;
  const std::string keys = "path = { file = \"inner.step\", from = \"(30, 14) mm\", to = \"(0, 98) mm\" }";
  const std::string folder = write_scene(with_blank(keys));
  for (const bool ellipse : {true, false}) {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::model::add("inner");
    if (ellipse) {
      const int tag = occ::addEllipse(0, 14, 0, 84, 30, -1, -M_PI / 2, 0);
      occ::rotate({{1, tag}}, 0, 14, 0, 0, 0, 1, M_PI / 2);
    } else {
      std::vector<int> points;
      for (int i = 0; i <= 24; ++i)
        points.push_back(occ::addPoint(1e3 * quarter(i / 24.0)[0], 1e3 * quarter(i / 24.0)[1], 0));
      occ::addSpline(points);
    }
    occ::synchronize();
    gmsh::write(folder + "/inner.step");
    gmsh::finalize();
    const auto inner = inner_of(read_scene(folder, "draft").tools.back().profile);
    EXPECT_LT(off(inner, quarter), ellipse ? 2e-6 : 2e-5);
    EXPECT_LT(largest_kink(inner), 1e-3);
  }
}

TEST(CurvedOutlines, a_mirror_image_goes_on_where_the_path_ends_on_its_line) {
  const std::string half =
      "\"(60, -20) (40, -20) mm\", \"arc centre (40, -10) mm radius 10 mm from -90 deg to -180 deg\"";
  const auto ring = [](const std::string& path) {
    return scene_of(
               replaced(
                   "[[interface]]\n",
                   "[[tool]]\nname = \"ring\"\nmaterial = \"iron\"\ntemperature = \"400 degC\"\nfriction = "
                   "\"slip\"\nboundary = [\n"
                   "{ name = \"inner\", condition = \"contact\", path = [" +
                       path +
                       "] },\n"
                       "{ name = \"outer\", condition = \"insulated\", path = \"(60, -20) mm\" } ]\n[[interface]]\n"))
        .tools.back()
        .profile;
  };
  const core::Profile mirror = ring(half + ", { mirror = [" + half + "], about = \"(0, -10) (5, -10) mm\" }");
  const core::Profile drawn_whole =
      ring(half + ", \"arc centre (40, -10) mm radius 10 mm from 180 deg to 90 deg\", \"(60, 0) mm\"");
  EXPECT_NEAR(core::signed_area(mirror), 20e-3 * 20e-3 + M_PI / 2 * 1e-4, 1e-12);
  EXPECT_NEAR(core::signed_area(mirror), core::signed_area(drawn_whole), 1e-15);
  ASSERT_EQ(mirror.segments.size(), drawn_whole.segments.size());
  for (std::size_t i = 0; i < mirror.segments.size(); ++i)
    for (const double t : {0.0, 0.3, 1.0})
      EXPECT_LT((core::point_at(mirror.segments[i], t) - core::point_at(drawn_whole.segments[i], t)).norm(), 1e-12);
}

TEST(CurvedOutlines, mistakes_have_their_sentences) {
  const auto said = [](const std::string& keys, const std::string& file, const std::string& text) -> std::string {
    try {
      blank_of(keys, file, text);
    } catch (const core::CaseError& error) {
      const std::string message = error.what();
      return message.substr(message.find("tool."));
    }
    return "";
  };
  EXPECT_EQ(said("path = \"(30, 14) (0, 98) mm\", smooth = true", "no.csv", ""),
            "tool.boundary.smooth: found without csv, allowed is to smooth the points of a CSV file");
  EXPECT_EQ(said("csv = \"two.csv\", smooth = true", "two.csv", "r_mm,z_mm\n30,14\n0,98\n"),
            "tool.boundary.smooth: 2 different points were found, allowed are at least 3");
  const auto spline = [&](const std::vector<std::pair<int, std::string>>& groups) {
    auto all = groups;
    all.insert(all.begin(), {0, "SPLINE"});
    return said(drawn, "inner.dxf", dxf(all));
  };
  const std::string key = "tool.boundary.path.file: ";
  EXPECT_EQ(
      spline({{71, "3"}, {40, "0"}, {10, "30"}, {20, "14"}}),
      key +
          "a SPLINE of degree 3 with 1 control points and 1 knots was found, allowed are as many knots as control "
          "points and degree and 1 together");
  EXPECT_EQ(spline({{71, "30"}, {10, "30"}, {20, "14"}}), key + "a SPLINE of degree 30 was found, allowed are 1 to 10");
  EXPECT_EQ(
      spline({{71, "1"}, {40, "0"}, {40, "2"}, {40, "1"}, {40, "1"}, {10, "30"}, {20, "14"}, {10, "0"}, {20, "98"}}),
      key + "a SPLINE whose knots fall was found, allowed are rising knots");
  EXPECT_EQ(spline({{71, "1"}, {10, "30"}, {20, "14"}, {10, "0"}}),
            key + "a SPLINE with 2 values of group 10 and 1 of group 20 was found, allowed are pairs");
  EXPECT_EQ(
      spline({{11, "30"}, {21, "14"}}),
      key +
          "a SPLINE without control points and without three points to go through was found, allowed is one with them");
  EXPECT_EQ(
      said("path = [\"(30, 14) mm\", { mirror = \"(30, 14) (30, 50) mm\", about = \"(0, 50) mm\" }]", "no.csv", ""),
      "tool.boundary.path.about: \"(0, 50) mm\" was found, allowed are two points of the line such as \"(0, 40) (10, "
      "40) "
      "mm\"");
  const auto inserted = [&](std::vector<std::pair<int, std::string>> groups) {
    groups.insert(groups.begin(), {{0, "INSERT"}, {10, "0"}, {20, "0"}});
    auto blocks = nested_blocks;
    for (const auto& group :
         std::vector<std::pair<int, std::string>>{{0, "BLOCK"}, {2, "LOOP"}, {0, "INSERT"}, {2, "LOOP"}, {0, "ENDBLK"}})
      blocks.push_back(group);
    return said(drawn, "inner.dxf", dxf_with_blocks(blocks, groups));
  };
  EXPECT_EQ(inserted({{2, "HALV"}}),
            key + "an INSERT of the block \"HALV\" was found, allowed are blocks of the same file");
  EXPECT_EQ(
      inserted({{2, "HALF"}, {41, "2"}}),
      key +
          "an INSERT with the scales 2 and 1 was found, allowed is one scale in both directions (explode the block in "
          "the CAD program)");
  EXPECT_EQ(inserted({{2, "HALF"}, {70, "3"}}),
            key + "an INSERT of rows or columns of a block was found, allowed is a single one");
  EXPECT_EQ(
      inserted({{2, "LOOP"}}),
      key + "blocks within blocks over more than 8 levels or more than 10000 of them were found, allowed are fewer");
  EXPECT_EQ(said(drawn, "inner.dxf", dxf({{0, "ELLIPSE"}, {10, "0"}, {20, "14"}, {11, "0"}, {21, "84"}, {40, "3"}})),
            key + "an ELLIPSE without centre, major axis and a ratio from 0 to 1 was found, allowed is one with them");
}

}  // namespace
}  // namespace parison::forming
