// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstdio>
#include <random>

#include "contact/unilateral/tool_constraints.hpp"
#include "contact/unilateral/tool_gap.hpp"
#include "tool_outlines.hpp"

namespace parison::contact::testing {
namespace {

constexpr double reach = 2e-3;
constexpr double spacing = 2e-6;
constexpr double min_radius = 7e-3;

/// Points along the contact boundaries, `spacing` apart at most.
std::vector<Point> sampled(const Outline& outline) {
  std::vector<Point> points;
  for (const auto& segment : outline.profile.segments)
    if (outline.contact[segment.boundary_id]) {
      const int count = static_cast<int>(std::ceil(core::length(segment) / spacing));
      for (int i = 0; i <= count; ++i) points.push_back(core::point_at(segment, double(i) / count));
    }
  return points;
}

struct Nearest {
  double distance;
  bool at_an_end;  ///< of the contact boundaries
};

Nearest brute_force(const std::vector<Point>& points, const Point& x) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if ((points[i] - x).squaredNorm() < (points[best] - x).squaredNorm()) best = i;
  return {(points[best] - x).norm(), best < 2 || best + 2 >= points.size()};
}

/// Random points within `off` of the contact boundaries, none beyond the axis; the same with every compiler.
std::vector<Point> points_near(const std::vector<Point>& surface, int count, double off) {
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> place(0, surface.size() - 1);
  std::uniform_real_distribution<double> offset(-off, off);
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < count) {
    const double z = offset(random), r = offset(random);
    const Point x = surface[place(random)] + Point(r, z);
    if (x[0] >= 0) points.push_back(x);
  }
  return points;
}

/// Shortest move that brings the first gap to zero and leaves none negative.
Point shortest_move(const std::vector<GapConstraint>& found) {
  const Point move = -found[0].gap * found[0].normal;
  if (found.size() < 2 || found[1].gap + found[1].normal.dot(move) >= 0) return move;
  core::Tensor normals;
  normals << found[0].normal.transpose(), found[1].normal.transpose();
  return normals.inverse() * Point(-found[0].gap, -found[1].gap);
}

void expect_brute_force_agrees(const Outline& outline) {
  const auto surface = sampled(outline);
  int compared = 0;
  double largest = 0;
  for (const Point& x : points_near(surface, 1500, 1.5e-3)) {
    const Nearest nearest = brute_force(surface, x);
    if (nearest.at_an_end || nearest.distance > 0.99 * reach) continue;
    const bool inside = core::contains(outline.profile, x);
    const auto found = ToolConstraints(outline.profile, outline.contact)(x, reach);
    ASSERT_FALSE(found.empty()) << x.transpose();
    // A sample lies at most half a spacing h beside the foot: d^2 = gap^2 + (1 + gap/R) h^2/4 where an arc bends away.
    const double d = nearest.distance, beside = (1 + reach / min_radius) * spacing * spacing / 4;
    const double sampling = 1e-12 + d - std::sqrt(std::max(0.0, d * d - beside));
    const double expected = inside ? -nearest.distance : nearest.distance;
    const double measured = inside ? -shortest_move(found).norm() : found[0].gap;
    largest = std::max(largest, std::abs(measured - expected));
    EXPECT_NEAR(measured, expected, sampling) << x.transpose();
    const double gap = signed_gap(outline.profile, outline.contact, x);
    EXPECT_NEAR(gap, expected, sampling);
    for (const double visible : {0.5 * reach, reach}) {
      const double within = std::abs(gap) < visible ? gap : std::numeric_limits<double>::infinity();
      EXPECT_EQ(ToolGap(outline.profile, outline.contact, visible)(x), within) << x.transpose();
    }
    ++compared;
  }
  std::printf("%d points, largest difference from sampling %.1e m\n", compared, largest);
  EXPECT_GT(compared, 1000);
}

TEST(JarGaps, agree_with_the_sampled_blank) {
  expect_brute_force_agrees(blank());
}
TEST(JarGaps, agree_with_the_sampled_plunger) {
  expect_brute_force_agrees(plunger(20));
}
TEST(JarGaps, agree_with_the_sampled_plunger_at_the_end_of_its_stroke) {
  expect_brute_force_agrees(plunger(92));
}
TEST(JarGaps, agree_with_the_sampled_blow_mould) {
  expect_brute_force_agrees(blow_mould());
}

TEST(JarGaps, taking_the_constraints_to_zero_puts_the_point_on_the_tool) {
  for (const Outline& outline : {blank(), plunger(20), blow_mould()})
    for (const Point& x : points_near(sampled(outline), 2000, 1.5e-3)) {
      const auto found = ToolConstraints(outline.profile, outline.contact)(x, reach);
      for (const auto& c : found) EXPECT_NEAR(c.normal.norm(), 1, 1e-14);
      if (found.empty()) continue;
      const Point on = x + shortest_move(found);
      EXPECT_NEAR(core::distance(outline.profile, on), 0, 1e-14) << x.transpose();
    }
}

TEST(JarGaps, points_on_the_surface_have_one_gap_of_round_off_size) {
  for (const Outline& outline : {blank(), plunger(20), plunger(92)})
    for (const Point& x : sampled(outline)) {
      const auto found = ToolConstraints(outline.profile, outline.contact)(x, 1e-4);
      ASSERT_EQ(found.size(), 1u) << x.transpose();
      ASSERT_NEAR(found[0].gap, 0, 1e-15) << x.transpose();
    }
}

}  // namespace
}  // namespace parison::contact::testing
