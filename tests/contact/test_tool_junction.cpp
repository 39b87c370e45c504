// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "contact/unilateral/tool_junction.hpp"
#include "core/mesh/profile.hpp"
#include "tests/contact/tool_outlines.hpp"

namespace parison::contact {
namespace {

using core::Point;
using testing::Outline;
using testing::Pen;

/// A ring, r > 31 mm, below z = 14 mm, and a blank above it whose wall leans by `lean` mm in 6 mm towards the axis.
struct RingAndBlank {
  explicit RingAndBlank(double lean)
      : ring(Pen(Point(56e-3, 0)).free({56e-3, 14e-3}).free({31e-3, 14e-3}).contact({31e-3, 0}).close()),
        blank(Pen(Point(56e-3, 14e-3))
                  .free({56e-3, 20e-3})
                  .free({31e-3 - 1e-3 * lean, 20e-3})
                  .contact({31e-3, 14e-3})
                  .close()) {}
  std::vector<PlacedTool> placed(double shift = 0) const {
    return {{&ring.profile, ring.contact, 0}, {&blank.profile, blank.contact, shift}};
  }
  Outline ring, blank;
};

TEST(ToolJoint, tools_that_meet_have_one_joint_and_tools_apart_none) {
  const RingAndBlank tools(1.5);
  const auto joints = tool_joints(tools.placed());
  ASSERT_EQ(joints.size(), 1u);
  EXPECT_EQ(joints[0].before, 1);
  EXPECT_EQ(joints[0].after, 0);
  EXPECT_TRUE(tool_joints(tools.placed(1e-3)).empty());
}

TEST(ToolJoint, a_point_in_the_wedge_of_a_hollow_joint_is_sent_out_by_both_tools) {
  const RingAndBlank tools(1.5);
  const auto placed = tools.placed();
  const auto joint = tool_joints(placed).front();
  const Point x(31.0192e-3, 14.0034e-3);  // projects on neither wall
  for (const auto& tool : placed) EXPECT_TRUE(ToolConstraints(*tool.profile, tool.contact_boundaries)(x, 1e-3).empty());
  const auto found = joint_constraints(joint, x, 1e-3);
  ASSERT_EQ(found.size(), 2u);
  for (const auto& [tool, constraint] : found) {
    EXPECT_LT(constraint.gap, -15e-6);
    const Point out = x - constraint.gap * constraint.normal;
    const Point on = tool == 0 ? Point(31e-3, out[1]) : Point(31e-3 - 0.25 * (out[1] - 14e-3), out[1]);
    EXPECT_NEAR((out - on).norm(), 0, 1e-12);
  }
}

TEST(ToolJoint, a_hollow_joint_keeps_a_point_of_one_wall_behind_the_other_too) {
  const RingAndBlank tools(1.5);
  const auto joint = tool_joints(tools.placed()).front();
  const auto found = joint_constraints(joint, Point(31e-3, 13.9e-3), 1e-3);  // on the ring
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].tool, 1);
  EXPECT_NEAR(found[0].constraint.gap, -0.1e-3 * 1.5 / std::hypot(1.5, 6.0) * -1, 1e-9);
}

TEST(ToolJoint, a_joint_that_sticks_out_keeps_glass_away_by_its_point) {
  const RingAndBlank tools(-1.5);
  const auto joint = tool_joints(tools.placed()).front();
  const Point x(30.9e-3, 14.005e-3);
  const auto found = joint_constraints(joint, x, 1e-3);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].constraint.gap, (x - Point(31e-3, 14e-3)).norm(), 1e-12);
  EXPECT_TRUE(joint_constraints(joint, Point(30.9e-3, 13.9e-3), 1e-3).empty());  // the ring's own
}

TEST(ToolJoint, a_wall_is_extended_only_as_far_as_the_wall_behind_the_joint_reaches) {
  const RingAndBlank tools(1.5);
  const auto joint = tool_joints(tools.placed()).front();
  const core::Segment& after = joint.segment_after;
  const Point along = (after.end - after.start).normalized(), outwards = -core::normal_at(after, 0);
  const double length = core::length(after);
  const Point beside = after.start + 0.9 * length * along + 1e-6 * outwards;
  const Point beyond = after.start + 1.1 * length * along + 1e-6 * outwards;
  const auto of_blank = [&](const Point& x) {
    const auto found = joint_constraints(joint, x, 10 * length);
    return std::count_if(found.begin(), found.end(), [&](const auto& c) { return c.tool == joint.before; });
  };
  EXPECT_EQ(of_blank(beside), 1);
  EXPECT_EQ(of_blank(beyond), 0);
}

TEST(ToolJoint, beyond_reach_nothing_is_constrained) {
  const RingAndBlank tools(1.5);
  const auto joint = tool_joints(tools.placed()).front();
  EXPECT_TRUE(joint_constraints(joint, Point(30e-3, 12e-3), 1e-3).empty());
}

/// A ring, r > 31 mm, that stands on a plate through which it does not pass.
TEST(ToolJoint, glass_a_little_inside_a_plate_stays_inside_the_ring_that_stands_on_it) {
  const Outline ring = Pen(Point(56e-3, 0)).free({56e-3, 14e-3}).free({31e-3, 14e-3}).contact({31e-3, 0}).close();
  const Outline plate = Pen(Point(56e-3, 0)).contact({0, 0}).free({0, -25e-3}).free({56e-3, -25e-3}).close();
  const auto placed = [&](double lift) {
    return std::vector<PlacedTool>{{&ring.profile, ring.contact, lift}, {&plate.profile, plate.contact, 0}};
  };
  EXPECT_TRUE(tool_joints(placed(0)).empty());
  EXPECT_TRUE(tool_t_junctions(placed(0.1e-3)).empty());
  const auto t_junctions = tool_t_junctions(placed(0));
  ASSERT_EQ(t_junctions.size(), 1u);
  EXPECT_EQ(t_junctions[0].tool, 0);
  const Point under(32.4e-3, -0.2e-6);
  EXPECT_TRUE(ToolConstraints(ring.profile, ring.contact)(under, 5e-3).empty());
  const auto found = t_junction_constraint(t_junctions[0], under, 5e-3);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->tool, 0);
  EXPECT_NEAR(found->constraint.gap, -1.4e-3, 1e-12);
  EXPECT_NEAR(found->constraint.normal[0], -1, 1e-12);
  EXPECT_FALSE(t_junction_constraint(t_junctions[0], {32.4e-3, 0.2e-6}, 5e-3));  // the ring's own
  EXPECT_FALSE(t_junction_constraint(t_junctions[0], under, 1e-3));
}

}  // namespace
}  // namespace parison::contact
