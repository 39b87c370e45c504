// SPDX-License-Identifier: GPL-3.0-or-later
// Splines, ellipses and blocks of DXF drawings, as arcs with common tangents.
#include <gtest/gtest.h>

#include <cmath>

#include "curved_blank.hpp"

namespace parison::forming {
namespace {

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
  EXPECT_EQ(spline({{11, "30"}, {21, "14"}}), key +
                                                  "a SPLINE without control points and with 1 different points to go "
                                                  "through was found, allowed are at least 2");
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
