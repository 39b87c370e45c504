// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "contact/mortar/projection.hpp"
#include "figure.hpp"
#include "interface_cases.hpp"

namespace parison::contact::testing {
namespace {

using core::Geometry;

/// Height of a roof of three facets; the joints are columns of both meshes.
double facet_height(double x) {
  return x < 0.006 ? 0.5 * x : x < 0.013 ? 0.003 - 0.3 * (x - 0.006) : 0.0009 + 0.9 * (x - 0.013);
}

std::vector<double> facet_columns(int a, int b, int c) {
  auto columns = divided(0, 0.006, a);
  for (const auto& part : {divided(0.006, 0.013, b), divided(0.013, 0.02, c)})
    columns.insert(columns.end(), part.begin() + 1, part.end());
  return columns;
}

core::Mesh lifted(const core::Mesh& mesh, double by = 0) {
  return warped(mesh, [&](const Point& x) { return Point(x[0], x[1] + facet_height(x[0]) + by); });
}

TEST(FacetedInterface, coincident_facets_with_different_nodes_are_as_exact_as_flat_ones) {
  for (const auto geometry : {Geometry::planar, Geometry::axisymmetric}) {
    const auto slave = lifted(glass(facet_columns(5, 3, 4))), master = lifted(tool(facet_columns(2, 7, 3)));
    const auto points =
        build_interface(contact_surface(0, slave), contact_surface(1, master), touching(slave), {geometry, width, 0});
    EXPECT_LT(max_jump(slave, master, points, [](const Point& x) { return 1 + 50 * x[0] - 80 * x[1]; }), 1e-12);
    for (const bool of_master : {false, true}) {
      const auto& mesh = of_master ? master : slave;
      const Eigen::VectorXd own = own_loads(mesh, geometry);
      EXPECT_LT((interface_loads(mesh, points, of_master) - own).norm(), 1e-12 * own.norm());
    }
  }
}

TEST(FacetedInterface, facets_apart_by_up_to_a_micrometre_keep_their_area) {
  for (double apart = 1e-15; apart < 2e-6; apart *= 10)
    for (const double gap : {apart, -apart}) {
      const auto slave = lifted(glass(facet_columns(5, 3, 4)), gap), master = lifted(tool(facet_columns(2, 7, 3)));
      const auto points =
          build_interface(contact_surface(0, slave), contact_surface(1, master),
                          touching(slave, [&](const Point&) { return gap; }), {Geometry::planar, width, 0});
      const double exact = own_loads(slave, Geometry::planar).sum();
      EXPECT_NEAR(weighted_contact_area(points), exact, 1e-3 * exact) << gap;
    }
}

/// Quarter ring: the columns become angles; contact on radius 0.01, glass inside.
core::Mesh quarter(const core::Mesh& flat) {
  return warped(flat, [](const Point& x) -> Point { return (0.01 - x[1]) * Point(std::sin(x[0]), -std::cos(x[0])); });
}

struct ArcResult {
  double area_error, distance;
};

ArcResult arc_result(int slave_edges, int master_edges, Geometry geometry) {
  const auto slave = quarter(glass(divided(0, M_PI / 2, slave_edges))),
             master = quarter(tool(divided(0, M_PI / 2, master_edges)));
  const auto points =
      build_interface(contact_surface(0, slave), contact_surface(1, master), touching(slave), {geometry, width, 0});
  const double exact = geometry == Geometry::planar ? 0.01 * M_PI / 2 : 2 * M_PI * 0.01 * 0.01;
  ArcResult result{std::abs(weighted_contact_area(points) / exact - 1), 0};
  for (const auto& p : points) {
    Point visible = Point::Zero();
    for (int i = 0; i < 3; ++i) visible += p.master_shape[i] * master.nodes[p.master_nodes[i]];
    result.distance = std::max(result.distance, (visible - p.position).norm());
  }
  return result;
}

TEST(CurvedInterface, area_and_distance_between_unlike_arcs_converge_with_order_four) {
  tests::Figure order("interface between unlike arcs: order of its area");
  for (const auto geometry : {Geometry::planar, Geometry::axisymmetric})
    for (const auto& [a, b] : {std::pair{2, 6}, {6, 2}, {3, 3}, {4, 3}}) {
      const auto coarse = arc_result(2 * a, 2 * b, geometry), fine = arc_result(4 * a, 4 * b, geometry);
      std::printf("arcs %d/%d: area error %.2e -> %.2e, distance %.2e -> %.2e m\n", 2 * a, 2 * b, coarse.area_error,
                  fine.area_error, coarse.distance, fine.distance);
      EXPECT_LT(coarse.area_error, 1e-3);
      order.add(std::log2(coarse.area_error / fine.area_error));
      if (a != b) EXPECT_GT(std::log2(coarse.distance / fine.distance), 3.7);
    }
  order.at_least(3.7);
}

TEST(CurvedInterface, unlike_arcs_apart_by_up_to_a_micrometre_keep_their_area) {
  for (const auto& [a, b] : {std::pair{4, 12}, {12, 4}})
    for (double apart = 1e-15; apart < 2e-6; apart *= 10)
      for (const double gap : {apart, -apart}) {
        const auto master = quarter(tool(divided(0, M_PI / 2, b)));
        const auto slave = warped(quarter(glass(divided(0, M_PI / 2, a))),
                                  [&](const Point& x) -> Point { return (1 - gap / 0.01) * x; });
        const auto state = touching(slave, [&](const Point&) { return gap; });
        const double own = own_loads(slave, Geometry::axisymmetric).sum();
        const auto points = build_interface(contact_surface(0, slave), contact_surface(1, master), state,
                                            {Geometry::axisymmetric, width, 0});
        EXPECT_NEAR(weighted_contact_area(points), own, 1e-3 * own) << a << "/" << b << " " << gap;
      }
}

/// With its contact edges straight.
core::Mesh chorded(core::Mesh mesh) {
  for (auto& edge : mesh.edit().boundary_edges)
    mesh.nodes[edge.nodes[2]] = 0.5 * (mesh.nodes[edge.nodes[0]] + mesh.nodes[edge.nodes[1]]);
  return mesh;
}

TEST(CurvedInterface, chords_whose_sagitta_is_wider_than_the_transition_stay_in_contact) {
  for (const auto& [a, b] : {std::pair{6, 18}, {18, 6}, {7, 18}, {10, 10}})
    for (const bool straight_master : {false, true})
      for (const double lift : {0.0, 1e-6, -1e-6}) {
        const auto slave = chorded(quarter(glass(divided(0, M_PI / 2, a))));
        auto master = quarter(tool(divided(0, M_PI / 2, b)));
        if (straight_master) master = chorded(master);
        const auto state = touching(slave, [&](const Point& x) { return 0.01 - x.norm() + lift; });
        const double sagitta = 0.01 * (1 - std::cos(M_PI / 4 / a));
        for (const double transition_gap : {50 * std::abs(lift) + 0.2 * sagitta, 50 * std::abs(lift) + 2 * sagitta}) {
          const auto points = build_interface(contact_surface(0, slave), contact_surface(1, master), state,
                                              {Geometry::planar, transition_gap, 0});
          const double own = own_loads(slave, Geometry::planar).sum();
          EXPECT_NEAR(weighted_contact_area(points), own, 1e-3 * own)
              << a << "/" << b << " " << straight_master << " " << transition_gap / sagitta << " " << lift;
        }
      }
}

TEST(CurvedInterface, the_bulge_of_a_chord_is_its_sagitta) {
  const auto mesh = chorded(quarter(glass(divided(0, M_PI / 2, 12))));
  const auto rays = make_rays(contact_surface(0, mesh));
  const double sagitta = 0.01 * (1 - std::cos(M_PI / 4 / 12));
  for (std::size_t i = 1; i + 1 < rays.size(); ++i) {
    EXPECT_NEAR(chord_offset(rays[i], 0.5) / sagitta, 1, 2e-3);
    EXPECT_EQ(chord_offset(rays[i], 0), 0);
    EXPECT_EQ(chord_offset(rays[i], 1), 0);
  }
  for (const auto& edge : make_rays(contact_surface(0, quarter(glass(divided(0, M_PI / 2, 12))))))
    EXPECT_LT(std::abs(chord_offset(edge, 0.5)), 0.01 * sagitta);
}

/// Chain of straight edges through the given corners, each side in `parts` edges; body on the left.
Surface chain(Index body, const std::vector<Point>& corners, int parts) {
  Surface surface{body, {}};
  Index node = 0;
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (int k = 0; k < parts; ++k) {
      const Point a = corners[i - 1] + (corners[i] - corners[i - 1]) * k / parts;
      const Point b = corners[i - 1] + (corners[i] - corners[i - 1]) * (k + 1) / parts;
      surface.edges.push_back({{node, node + 2, node + 1}, {a, b, 0.5 * (a + b)}});
      node += 2;
    }
  return surface;
}

double length_of(const std::vector<Point>& corners) {
  double sum = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) sum += (corners[i] - corners[i - 1]).norm();
  return sum;
}

SlaveState closed_state(const Surface& surface) {
  const Index count = surface.edges.back().nodes[1] + 1;
  return {Eigen::VectorXd::Zero(count), Eigen::VectorXd::Constant(count, 1e5)};
}

/// Largest deviation of a slave edge's closed share from one.
double coverage_error(const Surface& slave, const std::vector<core::InterfacePoint>& points) {
  std::map<Index, double> covered;
  for (const auto& p : points) covered[p.slave_nodes[2]] += p.area * p.contact_weight;
  double error = 0;
  for (const auto& edge : slave.edges)
    error = std::max(error, std::abs(covered[edge.nodes[2]] / (edge.x[1] - edge.x[0]).norm() - 1));
  return error;
}

TEST(KinkedInterface, every_slave_edge_is_covered_once_round_corners_that_stick_out_and_in) {
  for (const double angle : {-100.0, -90.0, -45.0, -20.0, 20.0, 45.0, 90.0, 100.0})
    for (const auto& [n, m] : {std::pair{3, 5}, {5, 3}, {1, 4}, {4, 1}}) {
      const double turn = angle * M_PI / 180;
      const Point corner(0, 0), before(-0.01, 0), after = 0.01 * Point(std::cos(turn), std::sin(turn));
      const Surface master = chain(1, {before, corner, after}, m), slave = chain(0, {after, corner, before}, n);
      const auto points = build_interface(slave, master, closed_state(slave), {Geometry::planar, width, 0});
      EXPECT_LT(coverage_error(slave, points), 1e-12) << angle << " " << n << "/" << m;
    }
}

TEST(KinkedInterface, glass_that_cuts_across_or_rounds_a_corner_is_covered_once) {
  for (const double angle : {-90.0, -60.0, -30.0, 30.0, 60.0, 90.0})
    for (const double cut : {1e-9, 1e-6, 2e-5, 5e-4}) {
      if (cut > width && angle < 0) continue;  // glass that rounds a re-entrant corner so widely does not touch it
      const double turn = angle * M_PI / 180;
      const Point corner(0, 0), before(-0.01, 0), along(std::cos(turn), std::sin(turn));
      const Surface master = chain(1, {before, corner, 0.01 * along}, 3);
      const std::vector<Point> across{0.008 * along, cut * along, Point(-cut, 0), Point(-0.008, 0)};
      const Surface slave = chain(0, across, 3);
      auto state = closed_state(slave);
      state.gap.setConstant(cut > width ? -cut : 0);
      const auto points = build_interface(slave, master, state, {Geometry::planar, width, 0});
      EXPECT_LT(coverage_error(slave, points), 1e-12) << angle << " " << cut;
      EXPECT_NEAR(weighted_contact_area(points), length_of(across), 1e-14) << angle << " " << cut;
    }
}

TEST(KinkedInterface, neighbouring_slave_points_see_neighbouring_master_points_across_kinks_and_overlaps) {
  const std::vector<Point> corners{{-0.01, 0.002}, {-0.003, 0}, {0.004, 0.003}, {0.01, 0}};
  const Surface master = chain(1, corners, 7);
  for (const double gap : {3e-4, -3e-4}) {
    std::vector<Point> moved;
    for (auto corner = corners.rbegin(); corner != corners.rend(); ++corner) moved.push_back(*corner + Point(0, gap));
    const Surface slave = chain(0, moved, 9);
    auto state = closed_state(slave);
    state.gap.setConstant(-std::abs(gap));
    const auto points = build_interface(slave, master, state, {Geometry::planar, width, 0});
    std::vector<Point> seen;
    for (const auto& p : points) {
      seen.push_back(Point::Zero());
      for (const auto& edge : master.edges)
        if (edge.nodes == p.master_nodes)
          for (int i = 0; i < 3; ++i) seen.back() += p.master_shape[i] * edge.x[i];
    }
    ASSERT_GT(points.size(), 100u);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Point along = points[i].position - points[i - 1].position;
      const double ratio = (seen[i] - seen[i - 1]).dot(along) / along.squaredNorm();
      EXPECT_GT(ratio, 0.4) << gap << ": " << points[i].position.transpose();
      EXPECT_LT(ratio, 1.6) << gap << ": " << points[i].position.transpose();
    }
  }
}

TEST(KinkedInterface, a_tool_corner_between_two_glass_nodes_splits_the_edge) {
  const Surface master = chain(1, {{-0.01, -0.0004}, {0.0007, 0}, {0.01, -0.0005}}, 2);
  const Surface slave = chain(0, {{0.008, 0}, {-0.008, 0}}, 4);
  const auto points = build_interface(slave, master, closed_state(slave), {Geometry::planar, width, 0});
  EXPECT_LT(coverage_error(slave, points), 1e-12);
  for (const auto& p : points) {
    const Index side = p.position[0] < 0.0007 ? 0 : 1;
    EXPECT_EQ(p.master_nodes[0] / 4, side) << p.position[0];
  }
}

}  // namespace
}  // namespace parison::contact::testing
