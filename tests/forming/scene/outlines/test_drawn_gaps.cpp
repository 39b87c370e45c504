// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps between the curves of a drawing, its layers, its unit, its views and branches: what is taken with a note and
// what is refused.
#include <gtest/gtest.h>

#include "dxf_writer.hpp"

namespace parison::tests {
namespace {

const std::string mm = "unit = \"mm\", ";

/// Sides of a rectangle of 20 by 30 mm, the third of which starts `gap` too late.
std::string rectangle_with_gap(double gap) {
  DxfWriter writer;
  writer.line({20, 0}, {40, 0});
  writer.line({40, 0}, {40, 30});
  writer.line({40 - gap, 30}, {20, 30});
  writer.line({20, 30}, {20, 0});
  return dxf_of(writer.text);
}

TEST(DrawnGaps, ends_up_to_a_hundredth_of_a_millimetre_apart_are_brought_together_with_a_note) {
  const Taken taken = take("a.dxf", rectangle_with_gap(0.009), mm + from({20, 0}));
  EXPECT_EQ(taken.refusal, "");
  EXPECT_NEAR(taken.area, 600, 0.15);
  ASSERT_EQ(taken.notes.size(), 1);
  EXPECT_NE(taken.notes[0].find("1 in all"), std::string::npos) << taken.notes[0];
  EXPECT_NE(taken.notes[0].find("0.009 mm at (40"), std::string::npos) << taken.notes[0];
  EXPECT_TRUE(take("a.dxf", rectangle_with_gap(0), mm + from({20, 0})).notes.empty());
}

TEST(DrawnGaps, wider_ones_and_those_that_the_case_forbids_are_refused_and_a_key_takes_them) {
  const auto refusal = [](double gap, const std::string& keys) {
    return take("a.dxf", rectangle_with_gap(gap), mm + keys + from({20, 0})).refusal;
  };
  EXPECT_NE(refusal(0.02, "").find("gap of 0.02 mm at"), std::string::npos) << refusal(0.02, "");
  EXPECT_NE(refusal(0.009, "gap = \"0 mm\", ").find("gap of 0.009 mm at"), std::string::npos);
  EXPECT_EQ(refusal(0.02, "gap = \"0.03 mm\", "), "");
  EXPECT_NE(refusal(0.02, "gap = \"5 mm\", ").find("allowed are up to"), std::string::npos);
}

TEST(DrawnGaps, an_arc_keeps_its_shape_where_a_line_is_brought_to_it) {
  DxfWriter writer;
  writer.line({20, 0}, {40.004, 0});
  writer.arc({40, 0}, {40, 20}, 1);
  writer.line({40, 19.997}, {20, 20});
  writer.line({20, 20}, {20, 0});
  const Taken taken = take("a.dxf", dxf_of(writer.text), mm + from({20, 0}));
  EXPECT_NEAR(taken.area, 400 + 50 * M_PI, 1e-9) << taken.refusal;
  EXPECT_EQ(taken.notes.size(), 1);
}

TEST(DrawnGaps, a_layer_that_is_not_there_is_refused_with_those_that_are) {
  DxfWriter writer;
  for (const char* layer : {"Blank", "Mould"}) {
    writer.layer = layer;
    writer.light_polyline({{{20, 0}}, {{40, 0}}, {{40, 30}}, {{20, 30}}});
  }
  const std::string refusal = take("a.dxf", dxf_of(writer.text), mm + "layer = \"BLANC\", " + from({20, 0})).refusal;
  EXPECT_NE(refusal.find("layer: no lines or arcs were found on layer \"BLANC\""), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("allowed are \"Blank\", \"Mould\""), std::string::npos) << refusal;
}

TEST(DrawnGaps, a_frozen_layer_is_taken_where_the_case_names_it_and_told_where_not) {
  DxfWriter writer;
  for (const char* layer : {"Blank", "Mould"}) {
    writer.layer = layer;
    writer.light_polyline({{{20, 0}}, {{40, 0}}, {{40, 30}}, {{20, 30}}});
  }
  const std::string tables = "0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nMOULD\n70\n1\n62\n7\n0\nENDTAB\n";
  const std::string file = dxf_of(writer.text, "", tables);
  const Taken all = take("a.dxf", file, mm + from({20, 0}));
  EXPECT_NEAR(all.area, 600, 1e-9) << all.refusal;
  ASSERT_EQ(all.notes.size(), 1);
  EXPECT_NE(all.notes[0].find("\"Mould\" (frozen or switched off)"), std::string::npos) << all.notes[0];
  EXPECT_NEAR(take("a.dxf", file, mm + "layer = \"mould\", " + from({20, 0})).area, 600, 1e-9);
}

TEST(DrawnGaps, a_drawing_without_any_unit_is_refused_and_one_of_another_unit_too) {
  const std::string file = rectangle_with_gap(0);
  EXPECT_NE(take("a.dxf", file, from({20, 0})).refusal.find("unit: missing"), std::string::npos);
  std::string inches = file;
  inches.insert(0, section("HEADER", "9\n$INSUNITS\n70\n1\n"));
  EXPECT_NE(take("a.dxf", inches, mm + from({20, 0})).refusal.find("a drawing in inches"), std::string::npos);
}

/// Half of a cup of 40 by 60 mm with a hollow of 20 by 40 mm, open at its axis; on another side, upside down.
void draw_cup(DxfWriter& writer, double side = 1, double up = 1) {
  const std::vector<Point> corners{{0, 20}, {20, 20}, {20, 60}, {40, 60}, {40, 0}, {0, 0}};
  for (std::size_t i = 1; i < corners.size(); ++i)
    writer.line(corners[i - 1].cwiseProduct(Point(side, up)), corners[i].cwiseProduct(Point(side, up)));
}

const std::string hollow = "from = \"(0, 20) mm\", to = \"(20, 60) mm\"";  // with (0, 0) 200 mm2

TEST(DrawnViews, a_half_view_left_of_its_axis_comes_to_the_radii_whatever_lies_beside_it) {
  for (const double beside : {-300, 300})
    for (const auto& [axis, side, up] : {std::tuple{"y", -1, 1}, {"-y", 1, -1}, {"y", 1, 1}, {"-y", -1, -1}}) {
      DxfWriter writer;
      draw_cup(writer, side, up);
      writer.light_polyline({{{beside, 0}}, {{beside + 30, 0}}, {{beside, 30}}});
      const Taken taken = take("a.dxf", dxf_of(writer.text), mm + fmt::format("axis = \"{}\", ", axis) + hollow);
      EXPECT_NEAR(taken.area, 200, 1e-9) << axis << beside << taken.refusal;
    }
}

TEST(DrawnViews, lines_that_meet_the_outline_are_left_out_with_a_note) {
  DxfWriter writer;
  draw_cup(writer);
  writer.line({20, 60}, {20, 90});
  writer.line({40, 60}, {60, 60});
  const Taken half = take("a.dxf", dxf_of(writer.text), mm + hollow);
  EXPECT_NEAR(half.area, 200, 1e-9) << half.refusal;
  ASSERT_EQ(half.notes.size(), 1);
  EXPECT_NE(half.notes[0].find("2 curves from (0, 20) mm to (20, 60) mm were taken"), std::string::npos);
  const std::string whole = take("a.dxf", dxf_of(writer.text), mm + "from = \"(0, 20) mm\"").refusal;
  EXPECT_NE(whole.find("meet at (20, 60) mm, allowed is one outline without branches, or a \"to\""), whole.npos)
      << whole;
  draw_cup(writer, -1);
  const Taken both = take("a.dxf", dxf_of(writer.text), mm + "via = \"(20, 40) mm\", " + hollow);
  EXPECT_NEAR(both.area, 200, 1e-9) << both.refusal;
}

TEST(DrawnViews, where_two_ways_go_on_via_chooses) {
  DxfWriter writer;
  draw_cup(writer);
  writer.arc({20, 20.008}, {20, 60}, 0.5);  // with a gap that is closed
  const std::string file = dxf_of(writer.text), refusal = take("a.dxf", file, mm + hollow).refusal;
  EXPECT_NE(refusal.find("so 2 ways lead from \"from\" to \"to\", allowed is one, or a \"via\""), refusal.npos)
      << refusal;
  EXPECT_NEAR(take("a.dxf", file, mm + "via = \"(20, 30) mm\", " + hollow).area, 200, 1e-9);
  const Taken bent = take("a.dxf", file, mm + "gap = \"0.01 mm\", via = \"(30, 40) mm\", " + hollow);
  EXPECT_NEAR(bent.area, 200 + area_of_arc({20, 20}, {20, 60}, 0.5), 0.2) << bent.refusal;
}

TEST(DrawnViews, a_centre_line_is_no_outline_and_two_outlines_are_told_by_their_layers) {
  DxfWriter writer;
  draw_cup(writer);
  writer.line({0, -10}, {0, 90});
  EXPECT_NEAR(take("a.dxf", dxf_of(writer.text), mm + hollow).area, 200, 1e-9);
  writer.layer = "PLUNGER";
  writer.line({-5, 10}, {5, 30});
  const std::string refusal = take("a.dxf", dxf_of(writer.text), mm + hollow).refusal;
  EXPECT_NE(refusal.find("lies on two, on layer \"0\" and on layer \"PLUNGER\" (layer takes one alone)"), refusal.npos)
      << refusal;
}

TEST(DrawnViews, of_a_full_section_from_the_axis_to_the_axis_that_at_the_radii_is_taken) {
  DxfWriter writer;
  draw_cup(writer);
  draw_cup(writer, -1.1);
  const Taken taken = take("a.dxf", dxf_of(writer.text), mm + "from = \"(0, 20) mm\", to = \"(0, 0) mm\"");
  EXPECT_NEAR(taken.area, 40 * 60 - 20 * 40, 1e-9) << taken.refusal;
}

TEST(DrawnViews, a_place_far_from_the_drawing_is_refused_with_where_that_is) {
  DxfWriter writer;
  draw_cup(writer);
  const std::string keys = "origin = \"(0, 60) mm\", ",
                    refusal = take("a.dxf", dxf_of(writer.text), mm + keys + hollow).refusal;
  EXPECT_NE(refusal.find("reaches from (0, -60) mm to (40, 0) mm"), refusal.npos) << refusal;
}

}  // namespace
}  // namespace parison::tests
