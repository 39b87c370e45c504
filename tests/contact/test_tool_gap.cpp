// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "contact/unilateral/tool_constraints.hpp"
#include "contact/unilateral/tool_gap.hpp"
#include "tool_outlines.hpp"

namespace parison::contact::testing {
namespace {

const double reach = 0.5e-3;

std::vector<GapConstraint> gaps(const Outline& outline, double x, double y, double within = reach) {
  return ToolConstraints(outline.profile, outline.contact)({x, y}, within);
}

void expect_constraint(const GapConstraint& c, double gap, const Point& normal) {
  EXPECT_NEAR(c.gap, gap, 1e-15);
  EXPECT_NEAR((c.normal - normal).norm(), 0, 1e-12);
}

/// Tool with a flat top: contact on y = 0 from x = 0.02 to 0, sides and bottom free.
Outline block() {
  return Pen({0, -0.02}).free({0.02, -0.02}).free({0.02, 0}).contact({0, 0}).close();
}

TEST(ToolGap, a_line_measures_above_and_below_within_reach) {
  for (const double gap : {3e-4, 1e-15, 0.0, -1e-15, -3e-4}) {
    const auto found = gaps(block(), 0.013, gap);
    ASSERT_EQ(found.size(), 1u);
    expect_constraint(found[0], gap, {0, 1});
    EXPECT_EQ(found[0].segment, 2);
  }
  EXPECT_TRUE(gaps(block(), 0.013, 6e-4).empty());
  EXPECT_TRUE(gaps(block(), 0.013, -6e-4).empty());
}

TEST(ToolGap, the_ends_of_the_contact_boundaries_hold_nothing_beyond_them) {
  EXPECT_EQ(gaps(block(), 0, 1e-4).size(), 1u);
  EXPECT_EQ(gaps(block(), 0.02, 1e-4).size(), 1u);
  for (const double beyond : {1e-6, 1e-4}) {
    EXPECT_TRUE(gaps(block(), -beyond, 1e-4).empty());
    EXPECT_TRUE(gaps(block(), 0.02 + beyond, 1e-4).empty());
    EXPECT_TRUE(gaps(block(), -beyond, -1e-4).empty());
  }
}

TEST(ToolGap, arcs_measure_along_their_radius_re_entrant_or_round) {
  const Outline round = Pen({0, 0}).free({0.01, 0}).contact_arc({0, 0}, 0.01, 0, M_PI / 2).close();
  const Outline hollow =
      Pen({0.02, 0.02}).free({0, 0.02}).free({0, 0.01}).contact_arc({0, 0}, 0.01, M_PI / 2, 0).free({0.02, 0}).close();
  for (const double angle : {0.1, 0.7, 1.5})
    for (const double gap : {2e-4, 0.0, -2e-4}) {
      const Point outward(std::cos(angle), std::sin(angle));
      const Point above = (0.01 + gap) * outward, inside = (0.01 - gap) * outward;
      const auto on_round = gaps(round, above[0], above[1]), at_reentrant_corner = gaps(hollow, inside[0], inside[1]);
      ASSERT_EQ(on_round.size(), 1u);
      ASSERT_EQ(at_reentrant_corner.size(), 1u);
      EXPECT_NEAR(on_round[0].gap, gap, 1e-16 + 1e-12 * std::abs(gap));
      EXPECT_NEAR((on_round[0].normal - outward).norm(), 0, 1e-12);
      EXPECT_NEAR(at_reentrant_corner[0].gap, gap, 1e-16 + 1e-12 * std::abs(gap));
      EXPECT_NEAR((at_reentrant_corner[0].normal + outward).norm(), 0, 1e-12);
    }
}

/// Floor y = 0 and wall x = 0 of a tool that fills the other three quadrants, contact on both.
Outline hollow_corner() {
  return Pen({-0.02, -0.02})
      .free({0.02, -0.02})
      .free({0.02, 0})
      .contact({0, 0})
      .contact({0, 0.02})
      .free({-0.02, 0.02})
      .close();
}

TEST(ToolGap, both_sides_of_a_re_entrant_corner_constrain_even_behind_them) {
  for (const double x : {3e-4, 1e-7, 0.0, -1e-7, -2e-4})
    for (const double y : {2e-4, 1e-9, 0.0, -1e-9, -3e-4}) {
      const auto found = gaps(hollow_corner(), x, y);
      ASSERT_EQ(found.size(), 2u) << x << " " << y;
      const bool floor_first = found[0].normal[1] > 0.5;
      expect_constraint(found[floor_first ? 0 : 1], y, {0, 1});
      expect_constraint(found[floor_first ? 1 : 0], x, {1, 0});
      EXPECT_LE(found[0].gap, found[1].gap);
    }
}

TEST(ToolGap, a_point_at_the_foot_of_a_rib_has_the_sides_of_its_corner_and_not_the_other_side_of_the_rib) {
  const Outline ribbed = Pen({0, -0.02})
                             .free({0.02, -0.02})
                             .free({0.02, 0})
                             .contact({0.012, 0})
                             .contact({0.0115, 0.0015})
                             .contact({0.0105, 0.0015})
                             .contact({0.010, 0})
                             .contact({0, 0})
                             .close();
  const Point side = Point(-3, 1).normalized();  // of the rib, towards the corner at x = 10 mm
  for (const double depth : {1e-7, 1e-9, 0.0, -1e-9, -1e-7}) {
    const auto found = gaps(ribbed, 0.010, -depth, 3e-3);
    ASSERT_EQ(found.size(), 2u) << depth;
    for (const GapConstraint& c : found) {
      const Point normal = c.normal[0] < -0.5 ? side : Point(0, 1);
      EXPECT_NEAR((c.normal - normal).norm(), 0, 1e-12) << depth;
      EXPECT_NEAR(c.gap, -depth * normal[1], 1e-15) << depth;
    }
  }
}

TEST(ToolGap, a_point_past_the_end_of_a_face_is_not_held_by_the_other_side_of_the_tool) {
  const Outline ring = Pen({0.010, 0.030}).contact({0.010, 0}).contact({0.020, 0}).free({0.020, 0.030}).close();
  for (const double depth : {1e-9, 1e-7, 1e-5}) {
    EXPECT_TRUE(gaps(ring, 0.020 + depth, depth, 20e-3).empty()) << depth;
    const auto before_the_end = gaps(ring, 0.020 - depth, depth, 20e-3);
    ASSERT_EQ(before_the_end.size(), 1u) << depth;
    EXPECT_NEAR(before_the_end[0].gap, -depth, 1e-15);
  }
}

TEST(ToolGap, a_fold_of_micrometres_as_rounded_coordinates_leave_it_is_not_felt_beside_it) {
  for (const double fold : {1e-6, 2.5e-6}) {
    const Point joint(0.01, 0), back(0.01 + fold, fold);
    const Outline folded =
        Pen({0, -0.02}).free({0.02, -0.02}).free({0.02, 0}).contact(joint).contact(back).contact({0, fold}).close();
    for (const double x : {0.0095, 0.0098, 0.00995, 0.01005, 0.0102, 0.0105})
      for (const double y : {1e-6, 2e-5, 2e-4}) {
        const auto found = gaps(folded, x, fold + y);
        ASSERT_EQ(found.size(), 1u) << x << ' ' << y;
        EXPECT_NEAR(found[0].normal[1], 1, 1e-9);
        EXPECT_NEAR(found[0].gap, y, 1.01 * fold);
        EXPECT_EQ(found[0].segment, x < 0.01 ? 4 : 2);
      }
  }
}

TEST(ToolGap, a_sharp_corner_outside_pushes_from_its_point_and_inside_the_shortest_way_out) {
  const Outline corner = Pen({-0.02, -0.02}).free({0, -0.02}).contact({0, 0}).contact({-0.02, 0}).close();
  const auto off = gaps(corner, 3e-4, 1e-4);
  ASSERT_EQ(off.size(), 1u);
  expect_constraint(off[0], std::hypot(3e-4, 1e-4), Point(3, 1).normalized());
  const auto above = gaps(corner, -1e-4, 3e-4), beside = gaps(corner, 2e-4, -1e-4);
  ASSERT_EQ(above.size(), 1u);
  ASSERT_EQ(beside.size(), 1u);
  expect_constraint(above[0], 3e-4, {0, 1});
  expect_constraint(beside[0], 2e-4, {1, 0});
  const auto inside = gaps(corner, -3e-4, -1e-4), just_inside = gaps(corner, -1e-12, -2e-4);
  ASSERT_EQ(inside.size(), 1u);
  ASSERT_EQ(just_inside.size(), 1u);
  expect_constraint(inside[0], -1e-4, {0, 1});
  expect_constraint(just_inside[0], -1e-12, {1, 0});
  const auto at = gaps(corner, 0, 0);
  ASSERT_FALSE(at.empty());
  EXPECT_NEAR(at[0].gap, 0, 1e-15);
}

TEST(ToolGap, smooth_joints_give_one_constraint_without_a_crack) {
  const Outline jar_blank = blank();
  for (const double offset : {2e-4, 1e-12, -1e-12, -2e-4})
    for (double along = -4e-4; along < 4e-4; along += 1.3e-5) {
      const auto found = gaps(jar_blank, 13.5e-3 + along, 98e-3 - offset);
      ASSERT_EQ(found.size(), 1u) << along << " " << offset;
      EXPECT_NEAR(found[0].gap, offset, 1.2e-5);
      const auto kink = gaps(jar_blank, 29.5e-3 - offset, 20e-3 + along);
      ASSERT_EQ(kink.size(), 1u) << along << " " << offset;
    }
}

TEST(ToolGap, a_thin_plate_is_left_on_the_near_side_and_not_felt_through) {
  const Outline plate = Pen({0, -3e-4}).contact({0.02, -3e-4}).free({0.02, 0}).contact({0, 0}).close();
  for (const double y : {1e-4, 1e-16, 0.0, -1e-16, -1e-4}) {
    const auto found = gaps(plate, 0.01, y);
    ASSERT_EQ(found.size(), 1u) << y;
    expect_constraint(found[0], y, {0, 1});
  }
  const auto below = gaps(plate, 0.01, -2.5e-4);
  ASSERT_EQ(below.size(), 1u);
  expect_constraint(below[0], -5e-5, {0, -1});
}

TEST(ToolGap, a_contact_boundary_is_not_felt_through_the_free_back_of_its_wall) {
  const Outline plate = Pen({0, -3e-4}).contact({0.02, -3e-4}).free({0.02, 0}).free({0, 0}).close();
  EXPECT_TRUE(gaps(plate, 0.01, 1e-4).empty());
  const auto inside = gaps(plate, 0.01, -1e-4);
  ASSERT_EQ(inside.size(), 1u);
  expect_constraint(inside[0], -2e-4, {0, -1});
}

TEST(ToolGap, a_narrow_groove_holds_from_both_walls) {
  const Outline groove = Pen({-0.02, -0.02})
                             .free({0.02, -0.02})
                             .free({0.02, 0.01})
                             .free({2e-4, 0.01})
                             .contact({2e-4, 0})
                             .contact({-2e-4, 0})
                             .contact({-2e-4, 0.01})
                             .free({-0.02, 0.01})
                             .close();
  const auto found = gaps(groove, 5e-5, 5e-3);
  ASSERT_EQ(found.size(), 2u);
  expect_constraint(found[0], 1.5e-4, {-1, 0});
  expect_constraint(found[1], 2.5e-4, {1, 0});
}

TEST(ToolGap, merging_tools_keeps_the_smaller_of_like_normals_and_two_at_most) {
  const Point tilted(std::sin(0.2), std::cos(0.2));
  std::vector<GapConstraint> constraints{{2e-4, {0, 1}, 0}, {-1e-4, tilted, 1}, {1e-4, {1, 0}, 2}, {3e-4, {0, -1}, 3}};
  merge_constraints(constraints);
  ASSERT_EQ(constraints.size(), 2u);
  expect_constraint(constraints[0], -1e-4, tilted);
  expect_constraint(constraints[1], 1e-4, {1, 0});
}

TEST(ToolGap, the_deepest_of_points_is_that_of_their_gaps_wherever_the_search_begins_and_whatever_is_known) {
  const Outline round = Pen({0, 0}).free({0.01, 0}).contact_arc({0, 0}, 0.01, 0, M_PI / 2).close();
  for (const Outline& outline : {block(), round, neck_ring(), guide_plate()}) {
    const ToolGap gap(outline.profile, outline.contact);
    int deeper = 0;
    for (int i = -20; i <= 60; ++i)
      for (int k = -25; k <= 20; ++k)
        for (const double known : {0.0, 1e-6, 2e-3, 1.0})
          for (const std::size_t first : {0, 1, 7}) {
            const Point x(i * 1e-3, k * 1e-3);
            std::size_t closest = first;
            const double depth = gap.deepest(x, known, closest);
            EXPECT_EQ(depth, std::max(known, -gap(x))) << x.transpose() << " beyond " << known;
            deeper += depth > known;
          }
    EXPECT_GT(deeper, 100);
  }
}

TEST(ToolGap, the_corner_between_ring_and_guide_plate_is_their_union) {
  const Outline ring = neck_ring(), plate = guide_plate();
  for (const double dr : {2e-4, 1e-6, -1e-6, -1e-4})
    for (const double dz : {3e-4, 1e-6, -1e-6, -1e-4}) {
      auto found = gaps(ring, 31e-3 - dr, dz);
      const auto more = gaps(plate, 31e-3 - dr, dz);
      found.insert(found.end(), more.begin(), more.end());
      merge_constraints(found);
      // Beyond the ring's lower end only the plate holds, until the glass is back above z = 0; the same sideways.
      ASSERT_EQ(found.size(), std::size_t((dz > 0) + (dr > 0))) << dr << " " << dz;
      for (const auto& c : found) EXPECT_NEAR(c.gap, c.normal[1] > 0.5 ? dz : dr, 1e-15);
    }
}

/// A tool below a cone around the axis whose tip, or deepest point, is at the origin.
Outline cone(double slope) {
  return Pen({0, -10e-3}).free({10e-3, -10e-3}).free({10e-3, slope * 10e-3}).contact({0, 0}).close();
}

TEST(ToolGap, a_tip_on_the_axis_is_met_by_a_point_that_projects_onto_no_face) {
  const auto above = gaps(cone(-0.3), 0, 1e-4, 1e-3);
  ASSERT_EQ(above.size(), 1u);
  EXPECT_NEAR(above[0].gap, 1e-4, 1e-15);
  EXPECT_EQ(above[0].normal, Point(0, 1));
  EXPECT_TRUE(gaps(cone(-0.3), 0, 2e-3, 1e-3).empty());
  EXPECT_EQ(gaps(cone(-0.3), 1e-3, 0, 1e-3).size(), 1u);  // beside it the face counts
  const auto cup = gaps(cone(0.3), 0, 1e-4, 1e-3);
  ASSERT_EQ(cup.size(), 1u);  // the face of a cup, which the point projects onto
  EXPECT_LT(cup[0].gap, 1e-4);
}

TEST(ToolGap, the_deepest_point_of_a_cup_on_the_axis_holds_a_point_below_it_too) {
  const Outline above = Pen({0, 0}).contact({10e-3, -3e-3}).free({10e-3, 10e-3}).free({0, 10e-3}).close();
  for (const double depth : {0.0, 1e-9, 1e-6, 1e-4}) {
    const Point normal = Point(-0.3, 1).normalized();
    const auto below_cup = gaps(cone(0.3), 0, -depth, 1e-3), over_cup = gaps(above, 0, depth, 1e-3);
    ASSERT_EQ(below_cup.size(), 1u) << depth;
    ASSERT_EQ(over_cup.size(), 1u) << depth;
    EXPECT_NEAR(below_cup[0].gap, -depth * normal[1], 1e-15);
    EXPECT_NEAR(over_cup[0].gap, -depth * normal[1], 1e-15);
    EXPECT_NEAR((below_cup[0].normal - normal).norm(), 0, 1e-12);
    EXPECT_NEAR((over_cup[0].normal - Point(normal[0], -normal[1])).norm(), 0, 1e-12);
  }
}

}  // namespace
}  // namespace parison::contact::testing
