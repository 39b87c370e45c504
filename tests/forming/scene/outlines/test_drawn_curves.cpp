// SPDX-License-Identifier: GPL-3.0-or-later
// Splines, ellipses and circles of DXF drawings, each against an area that is known otherwise.
#include <gtest/gtest.h>

#include "dxf_writer.hpp"

namespace parison::tests {
namespace {

const std::string mm = "unit = \"mm\", ";
using Curve = std::function<Point(double)>;

/// A cubic over 0 to 1 with given ends and directions there, as long as its chord.
Curve hermite(const Point& a, const Point& b, const Point& first, const Point& last) {
  const double length = (b - a).norm();
  return [=](double t) -> Point {
    const double s = 1 - t;
    return s * s * (1 + 2 * t) * a + t * t * (1 + 2 * s) * b +
           length * (s * s * t * first.normalized() - t * t * s * last.normalized());
  };
}

void write_fit_spline(DxfWriter& writer, const std::vector<Point>& points, int flags, const Point& first,
                      const Point& last) {
  writer.begin("SPLINE");
  writer.group(70, std::to_string(flags));
  writer.group(71, "3");
  writer.group(74, std::to_string(points.size()));
  if (first.norm() > 0) writer.place(12, first);
  if (last.norm() > 0) writer.place(13, last);
  for (const Point& x : points) writer.place(11, x);
}

TEST(DrawnCurves, splines_through_points_keep_their_end_tangents) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-0.4, 0.4);
  for (int i = 0; i < 20; ++i) {
    const Outline outline = random_outline(random, false);
    DxfWriter writer;
    double area = area_of(outline);
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Point &a = outline[k].x, &b = outline[(k + 1) % outline.size()].x, along = b - a;
      const Point left(-along[1], along[0]), first = along + part(random) * left, last = along + part(random) * left;
      write_fit_spline(writer, {a, b}, 8, first, last);
      area += area_of_curve(hermite(a, b, first, last));
    }
    const Taken taken = take("a.dxf", dxf_of(writer.text), mm + from(outline[0].x));
    ASSERT_EQ(taken.refusal, "");
    EXPECT_NEAR(taken.area / area, 1, 1e-5);
  }
}

/// A rectangle whose right side is a spline through (30, 0), (40, 20) and (30, 40).
Taken with_right_side(const std::vector<Point>& points, const Point& first, const Point& last) {
  DxfWriter writer;
  write_fit_spline(writer, points, 8, first, last);
  writer.line({30, 40}, {10, 40});
  writer.line({10, 40}, {10, 0});
  writer.line({10, 0}, {30, 0});
  return take("a.dxf", dxf_of(writer.text), mm + from({10, 0}));
}

TEST(DrawnCurves, a_repeated_point_of_a_spline_counts_once) {
  const Point low(30, 0), out(40, 20), high(30, 40), none(0, 0);
  // By hand: 800 + 2 (130 + 33.54), the cubics' slopes 1 and -1 along r at the ends.
  EXPECT_NEAR(with_right_side({low, out, high}, {1, 0}, {-2, 0}).area, 1127.082, 0.01);
  EXPECT_NEAR(with_right_side({low, low, out, out, high}, {1, 0}, {-1, 0}).area, 1127.082, 0.01);
  const double free_ends = with_right_side({low, out, high}, none, none).area;
  EXPECT_NEAR(free_ends, 1066.667, 0.01);
  EXPECT_NEAR(with_right_side({low, out, out, high, high}, none, none).area, free_ends, 1e-9);
}

TEST(DrawnCurves, a_closed_spline_goes_on_smoothly_from_its_last_point_to_its_first) {
  for (const bool repeats : {false, true}) {
    std::vector<Point> points;
    constexpr int count = 12;
    for (int i = 0; i < count + repeats; ++i)
      points.emplace_back(40 + 20 * std::cos(2 * M_PI * i / count), 50 + 20 * std::sin(2 * M_PI * i / count));
    DxfWriter writer;
    write_fit_spline(writer, points, 11, {0, 0}, {0, 0});
    const Taken taken = take("a.dxf", dxf_of(writer.text), mm + from({60, 50}));
    EXPECT_EQ(taken.refusal, "");
    EXPECT_NEAR(taken.area / (M_PI * 400), 1, 4e-4);  // of the spline; with a chord 0.011 less
  }
}

/// Sides of an outline as splines by control points: lines of degree 1, arcs as rational ones of degree 2.
void write_control_splines(DxfWriter& writer, const Outline& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i].x, &b = outline[(i + 1) % outline.size()].x, along = b - a;
    const double bulge = outline[i].bulge, half = 2 * std::atan(bulge);
    const bool is_arc = bulge != 0;
    writer.begin("SPLINE");
    writer.group(70, is_arc ? "12" : "8");
    writer.group(71, is_arc ? "2" : "1");
    for (const double knot : is_arc ? std::vector<double>{3, 3, 3, 7, 7, 7} : std::vector<double>{-1, -1, 4, 4})
      writer.group(40, knot);
    if (is_arc)
      for (const double weight : {1.0, std::cos(half), 1.0}) writer.group(41, weight);
    writer.place(10, a);
    // The arc lies on the right of the chord for a positive bulge; its tangents meet there.
    if (is_arc) writer.place(10, 0.5 * (a + b) + 0.5 * std::tan(half) * Point(along[1], -along[0]));
    writer.place(10, b);
  }
}

TEST(DrawnCurves, splines_by_control_points_and_weights) {
  expect_areas([](const Outline& outline, std::mt19937&) {
    DxfWriter writer;
    write_control_splines(writer, outline);
    return take("a.dxf", dxf_of(writer.text), mm + from(outline[0].x));
  });
}

TEST(DrawnCurves, a_closed_spline_whose_ends_do_not_meet_is_refused) {
  DxfWriter writer;
  writer.begin("SPLINE");
  writer.group(70, "9");
  writer.group(71, "1");
  for (const char* knot : {"0", "0", "1", "2", "2"}) writer.group(40, knot);
  for (const Point& x : {Point(10, 0), Point(30, 0), Point(30, 20)}) writer.place(10, x);
  EXPECT_NE(take("a.dxf", dxf_of(writer.text), mm + from({10, 0})).refusal.find("says it is closed"),
            std::string::npos);
}

TEST(DrawnCurves, halves_of_ellipses_seen_from_both_sides) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0.05, 0.5);
  for (const bool from_behind : {false, true})
    for (int i = 0; i < 10; ++i) {
      const Outline outline = random_outline(random, false);
      DxfWriter writer;
      writer.from_behind = from_behind;
      double area = area_of(outline);
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const Point &a = outline[k].x, &b = outline[(k + 1) % outline.size()].x, half = 0.5 * (b - a);
        const double ratio = part(random);
        const bool outwards = random() % 2;
        writer.begin("ELLIPSE");
        writer.place(10, 0.5 * (a + b));
        writer.place(11, half);
        writer.group(40, ratio);
        // Counterclockwise from b to a over the left of the chord, the inside; from behind the other way.
        const bool upper = outwards == from_behind;
        writer.group(41, upper ? 0 : M_PI);
        writer.group(42, upper ? M_PI : 2 * M_PI);
        area += (outwards ? 0.5 : -0.5) * M_PI * ratio * half.squaredNorm();
      }
      const Taken taken = take("a.dxf", dxf_of(writer.text), mm + from(outline[0].x));
      ASSERT_EQ(taken.refusal, "");
      EXPECT_NEAR(taken.area / area, 1, 1e-5);
    }
}

TEST(DrawnCurves, arcs_of_any_angles_and_whole_circles) {
  for (const auto& [start, end] : {std::pair{0.0, 360.0},
                                   {90.0, 450.0},
                                   {-180.0, 180.0},
                                   {725.0, 5.0},
                                   {30.0, 30.0},
                                   {0.0, 360.0001},
                                   {0.0, 359.9999}}) {
    DxfWriter writer;
    writer.begin("ARC");
    writer.place(10, {50, 20});
    writer.group(40, 10.0);
    writer.group(50, start);
    writer.group(51, end);
    const double angle = start * M_PI / 180;
    const Taken taken =
        take("a.dxf", dxf_of(writer.text), mm + from({50 + 10 * std::cos(angle), 20 + 10 * std::sin(angle)}));
    EXPECT_EQ(taken.refusal, "") << start << " to " << end;
    EXPECT_NEAR(taken.area, 100 * M_PI, 1e-3) << start << " to " << end;
  }
  DxfWriter writer;  // three quarters of a circle beyond a turn, closed by two lines
  writer.begin("ARC");
  writer.place(10, {50, 20});
  writer.group(40, 10.0);
  writer.group(50, 400.0);
  writer.group(51, 670.0);
  const auto on_circle = [](double degrees) {
    return Point(50 + 10 * std::cos(degrees * M_PI / 180), 20 + 10 * std::sin(degrees * M_PI / 180));
  };
  writer.line(on_circle(310), {50, 20});
  writer.line({50, 20}, on_circle(40));
  EXPECT_NEAR(take("a.dxf", dxf_of(writer.text), mm + from(on_circle(40))).area, 75 * M_PI, 1e-6);
}

}  // namespace
}  // namespace parison::tests
