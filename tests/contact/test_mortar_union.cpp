// SPDX-License-Identifier: GPL-3.0-or-later
// Several tools at one glass surface, and contact that ends between nodes.
#include <gtest/gtest.h>

#include "contact/mortar/segments.hpp"
#include "contact/unilateral/tool_gap.hpp"
#include "interface_cases.hpp"
#include "tool_outlines.hpp"

namespace parison::contact::testing {
namespace {

using core::Geometry;

/// Contact boundaries of an outline cut into edges of about `size`, mid-side nodes on the outline.
Surface meshed(Index body, const Outline& outline, double size) {
  Surface surface{body, {}};
  Index node = 0;
  for (const auto& segment : outline.profile.segments) {
    if (!outline.contact[segment.boundary_id]) continue;
    const int count = static_cast<int>(std::ceil(core::length(segment) / size));
    for (int i = 0; i < count; ++i) {
      const auto at = [&](double k) { return core::point_at(segment, k / count); };
      surface.edges.push_back({{node, node + 2, node + 1}, {at(i), at(i + 1), at(i + 0.5)}});
      node += 2;
    }
  }
  return surface;
}

/// A glass surface of straight edges through points, the body on the left.
Surface glass_chain(const std::vector<Point>& points) {
  Surface surface{0, {}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Index node = 2 * static_cast<Index>(i - 1);
    surface.edges.push_back(
        {{node, node + 2, node + 1}, {points[i - 1], points[i], 0.5 * (points[i - 1] + points[i])}});
  }
  return surface;
}

struct Tool {
  Outline outline;
  double mesh_size;
};
/// The interface as a run builds it: gaps by the exact outlines, out of reach beyond ten times the transition.
std::vector<core::InterfacePoint> touch(const Surface& glass, const std::vector<Tool>& tools, Geometry geometry) {
  const Index count = glass.edges.back().nodes[1] + 1;
  std::vector<Master> masters;
  for (const Tool& tool : tools) {
    Eigen::VectorXd gap = Eigen::VectorXd::Constant(count, infinity);
    for (const auto& edge : glass.edges)
      for (int i = 0; i < 3; ++i) {
        const double d = signed_gap(tool.outline.profile, tool.outline.contact, edge.x[i]);
        if (d <= 10 * width) gap[edge.nodes[i]] = d;
      }
    const Index body = 1 + static_cast<Index>(masters.size());
    masters.push_back({meshed(body, tool.outline, tool.mesh_size), gap, width, body - 1});
  }
  return contact::build_interface(glass, Eigen::VectorXd::Constant(count, 1e5), masters, geometry);
}

double area_with(const std::vector<core::InterfacePoint>& points, Index body) {
  double sum = 0;
  for (const auto& p : points)
    if (p.master_body == body) sum += p.area * p.contact_weight;
  return sum;
}

/// A block of metal under y = 0 from x = a to b, `below` deep; its top is the contact.
Outline block(double a, double b, double top = 0) {
  return Pen({a, top - 0.01}).free({b, top - 0.01}).free({b, top}).contact({a, top}).close();
}

TEST(NodeRules, a_node_has_its_own_bodys_values_and_the_other_bodys_interpolated) {
  const Surface slave = contact_surface(0, glass(divided(0, 0.02, 5))),
                tools = contact_surface(1, tool(divided(0, 0.02, 7)));
  std::vector<MasterEdge> masters;
  std::vector<Index> all;
  for (const auto& edge : tools.edges) {
    all.push_back(static_cast<Index>(masters.size()));
    masters.push_back({edge, 0});
  }
  const auto own = [](double s) {
    const auto shape = core::edge_shape(s);
    return std::count_if(shape.begin(), shape.end(), [](double n) { return std::abs(n - 1) < 1e-13; }) == 1;
  };
  int from_slave = 0, from_master = 0;
  std::vector<InterfaceNode> nodes;
  for (const auto& edge : make_rays(slave)) {
    const EdgeView view{edge, masters, all, 0.01};
    find_interface_nodes(view, nodes);
    for (const auto& node : nodes) {
      const double master_s = find_visible_master(view, node.slave_s)->hit.s;
      const bool at_tool_end = std::abs(position(edge.edge, node.slave_s)[0] - 0.01) > 0.0099;
      (node.slave_node >= 0 ? from_slave : from_master) += 1;
      if (at_tool_end) continue;
      EXPECT_EQ(own(node.slave_s), node.slave_node >= 0);
      if (node.slave_node != 2) {
        EXPECT_EQ(own(master_s), node.slave_node < 0);
      }
    }
  }
  EXPECT_EQ(from_slave, 15);
  EXPECT_EQ(from_master, 6);
}

TEST(ContactEnd, a_tool_that_ends_anywhere_between_glass_nodes_keeps_its_whole_area) {
  for (const auto geometry : {Geometry::planar, Geometry::axisymmetric})
    for (const int n : {1, 3, 7, 20})
      for (double end = 0.0021; end < 0.0199; end += 0.00071) {
        std::vector<Point> x;
        for (int i = n; i >= 0; --i) x.push_back({0.02 * i / n, 0});
        std::reverse(x.begin(), x.end());
        const auto points = touch(glass_chain(x), {{block(0, end), 0.0013}}, geometry);
        const double exact = geometry == Geometry::planar ? end : M_PI * end * end;
        EXPECT_NEAR(weighted_contact_area(points), exact, 1e-12 * exact) << n << " " << end;
      }
}

TEST(ContactEnd, a_narrow_tool_between_two_glass_nodes_that_are_out_of_reach_touches_with_all_its_area) {
  const auto points = touch(glass_chain({{0, 0}, {0.02, 0}}), {{block(0.0031, 0.0074), 0.002}}, Geometry::planar);
  EXPECT_NEAR(weighted_contact_area(points), 0.0043, 1e-15);
}

TEST(ContactEnd, a_corner_that_digs_into_the_glass_between_its_nodes_touches_as_far_as_it_is_near) {
  const double slope = 0.2;
  const Outline wedge =
      Pen({-0.01, -0.01}).free({0.01, -0.01}).contact({0.0012, 1e-6}).contact({0.0012 - 0.01 / slope, -0.01}).close();
  const auto points = touch(glass_chain({{-0.005, 0}, {0.005, 0}}), {{wedge, 0.05}}, Geometry::planar);
  const double left = (0.5 * width + 1e-6) / slope, right = (0.5 * width + 1e-6) / ((0.01 + 1e-6) / (0.01 - 0.0012));
  EXPECT_NEAR(weighted_contact_area(points), left + right, 0.05 * left);
}

TEST(ToolUnion, neighbouring_and_overlapping_tools_share_the_glass_once) {
  for (const double overlap : {0.0, 1e-9, 1e-4, 0.003})
    for (const double sunk : {0.0, 1e-6, 2e-5})
      for (const double seam : {0.0100, 0.0107, 0.0119}) {
        std::vector<Point> x;
        for (int i = 0; i <= 10; ++i) x.push_back({0.002 * i, 0});
        const auto points =
            touch(glass_chain(x), {{block(0, seam), 0.0017}, {block(seam - overlap, 0.02, -sunk), 0.0011}},
                  Geometry::axisymmetric);
        const double whole = M_PI * 0.02 * 0.02, inner = M_PI * seam * seam;
        const double far = 1 - contact_weight(sunk, width);
        EXPECT_NEAR(weighted_contact_area(points), whole - far * (whole - inner), 1e-9 * whole)
            << overlap << " " << sunk;
        if (sunk > 0) {
          EXPECT_NEAR(area_with(points, 1), inner, 1e-12 * whole);
        }
      }
}

/// Glass in the corner of ring and guide plate, cut off by `cut`; the plate reaches under the ring by `under`.
std::vector<core::InterfacePoint> corner(double cut, double under, int parts, double inside = 0) {
  const Point a = mm(31, 0) + Point(inside - cut, -inside), b = mm(31, 0) + Point(inside, cut - inside);
  std::vector<Point> x{mm(20, 0) + Point(0, -inside)};
  for (int i = 0; i <= parts; ++i) x.push_back(a + (b - a) * i / parts);
  if (cut == 0) x.resize(2);
  x.push_back(mm(31, 13) + Point(inside, 0));
  const Outline plate =
      Pen(mm(0, -20)).free(mm(31, -20) + Point(under, 0)).free(mm(31, 0) + Point(under, 0)).contact(mm(0, 0)).close();
  return touch(glass_chain(x), {{neck_ring(), 0.0023}, {plate, 0.0031}}, Geometry::planar);
}

TEST(ToolUnion, glass_in_the_corner_of_ring_and_plate_counts_once) {
  const double legs = 0.011 + 0.013;
  for (const double under : {0.0, 1e-4, 0.005}) {
    EXPECT_NEAR(weighted_contact_area(corner(0, under, 1)), legs, 1e-13) << under;
    for (const int parts : {1, 2, 3})
      for (const double cut : {1e-8, 1e-6, 2e-6}) {
        const double exact = legs - 2 * cut + std::sqrt(2.0) * cut;
        EXPECT_NEAR(weighted_contact_area(corner(cut, under, parts)), exact, 1e-3 * cut + 1e-12) << under << " " << cut;
      }
    // Glass that has sunk into both by less than the transition, its nodes inside the metal.
    EXPECT_NEAR(weighted_contact_area(corner(1e-5, under, 2, 4e-6)), legs + 2 * 4e-6 - 2e-5 + std::sqrt(2.0) * 1e-5,
                1e-5);
  }
}

TEST(ToolUnion, glass_that_bridges_the_corner_widely_touches_at_its_ends_only) {
  for (const double under : {0.0, 0.005})
    for (const int parts : {1, 2, 5}) {
      const double cut = 0.002, legs = 0.011 + 0.013 - 2 * cut;
      const double strips =
          2 * 0.5 * width * std::sqrt(2.0);  // at 45 degrees, half the transition counts on either side
      EXPECT_NEAR(weighted_contact_area(corner(cut, under, parts)), legs + strips, 0.5 * strips)
          << under << " " << parts;
    }
}

TEST(ToolUnion, a_wall_between_plunger_and_blank_touches_both_with_either_side) {
  for (const double thickness : {1e-4, 1e-3}) {
    const Outline inside = Pen({0.01, 0}).free({0.02, 0}).contact({0.02, 0.03}).free({0.01, 0.03}).close();
    const double r = 0.02 + thickness;
    const Outline outside = Pen({r, 0.03}).contact({r, 0}).free({0.05, 0}).free({0.05, 0.03}).close();
    std::vector<Point> wall;
    for (int i = 0; i <= 7; ++i) wall.push_back({r, 0.03 * i / 7});
    for (int i = 9; i >= 0; --i) wall.push_back({0.02, 0.03 * i / 9});
    const auto points = touch(glass_chain(wall), {{inside, 0.004}, {outside, 0.0027}}, Geometry::axisymmetric);
    EXPECT_NEAR(area_with(points, 1), 2 * M_PI * 0.02 * 0.03, 1e-14);
    EXPECT_NEAR(area_with(points, 2), 2 * M_PI * r * 0.03, 1e-14);
    for (const auto& p : points) EXPECT_NEAR(p.position[0], p.master_body == 1 ? 0.02 : r, 1e-15);
  }
}

}  // namespace
}  // namespace parison::contact::testing
