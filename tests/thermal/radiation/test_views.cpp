// SPDX-License-Identifier: GPL-3.0-or-later
// View factors by rays against exact ones, and the radiosity of a cavity.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstdio>

#include "figure.hpp"
#include "thermal/radiation/view_sections.hpp"

namespace parison::thermal::test {
namespace {

constexpr auto round_section = core::Geometry::axisymmetric;
constexpr int many_rays = 400000;

/// View factors between the surfaces, as traced and closed.
Eigen::MatrixXd traced(const std::vector<Surface>& surfaces, core::Geometry geometry = round_section) {
  const auto edges = view_edges(surfaces, geometry);
  const Eigen::ArrayXd area = areas(edges, surfaces.size());
  const Views views = trace_views(edges, geometry, static_cast<Index>(surfaces.size()), many_rays);
  return area.inverse().matrix().asDiagonal() * closed(views, area).between;
}

void compare(tests::Figure& off, const char* what, double found, double exact) {
  std::printf("%s: %.5f, exact %.5f\n", what, found, exact);
  off.add(100 * std::abs(found / exact - 1));
}

/// The air between two discs, of the radii r1 below and r2 at z = h, and the frustum that joins them.
std::vector<Surface> frustum(double r1, double r2, double h) {
  return {{{0, 0}, {r1, 0}}, {{r2, h}, {0, h}}, {{r1, 0}, {r2, h}}};
}

TEST(Views, coaxial_discs_frusta_and_cylinders_see_each_other_as_the_exact_factors_say) {
  tests::Figure discs("views: coaxial discs, exact factors: off by", "%"),
      sides("views: disc and cylinder, disc and frustum, exact factors: off by", "%"),
      own("views: cylinder and frustum to themselves, exact factors: off by", "%");
  for (const auto& [r1, r2, h] : {std::array{1.0, 1.0, 1.0}, {1.0, 1.0, 4.0}, {1.0, 2.0, 1.5}, {2.0, 0.5, 1.0}}) {
    const auto surfaces = frustum(r1, r2, h);
    const Eigen::MatrixXd found = traced(surfaces);
    const auto area = areas(view_edges(surfaces, round_section), 3);
    const double there = disc_to_disc(r1, r2, h), back = disc_to_disc(r2, r1, h);
    const double below = (1 - there) * area[0] / area[2], above = (1 - back) * area[1] / area[2];
    compare(discs, "disc to disc", found(0, 1), there);
    compare(sides, "disc to side", found(0, 2), 1 - there);
    compare(sides, "side to disc", found(2, 1), above);
    compare(own, "side to itself", found(2, 2), 1 - below - above);
  }
  discs.at_most(0.1);
  sides.at_most(0.1);
  own.at_most(0.1);
}

TEST(Views, a_plunger_shadows_what_is_behind_it) {
  tests::Figure off("views: tube around a plunger that shadows, exact factors: off by", "%");
  for (const auto& [inner, outer, length] : {std::array{1.0, 2.0, 3.0}, {1.0, 1.3, 2.0}, {0.2, 1.0, 2.0}}) {
    const std::vector<Surface> surfaces{{{outer, 0}, {outer, length}}, {{inner, length}, {inner, 0}}};
    const Eigen::MatrixXd found = traced(surfaces);
    compare(off, "tube to plunger", found(0, 1), outer_to_inner(inner, outer, length));
    compare(off, "tube to itself", found(0, 0), outer_to_itself(inner, outer, length));
  }
  off.at_most(0.1);
}

TEST(Views, of_a_planar_section_strips_see_each_other_as_crossed_strings_say) {
  const double width = 2, gap = 1;
  const std::vector<Surface> surfaces{{{0, 0}, {width, 0}}, {{width, gap}, {0, gap}}};
  tests::Figure off("views: two parallel strips, exact factor: off by", "%");
  compare(off, "strip to strip", traced(surfaces, core::Geometry::planar)(0, 1),
          std::hypot(1, gap / width) - gap / width);
  off.at_most(0.1);
}

TEST(Views, closed_views_are_reciprocal_and_their_rows_have_the_areas_as_sums) {
  const auto surfaces = std::vector<Surface>{
      {{0, 0}, {0.5, 0}}, {{0.5, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {1, 2}}, {{0.6, 1.5}, {0.2, 1}}};
  const auto edges = view_edges(surfaces, round_section, 7);
  Eigen::ArrayXd area = areas(edges, surfaces.size());
  area[3] *= 0.8;  // covered since the views were traced
  for (const int rays : {40, 400}) {
    const Views raw = trace_views(edges, round_section, 5, rays), views = closed(raw, area);
    tests::expect_at_most(fmt::format("closed views from {} rays: A_i F_ij against A_j F_ji: off by", rays),
                          (views.between - views.between.transpose()).norm(), 1e-12);
    const Eigen::ArrayXd sum = views.between.rowwise().sum().array() + views.open.array();
    tests::expect_at_most(fmt::format("closed views from {} rays: sums of the rows off from the areas by", rays),
                          ((sum - area) / area).abs().maxCoeff(), 1e-12);
    EXPECT_GE(views.between.minCoeff(), -1e-12);
    EXPECT_GT((raw.between - views.between).norm(), 1e-4);
  }
}

/// Area whose rays are lost, of all, of a rod in a tube with a thick wall, the rod moved to a radius and turned inside
/// out on request; without the outer face the outline of the tube is open.
double lost_beside_a_rod(double rod, bool inside_out, bool open) {
  std::vector<Surface> surfaces{{{1, 0}, {1, 2}}, {{1.5, 0}, {1, 0}}, {{1, 2}, {1.5, 2}}, {{1.5, 2}, {1.5, 0}}};
  if (open) surfaces.erase(surfaces.begin());
  const std::vector<Surface> faces{{{rod, 2}, {rod, 0}}, {{rod, 0}, {0, 0}}, {{0, 2}, {rod, 2}}};
  for (const Surface& face : faces) surfaces.push_back(inside_out ? Surface{face.to, face.from} : face);
  const auto edges = view_edges(surfaces, round_section, 20);
  const Views views = trace_views(edges, round_section, static_cast<Index>(surfaces.size()), 2000);
  return views.lost.sum() / areas(edges, surfaces.size()).sum();
}

TEST(Views, rays_are_lost_where_an_outline_is_open_or_inside_out_and_not_where_bodies_overlap) {
  EXPECT_EQ(lost_beside_a_rod(0.5, false, false), 0);
  EXPECT_LT(lost_beside_a_rod(1.2, false, false), 2e-3) << "a rod that overlaps the tube";
  EXPECT_GT(lost_beside_a_rod(0.5, true, false), 0.02) << "a rod inside out";
  EXPECT_GT(lost_beside_a_rod(0.5, false, true), 0.02) << "a tube without its inner face";
}

TEST(Views, a_patch_that_sees_less_than_its_area_sees_itself_for_the_rest) {
  Views views{Eigen::MatrixXd::Zero(3, 3), Eigen::Vector3d(0, 0, 0.1), Eigen::Vector3d::Zero()};
  views.between(0, 1) = views.between(1, 0) = 1;
  const Views made = closed(views, Eigen::Array3d(2, 1, 0.5));
  EXPECT_NEAR(made.between.row(0).sum(), 2, 1e-12);
  EXPECT_NEAR(made.between.row(1).sum(), 1, 1e-12);
  EXPECT_NEAR(made.between(2, 2) + made.open[2], 0.5, 1e-12);
  EXPECT_GT(made.between(0, 0), 0.5);
  EXPECT_NEAR(made.between(0, 1), made.between(1, 0), 1e-15);
}

/// Radiosities of an isothermal grey cavity, of its emissive power, from exchange areas.
double mouth_emissivity(const Eigen::MatrixXd& between, const Eigen::ArrayXd& open, const Eigen::ArrayXd& area,
                        double emissivity) {
  Eigen::MatrixXd matrix = -(1 - emissivity) * between;
  matrix.diagonal().array() += area;
  const Eigen::VectorXd J = matrix.partialPivLu().solve((emissivity * area).matrix());
  return (open * J.array()).sum() / M_PI;
}

/// The same of a tube of radius 1 and length 4 with one end closed, by exact factors of many rings.
double reference_mouth(double emissivity, int across, int along) {
  const double length = 4;
  const int count = across + along;
  // Exchange areas over the mouth and between rings are second differences of those between discs.
  const auto disc = [&](int i) { return static_cast<double>(i) / across; };
  const auto z = [&](int i) { return length * i / along; };
  const auto through = [&](double a, double za, double b, double zb) {
    return zb > za ? M_PI * ring_to_ring(a, b, zb - za) : M_PI * std::pow(std::min(a, b), 2);
  };
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(count, count);
  Eigen::ArrayXd open(count), area(count);
  for (int i = 0; i < across; ++i) {
    const auto to_plane = [&](double height) {
      return through(disc(i + 1), 0, 1, height) - through(disc(i), 0, 1, height);
    };
    open[i] = to_plane(length);
    area[i] = M_PI * (std::pow(disc(i + 1), 2) - std::pow(disc(i), 2));
    for (int j = 0; j < along; ++j) K(i, across + j) = K(across + j, i) = to_plane(z(j)) - to_plane(z(j + 1));
  }
  for (int j = 0; j < along; ++j) {
    area[across + j] = 2 * M_PI * length / along;
    open[across + j] = through(1, z(j + 1), 1, length) - through(1, z(j), 1, length);
    for (int k = 0; k < along; ++k) {
      const auto planes = [&](double a, double b) { return through(1, std::min(a, b), 1, std::max(a, b)); };
      K(across + j, across + k) = j == k ? area[across + j] - 2 * (M_PI - planes(z(j), z(j + 1)))
                                         : std::abs(planes(z(j), z(k)) - planes(z(j), z(k + 1)) -
                                                    planes(z(j + 1), z(k)) + planes(z(j + 1), z(k + 1)));
    }
  }
  return mouth_emissivity(K, open, area, emissivity);
}

TEST(Views, the_mouth_of_a_tube_with_a_closed_end_looks_as_black_as_its_exact_rings_say) {
  tests::Figure off("cavity of a tube two diameters long, one end closed, emissivity 0.3 to 0.9: mouth off by", "%");
  std::vector<Surface> surfaces;
  for (int i = 0; i < 6; ++i) surfaces.push_back({{i / 6.0, 0}, {(i + 1) / 6.0, 0}});
  for (int i = 0; i < 18; ++i) surfaces.push_back({{1, i * 4 / 18.0}, {1, (i + 1) * 4 / 18.0}});
  const auto edges = view_edges(surfaces, round_section, 4);
  const Eigen::ArrayXd area = areas(edges, surfaces.size());
  const Views views = closed(trace_views(edges, round_section, 24, 64), area);  // as few rays as a run has
  for (const double emissivity : {0.3, 0.5, 0.7, 0.9}) {
    const double exact = reference_mouth(emissivity, 60, 240);
    EXPECT_NEAR(reference_mouth(emissivity, 30, 120) / exact, 1, 5e-4);
    compare(off, "mouth", mouth_emissivity(views.between, views.open.array(), area, emissivity), exact);
  }
  off.at_most(0.5);
}

}  // namespace
}  // namespace parison::thermal::test
