// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth curves through points, and splines and ellipses of STEP drawings, as arcs with common tangents.
#include <gmsh.h>
#include <gtest/gtest.h>

#include <cmath>

#include "curved_blank.hpp"
#include "forming/scene/read/curves/curve_arcs.hpp"

namespace parison::forming {
namespace {

constexpr double tolerance = 1e-6;  // m

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

}  // namespace
}  // namespace parison::forming
