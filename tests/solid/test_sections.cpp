// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "contact/solid/section_surface.hpp"
#include "core/solid/section_table.hpp"
#include "figure.hpp"

namespace parison {

namespace {

using core::Vector3;

constexpr double mm = 1e-3;

/// A block from -10 to 10 mm around a hole of 20 mm half width, as a tool of revolution.
core::Profile ring_with_hole() {
  core::Profile profile;
  profile.boundary_names = {"hole", "rest"};
  const core::Point corner[] = {{20 * mm, 10 * mm}, {20 * mm, -10 * mm}, {60 * mm, -10 * mm}, {60 * mm, 10 * mm}};
  for (int i = 0; i < 4; ++i) {
    core::Segment segment;
    segment.start = corner[i];
    segment.end = corner[(i + 1) % 4];
    segment.boundary_id = i == 0 ? 0 : 1;
    profile.segments.push_back(segment);
  }
  return profile;
}

core::SectionFamily square_with(double corner_over_width) {
  core::SectionFamily family;
  family.corner = core::constant(corner_over_width);
  return family;
}

/// Area of a section over that of its circle, by turning a ray.
double area_by_rays(const core::SectionFamily& family) {
  constexpr int rays = 20000;
  double sum = 0;
  for (int i = 0; i < rays; ++i) {
    const double border = core::reach(family, {1, 0}, 2 * M_PI * (i + 0.5) / rays);
    sum += border * border / rays;
  }
  return sum;
}

TEST(Sections, areas_are_those_of_their_borders) {
  tests::Figure off("area of a section against that by rays");
  for (const double corner : {0.1, 0.4, 1.0}) {
    core::SectionFamily family = square_with(corner);
    off.add(std::abs(core::area_factor(family, 0) / area_by_rays(family) - 1));
    family.depth = core::constant(1.6);
    off.add(std::abs(core::area_factor(family, 0) / area_by_rays(family) - 1));
  }
  for (const double n : {2.0, 2.5, 6.0}) {
    core::SectionFamily family;
    family.exponent = core::constant(n);
    family.depth = core::constant(0.5);
    off.add(std::abs(core::area_factor(family, 0) / area_by_rays(family) - 1));
  }
  off.at_most(1e-6);
}

TEST(Sections, gradients_are_those_of_differences) {
  core::SectionFamily rounded{{{0, 10 * mm}, {1, 0.7}}, {{0, 10 * mm}, {0.6, 0.3}}, {}};
  core::SectionFamily superellipse{{{0, 10 * mm}, {1, 0.7}}, {}, {{0, 10 * mm}, {2.2, 5}}};
  tests::Figure off("gradient of the half width against differences");
  for (const auto& family : {rounded, superellipse})
    for (const Vector3& at : {Vector3(9, 3, 4), Vector3(-6, 5, 2), Vector3(2, -8, 7)}) {
      const Vector3 gradient = core::half_width(family, mm * at).gradient;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3 apart = 1e-6 * Vector3::Unit(axis);
        const double difference =
            (core::half_width_value(family, mm * at + apart) - core::half_width_value(family, mm * at - apart)) / 2e-6;
        off.add(std::abs(gradient[axis] - difference));
        EXPECT_GT(std::abs(gradient.norm()), 0.5);
      }
    }
  off.at_most(1e-5);
}

/// A square cavity that widens, with a round dome in its base, which begins at 6 mm.
core::MeasuredSections square_with_dome() {
  constexpr int rows = 90;
  const auto table = [&](double from, double to, double at_from, double at_to, bool is_square) {
    std::vector<double> heights;
    Eigen::MatrixXd reach(rows + 1, 9);
    for (int i = 0; i < 9; ++i) {
      heights.push_back(from + (to - from) * i / 8);
      for (int row = 0; row <= rows; ++row) {
        const double angle = M_PI_2 * row / rows, corner = is_square ? 1 + 0.2 * std::pow(std::sin(2 * angle), 2) : 1;
        reach(row, i) = corner * (at_from + (at_to - at_from) * i / 8);
      }
    }
    return core::ReachTable(heights, reach);
  };
  return {table(0, 10 * mm, 20 * mm, 24 * mm, true), table(6 * mm, 10 * mm, 2 * mm, 9 * mm, false)};
}

TEST(Sections, measured_half_widths_are_those_that_lead_back_to_their_places) {
  const core::MeasuredSections measured = square_with_dome();
  tests::Figure back("half width of the place to which a half width leads, m");
  tests::Figure off("gradient of a measured half width against differences");
  core::SectionFamily family;
  family.measured = std::make_shared<core::MeasuredSections>(measured);
  for (const double height : {1.3 * mm, 6.7 * mm, 9.1 * mm, 13 * mm})
    for (const double width : {1 * mm, 5 * mm, 15 * mm, 25 * mm})
      for (const double angle : {0.1, 0.7, 1.4}) {
        const double far = measured.far(width, height, angle);
        back.add(std::abs(measured.half_width(far, height, angle).value - width));
        const Vector3 at(-far * std::cos(angle), far * std::sin(angle), height);
        const Vector3 gradient = core::half_width(family, at).gradient;
        for (int axis = 0; axis < 2; ++axis) {
          const Vector3 apart = 1e-7 * Vector3::Unit(axis);
          off.add(std::abs(gradient[axis] -
                           (core::half_width_value(family, at + apart) - core::half_width_value(family, at - apart)) /
                               2e-7));
        }
      }
  back.at_most(1e-15);
  off.at_most(1e-6);
}

TEST(Sections, the_dome_of_a_measured_base_is_round_and_goes_on_below_it) {
  const core::MeasuredSections measured = square_with_dome();
  const double high = 10 * mm;
  EXPECT_NEAR(measured.far(5 * mm, high, M_PI_4), 5 * mm, 1e-15);
  EXPECT_NEAR(measured.far(24 * mm, high, M_PI_4), 1.2 * 24 * mm, 1e-15);
  for (const double width : {5 * mm, 15 * mm, 24 * mm, 30 * mm})
    EXPECT_NEAR(measured.far(width, high, 0.6), measured.far(width, 2 * high, 0.6), 1e-15);
  EXPECT_NEAR(measured.far(1 * mm, 5 * mm, M_PI_4), 1.2 * mm, 1e-15);  // above the dome it is a square
  // Of the square 1 + 0.2 sin^2 the mean of the square is 1 + 0.2 + 0.04 * 3 / 8.
  EXPECT_NEAR(measured.area_factor(high), (1.215 * 24 * 24 - 9 * 9) / (24 * 24 - 9 * 9), 1e-12);
}

TEST(Sections, gaps_to_a_square_hole_with_round_corners_are_exact) {
  const core::Profile outline = ring_with_hole();
  const contact::SectionSurface hole(outline, {true, false}, square_with(0.25), 3 * mm);
  const auto expect = [&](const Vector3& at, double distance, const Vector3& normal) {
    const contact::SurfaceGap gap = hole.gap(mm * at);
    EXPECT_NEAR(gap.distance, mm * distance, 1e-9);
    EXPECT_NEAR((gap.normal - normal).norm(), 0, 1e-6);
  };
  expect({18, 3, 5}, 2, {-1, 0, 0});
  expect({2, -19.5, 3}, 0.5, {0, 1, 0});
  expect({20.2, 0, 3}, -0.2, {-1, 0, 0});
  const double diagonal = 15 + (5 - 1) / std::sqrt(2);  // 1 mm off the arc of 5 mm around (15, 15)
  expect({diagonal, diagonal, 3}, 1, Vector3(-1, -1, 0).normalized());
  EXPECT_TRUE(std::isinf(contact::SectionSurface(outline, {false, false}, {}).gap({0, 0, 0}).distance));
}

TEST(Sections, round_tools_are_where_their_outlines_are) {
  const core::Profile outline = ring_with_hole();
  const contact::SectionSurface hole(outline, {true, false}, {});
  for (const double angle : {0.1, 0.9, 2.5}) {
    const contact::SurfaceGap gap = hole.gap(17 * mm * Vector3(std::cos(angle), std::sin(angle), 0.1));
    EXPECT_NEAR(gap.distance, 3 * mm, 1e-15);
    EXPECT_NEAR((gap.normal + Vector3(std::cos(angle), std::sin(angle), 0)).norm(), 0, 1e-12);
  }
}

}  // namespace

}  // namespace parison
