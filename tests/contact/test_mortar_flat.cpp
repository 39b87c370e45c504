// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "interface_cases.hpp"

namespace parison::contact::testing {
namespace {

using core::Geometry;

const std::vector<std::pair<int, int>> mesh_pairs{{20, 20}, {20, 7}, {7, 20}, {20, 13}, {13, 20}, {1, 9}, {9, 1}};
const std::vector<Geometry> geometries{Geometry::planar, Geometry::axisymmetric};

double disc(Geometry geometry, double from, double to) {
  return geometry == Geometry::planar ? to - from : M_PI * (to * to - from * from);
}

/// Gap to a flat tool that covers [from, to]: none beyond its ends.
std::function<double(const Point&)> gap_over(double from, double to) {
  return [=](const Point& x) { return x[0] < from || x[0] > to ? infinity : 0.0; };
}

TEST(FlatInterface, covers_the_common_area_once_whichever_side_is_longer_or_finer) {
  for (const auto geometry : geometries)
    for (const auto& [n, m] : mesh_pairs)
      for (const double master_end : {0.02, 0.013, 0.031})
        for (const double master_start : {0.0, 0.0041}) {
          const auto slave = glass(divided(0, 0.02, n)), master = tool(divided(master_start, master_end, m));
          const double end = std::min(0.02, master_end);
          const auto state = touching(slave, gap_over(master_start, master_end));
          if (n == 1 && master_end != 0.031 && master_start > 0) continue;  // every node but one lies beyond the tool
          const auto points =
              build_interface(contact_surface(0, slave), contact_surface(1, master), state, {geometry, width, 3});
          const double exact = disc(geometry, master_start, end);
          EXPECT_NEAR(weighted_contact_area(points), exact, 1e-12 * exact)
              << n << "/" << m << " " << master_start << " " << master_end;
        }
}

TEST(FlatInterface, names_bodies_edges_and_law) {
  const auto slave = glass(divided(0, 0.02, 3)), master = tool(divided(0, 0.02, 2));
  const auto points = build_interface(contact_surface(4, slave), contact_surface(7, master), touching(slave),
                                      {Geometry::planar, width, 3});
  ASSERT_FALSE(points.empty());
  for (const auto& p : points) {
    EXPECT_EQ(p.slave_body, 4);
    EXPECT_EQ(p.master_body, 7);
    EXPECT_EQ(p.law, 3);
    EXPECT_EQ(p.contact_weight, 1);
    EXPECT_EQ(p.gap, 0);
    EXPECT_NEAR(p.pressure, 1e5, 1e-9);
    EXPECT_NEAR(interpolate(slave, p.slave_nodes, p.slave_shape, [](const Point& x) { return x[0]; }), p.position[0],
                1e-17);
  }
}

TEST(FlatInterface, linear_and_quadratic_functions_agree_on_both_sides) {
  for (const auto& [n, m] : mesh_pairs) {
    const auto slave = glass(divided(0, 0.02, n)), master = tool(divided(0, 0.02, m));
    const auto points = build_interface(contact_surface(0, slave), contact_surface(1, master), touching(slave),
                                        {Geometry::axisymmetric, width, 0});
    EXPECT_LT(max_jump(slave, master, points, [](const Point& x) { return 1 + 50 * x[0]; }), 1e-12);
    EXPECT_LT(max_jump(slave, master, points, [](const Point& x) { return 1 - 2500 * x[0] * x[0]; }), 1e-12);
  }
}

TEST(FlatInterface, a_constant_flux_loads_both_bodies_as_their_own_edges_would) {
  for (const auto geometry : geometries)
    for (const auto& [n, m] : mesh_pairs) {
      const auto slave = glass(divided(0, 0.02, n)), master = tool(divided(0, 0.02, m));
      const auto points =
          build_interface(contact_surface(0, slave), contact_surface(1, master), touching(slave), {geometry, width, 0});
      for (const bool of_master : {false, true}) {
        const auto& mesh = of_master ? master : slave;
        const Eigen::VectorXd own = own_loads(mesh, geometry);
        EXPECT_LT((interface_loads(mesh, points, of_master) - own).norm(), 1e-12 * own.norm()) << n << "/" << m;
      }
    }
}

TEST(FlatInterface, linear_functions_agree_where_mid_side_nodes_have_moved_off_the_middle) {
  auto slave = glass(divided(0, 0.02, 7));
  for (const auto& edge : slave.boundary_edges())
    if (edge.boundary_id == 1) slave.nodes[edge.nodes[2]][0] += 2e-4;
  const auto master = tool(divided(0, 0.02, 20));
  const auto points = build_interface(contact_surface(0, slave), contact_surface(1, master), touching(slave),
                                      {Geometry::axisymmetric, width, 0});
  EXPECT_LT(max_jump(slave, master, points, [](const Point& x) { return 1 + 50 * x[0]; }), 1e-12);
  EXPECT_NEAR(weighted_contact_area(points), disc(Geometry::axisymmetric, 0, 0.02),
              1e-12 * disc(Geometry::axisymmetric, 0, 0.02));
  const Eigen::VectorXd own = own_loads(master, Geometry::axisymmetric);
  EXPECT_LT((interface_loads(master, points, true) - own).norm(), 1e-11 * own.norm());
}

TEST(FlatInterface, two_tools_that_meet_between_glass_nodes_share_the_glass_without_seam) {
  for (const auto geometry : geometries)
    for (const double seam : {0.0100, 0.0107, 0.0111, 0.0119}) {
      const auto slave = glass(divided(0, 0.02, 10));
      const auto inner = tool(divided(0, seam, 7)), outer = tool(divided(seam, 0.02, 9));
      const double inside =
          weighted_contact_area(build_interface(contact_surface(0, slave), contact_surface(1, inner),
                                                touching(slave, gap_over(0, seam)), {geometry, width, 0}));
      const double outside =
          weighted_contact_area(build_interface(contact_surface(0, slave), contact_surface(2, outer),
                                                touching(slave, gap_over(seam, 0.02)), {geometry, width, 0}));
      EXPECT_NEAR(inside, disc(geometry, 0, seam), 1e-12 * inside);
      EXPECT_NEAR(outside, disc(geometry, seam, 0.02), 1e-12 * outside);
    }
}

TEST(FlatInterface, gaps_and_overlaps_up_to_a_micrometre_change_nothing_that_matters) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-1, 1);
  for (const auto& [n, m] : mesh_pairs)
    for (double size = 1e-15; size < 2e-6; size *= 10) {
      auto slave = glass(divided(0, 0.02, n));
      auto state = touching(slave);
      for (Index i = 0; i < slave.node_count(); ++i)
        if (slave.nodes[i][1] == 0) slave.nodes[i][1] = state.gap[i] = size * noise(random);
      const auto master = tool(divided(0, 0.02, m));
      const auto points = build_interface(contact_surface(0, slave), contact_surface(1, master), state,
                                          {Geometry::axisymmetric, width, 0});
      const double exact = disc(Geometry::axisymmetric, 0, 0.02);
      EXPECT_NEAR(weighted_contact_area(points), exact, 1e-3 * exact) << n << "/" << m << " " << size;
      for (const double gap : {size, -size}) {
        const auto moved = make_surface(0, glass(divided(0, 0.02, n)), {false, true}, Point(0, gap));
        const auto level =
            build_interface(moved, contact_surface(1, master), touching(slave, [&](const Point&) { return gap; }),
                            {Geometry::axisymmetric, width, 0});
        EXPECT_NEAR(weighted_contact_area(level), exact, 1e-3 * exact);
      }
    }
}

TEST(FlatInterface, a_contact_edge_that_travels_changes_the_area_by_just_what_it_passes) {
  const auto slave = glass(divided(0, 0.02, 10));
  const double rise = 0.05;
  for (double edge = 0.004; edge < 0.012; edge += 1.7e-4) {
    const auto gap = [&](const Point& x) { return rise * (x[0] - edge); };
    const auto master = warped(tool(divided(0, 0.02, 7)), [&](const Point& x) { return Point(x[0], x[1] - gap(x)); });
    const double area = weighted_contact_area(build_interface(contact_surface(0, slave), contact_surface(1, master),
                                                              touching(slave, gap), {Geometry::planar, width, 0}));
    const double exact = edge + 0.5 * width / rise;  // the step's mean is one half
    EXPECT_NEAR(area, exact, 1e-12) << edge;
  }
}

TEST(FlatInterface, beside_a_node_out_of_reach_the_contact_weight_falls_as_the_surfaces_part) {
  for (const double rise : {0.05, 0.3}) {
    const double edge = 0.00913;
    auto columns = divided(0, 0.02, 10);
    const auto height = [&](double x) { return rise * std::max(0.0, x - edge); };
    columns[5] = edge;
    const auto slave =
        warped(glass(columns), [&](const Point& x) { return x[1] == 0 ? Point(x[0], height(x[0])) : x; });
    const auto state = touching(slave, [&](const Point& x) { return x[0] <= edge ? 0 : infinity; });
    const auto master = tool(divided(0, 0.02, 7));
    const auto points =
        build_interface(contact_surface(0, slave), contact_surface(1, master), state, {Geometry::planar, width, 0});
    const double strip = 0.5 * width / rise;
    EXPECT_NEAR(weighted_contact_area(points), edge + strip, 0.1 * strip);
    for (const auto& p : points) {
      EXPECT_TRUE(std::isfinite(p.gap) && p.contact_weight > 0 && p.contact_weight <= 1);
      EXPECT_LT(p.position[0], edge + 1.2 * width / rise);
    }
  }
}

TEST(FlatInterface, the_far_side_of_a_thin_wall_does_not_connect) {
  auto slave = glass(divided(0, 0.02, 10), 1e-4);
  for (auto& edge : slave.edit().boundary_edges) edge.boundary_id = 1;
  const auto master = tool(divided(0, 0.02, 7));
  const auto state = touching(slave, [](const Point& x) { return x[1] - 1e-4; });
  const auto points =
      build_interface(contact_surface(0, slave), contact_surface(1, master), state, {Geometry::planar, width, 0});
  for (const auto& p : points) EXPECT_EQ(p.position[1], 0);
  EXPECT_NEAR(weighted_contact_area(points), 0.02, 1e-14);
}

TEST(FlatInterface, open_gaps_leave_no_interface) {
  const auto slave = glass(divided(0, 0.02, 10)), master = tool(divided(0, 0.02, 7));
  for (const double gap : {1.001 * width, 1e-3, infinity}) {
    const auto lifted = make_surface(0, slave, {false, true}, Point(0, std::min(gap, 0.01)));
    EXPECT_TRUE(build_interface(lifted, contact_surface(1, master), touching(slave, [&](const Point&) { return gap; }),
                                {Geometry::planar, width, 0})
                    .empty());
  }
}

TEST(FlatInterface, tension_between_nodes_never_gives_a_negative_pressure) {
  const auto slave = glass(divided(0, 0.02, 5)), master = tool(divided(0, 0.02, 7));
  auto state = touching(slave);
  for (Index i = 0; i < slave.node_count(); ++i) state.pressure[i] = i % 2 ? -2e5 : 1e5;
  double largest = 0;
  for (const auto& p :
       build_interface(contact_surface(0, slave), contact_surface(1, master), state, {Geometry::planar, width, 0})) {
    EXPECT_GE(p.pressure, 0);
    largest = std::max(largest, p.pressure);
  }
  EXPECT_GT(largest, 0);
}

TEST(ContactWeight, falls_from_one_to_zero_with_continuous_derivative) {
  EXPECT_EQ(contact_weight(-1e-3, width), 1);
  EXPECT_EQ(contact_weight(0, width), 1);
  EXPECT_EQ(contact_weight(width, width), 0);
  EXPECT_EQ(contact_weight(infinity, width), 0);
  EXPECT_DOUBLE_EQ(contact_weight(0.5 * width, width), 0.5);
  EXPECT_LT(1 - contact_weight(width / 50, width), 1e-4);
  double max_bend = 0;
  for (double u = -0.1; u < 1.1; u += 0.01) {
    EXPECT_LE(contact_weight((u + 0.01) * width, width), contact_weight(u * width, width));
    max_bend =
        std::max(max_bend, std::abs(contact_weight((u + 0.01) * width, width) - 2 * contact_weight(u * width, width) +
                                    contact_weight((u - 0.01) * width, width)));
  }
  EXPECT_LT(max_bend, 6e-4);  // the largest second derivative is 5.77
  EXPECT_GT(max_bend, 5e-4);
}

}  // namespace
}  // namespace parison::contact::testing
