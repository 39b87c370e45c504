// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings as CAD programs write them: twenty random outlines in each dialect are taken with their area, to 1e-5 of it.
#include <gtest/gtest.h>

#include "dxf_writer.hpp"

namespace parison::tests {
namespace {

const std::string mm = "unit = \"mm\", ";

TEST(DrawingDialects, polylines_with_bulges_of_r12) {
  expect_areas([](const Outline& outline, std::mt19937&) {
    DxfWriter writer;
    writer.old_polyline(outline);
    return take("a.dxf", dxf_of(writer.text), mm + from(outline[0].x));
  });
}

TEST(DrawingDialects, light_polylines) {
  expect_areas([](const Outline& outline, std::mt19937&) {
    DxfWriter writer;
    writer.light_polyline(outline);
    return take("a.dxf", dxf_of(writer.text, "9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n"), from(outline[0].x));
  });
}

TEST(DrawingDialects, lines_and_arcs_in_any_order_and_direction) {
  expect_areas([](const Outline& outline, std::mt19937& random) {
    DxfWriter writer;
    writer.soup(outline, random);
    return take("a.dxf", dxf_of(writer.text), mm + from(outline[0].x));
  });
}

TEST(DrawingDialects, four_decimals_of_lengths_and_angles) {
  expect_areas([](const Outline& outline, std::mt19937& random) {
    DxfWriter writer;
    writer.decimals = 4;
    writer.soup(outline, random);
    return take("a.dxf", dxf_of(writer.text), mm + from(outline[0].x));
  });
}

TEST(DrawingDialects, inches_of_the_drawing_and_of_the_case_and_mils) {
  for (const auto& [unit, variables, keys] : {std::tuple{25.4, "9\n$INSUNITS\n70\n1\n", ""},
                                              {25.4, "", "unit = \"in\", "},
                                              {25.4, "9\n$INSUNITS\n70\n1\n", "unit = \"in\", "},
                                              {0.0254, "9\n$INSUNITS\n70\n9\n", ""},
                                              {0.0254, "9\n$INSUNITS\n70\n0\n", "unit = \"mil\", "}})
    expect_areas([unit = unit, variables = variables, keys = keys](const Outline& outline, std::mt19937& random) {
      DxfWriter writer;
      writer.unit = unit;
      writer.soup(outline, random);
      return take("a.dxf", dxf_of(writer.text, variables), keys + from(outline[0].x));
    });
}

TEST(DrawingDialects, planes_that_are_seen_from_behind) {
  for (const int kind : {0, 1, 2})
    expect_areas([kind](const Outline& outline, std::mt19937& random) {
      DxfWriter writer;
      writer.from_behind = true;
      if (kind == 0) writer.soup(outline, random);
      if (kind == 1) writer.light_polyline(outline);
      if (kind == 2) writer.old_polyline(outline);
      return take("a.dxf", dxf_of(writer.text), mm + from(outline[0].x));
    });
}

/// Where a block that is inserted has to be drawn so that it comes to its place.
Point before_insertion(const Point& x, double scale, double degrees, bool mirrored, const Point& at) {
  const double turn = degrees * M_PI / 180;
  const Point from_place = (x - at) / scale;
  const Point own(std::cos(turn) * from_place[0] + std::sin(turn) * from_place[1],
                  -std::sin(turn) * from_place[0] + std::cos(turn) * from_place[1]);
  return Point(mirrored ? -own[0] : own[0], own[1]) + Point(7, -3);
}

TEST(DrawingDialects, blocks_that_are_scaled_turned_and_mirrored) {
  int count = 0;
  expect_areas([&](const Outline& outline, std::mt19937& random) {
    const bool mirrored = count % 2, from_behind = ++count % 4 > 1;
    const double scale = 0.5 + count, degrees = 17.0 * count;
    const Point at(3, 11);
    Outline own;
    for (const Corner& corner : outline) {
      const Point seen(from_behind ? -corner.x[0] : corner.x[0], corner.x[1]);
      own.push_back({before_insertion(seen, scale, degrees, mirrored, at),
                     mirrored != from_behind ? -corner.bulge : corner.bulge});
    }
    DxfWriter block, entities;
    block.text = "0\nBLOCK\n2\nTeil\n10\n7\n20\n-3\n";
    random() % 2 ? block.light_polyline(own) : block.soup(own, random);
    block.group(0, "ENDBLK");
    entities.from_behind = from_behind;
    entities.begin("INSERT");
    entities.group(2, "TEIL");
    entities.group(10, at[0]);
    entities.group(20, at[1]);
    entities.group(41, mirrored ? -scale : scale);
    entities.group(42, scale);
    entities.group(50, degrees);
    return take("a.dxf", dxf_of(entities.text, "", "", block.text), mm + from(outline[0].x));
  });
}

TEST(DrawingDialects, layer_names_of_old_code_pages_without_regard_to_capitals) {
  for (const auto& [variables, drawn, asked] :
       {std::tuple{"9\n$ACADVER\n1\nAC1009\n9\n$DWGCODEPAGE\n3\nANSI_1252\n",
                   "Bodenst\xFC"
                   "ck",
                   "BODENSTÜCK"},
        {"9\n$ACADVER\n1\nAC1015\n9\n$DWGCODEPAGE\n3\nANSI_1251\n", "\xD4\xEE\xF0\xEC\xE0", "форма"},
        {"9\n$ACADVER\n1\nAC1027\n", "Läufer", "läufer"},
        {"", "\\U+00C4u\\U+00DFen", "äußen"},
        {"9\n$DWGCODEPAGE\n3\nDOS850\n", "M\x81ndung", "Mündung"},
        {"", "Blank", "BLANK"}})
    expect_areas([variables = variables, drawn = drawn, asked = asked](const Outline& outline, std::mt19937& random) {
      DxfWriter writer;
      writer.layer = drawn;
      writer.soup(outline, random);
      writer.layer = "Masse";
      writer.line({0, 0}, {1, 1});
      return take("a.dxf", dxf_of(writer.text, variables),
                  mm + fmt::format("layer = \"{}\", ", asked) + from(outline[0].x));
    });
}

TEST(DrawingDialects, what_is_frozen_switched_off_invisible_or_on_paper_is_left_out) {
  expect_areas([](const Outline& outline, std::mt19937& random) {
    DxfWriter writer;
    const auto noise = [&](const std::string& layer) {
      writer.layer = layer;
      writer.line({0, 0}, {100, 1});
      writer.layer = "0";
    };
    noise("FROZEN"), noise("Off");
    writer.soup(outline, random);
    noise("0");
    writer.group(60, "1");
    noise("0");
    writer.group(67, "1");
    const std::string layers =
        "0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nfrozen\n70\n65\n62\n7\n0\nLAYER\n2\nOFF\n70\n0\n62\n-"
        "3\n0\nLAYER\n2\n0\n70\n64\n"
        "62\n7\n0\nENDTAB\n";
    return take("a.dxf", dxf_of(writer.text, "", layers), mm + from(outline[0].x));
  });
}

TEST(DrawingDialects, views_that_are_shifted_turned_or_lie_on_their_side) {
  for (const auto& [axis, turn] : {std::pair{"x", 90.0}, {"-y", 180.0}, {"-x", -90.0}, {"", 33.0}})
    expect_areas([axis = std::string(axis), turn = turn](const Outline& outline, std::mt19937& random) {
      const double angle = -turn * M_PI / 180;
      Outline drawn = outline;
      for (Corner& corner : drawn)
        corner.x = Point(200, -70) + Point(std::cos(angle) * corner.x[0] - std::sin(angle) * corner.x[1],
                                           std::sin(angle) * corner.x[0] + std::cos(angle) * corner.x[1]);
      DxfWriter writer;
      writer.soup(drawn, random);
      const std::string key =
          axis.empty() ? fmt::format("turn = \"{} deg\"", turn) : fmt::format("axis = \"{}\"", axis);
      return take("a.dxf", dxf_of(writer.text), mm + "origin = \"(200, -70) mm\", " + key + ", " + from(outline[0].x));
    });
}

TEST(DrawingDialects, a_view_on_the_other_side_of_its_axis_comes_to_the_radii) {
  for (const auto& [axis, x, y] : {std::tuple{"x", 1, 0}, {"y", 0, 1}})
    expect_areas([axis = axis, x = x, y = y](const Outline& outline, std::mt19937& random) {
      Outline drawn = outline;  // radii above the axis along x, on the left of that along y
      for (Corner& corner : drawn) {
        const Point own = corner.x;
        corner.x = x ? Point(own[1], own[0]) : Point(-y * own[0], own[1]);
        corner.bulge = -corner.bulge;
      }
      DxfWriter writer;
      writer.soup(drawn, random);
      return take("a.dxf", dxf_of(writer.text), mm + fmt::format("axis = \"{}\", ", axis) + from(outline[0].x));
    });
}

}  // namespace
}  // namespace parison::tests
