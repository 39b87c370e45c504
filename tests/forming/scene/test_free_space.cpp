// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "forming/scene/container/free_space.hpp"
#include "forming/scene/read/curves/curve_arcs.hpp"

namespace parison::forming {
namespace {

/// A tool with a cylindrical cavity (radius 10 mm, height 30 mm) below a half sphere of the same radius.
core::Profile domed_mould() {
  core::Profile profile;
  const auto line = [&](double r, double z) {
    const core::Point start = profile.segments.empty() ? core::Point(0, -0.01) : profile.segments.back().end;
    profile.segments.push_back({start, core::Point(r, z)});
  };
  line(0.05, -0.01), line(0.05, 0.06), line(0, 0.06), line(0, 0.04);
  core::Segment dome{core::Point(0, 0.04), core::Point(0.01, 0.03)};
  dome.is_arc = true, dome.centre = core::Point(0, 0.03), dome.radius = 0.01, dome.from = M_PI / 2, dome.to = 0;
  profile.segments.push_back(dome);
  line(0.01, 0), line(0, 0), line(0, -0.01);
  return profile;
}

/// A tool of radius 50 mm around a cavity of radius 40 mm, 30 mm high, into which an elliptic push-up of radius 33 mm
/// stands.
core::Profile mould_with_push_up(double height) {
  constexpr double r = 0.033, floor = 0.03;
  core::Profile mould;
  const auto line = [&](double x, double z) {
    const core::Point start = mould.segments.empty() ? core::Point(0, -0.01) : mould.segments.back().end;
    mould.segments.push_back({start, core::Point(x, z)});
  };
  line(0.05, -0.01), line(0.05, 0.05), line(0, 0.05), line(0, floor - height);
  const PlaneCurve ellipse = [=](double t) -> CurvePoint {
    return {{r * std::sin(t), floor - height * std::cos(t)}, {r * std::cos(t), height * std::sin(t)}};
  };
  for (const core::Segment& arc : arcs_of(ellipse, 0, M_PI / 2, 0.5e-6)) mould.segments.push_back(arc);
  line(0.04, floor), line(0.04, 0), line(0, 0), line(0, -0.01);
  return mould;
}

TEST(FreeSpace, an_elliptic_push_up_of_any_height_leaves_one_cavity) {
  for (double height = 1e-3; height < 14e-3; height += 0.25e-3) {
    const core::Profile mould = mould_with_push_up(height);
    const auto regions = free_regions({{&mould, {true}, 0.0017}}, {{}, {}, 1.2e-4});
    ASSERT_TRUE(regions);
    double volume = 0;
    int count = 0;
    for (const auto& region : *regions)
      if (!region.is_open) ++count, volume += region.volume;
    EXPECT_EQ(count, 1) << height;
    const double exact = M_PI * (0.04 * 0.04 * 0.03 - 2.0 / 3 * 0.033 * 0.033 * height);
    EXPECT_NEAR(volume / exact, 1, 1e-5) << height;
  }
}

TEST(FreeSpace, volume_of_a_closed_cavity_is_that_of_its_shape) {
  const core::Profile mould = domed_mould();
  const auto regions = free_regions({{&mould, {true}, 0.002}}, {});
  ASSERT_TRUE(regions);
  double volume = 0;
  for (const auto& region : *regions)
    if (!region.is_open) {
      volume += region.volume;
      EXPECT_NEAR(region.high, 0.042, 1e-12);
      EXPECT_NEAR(region.low, 0.002, 1e-12);
    }
  EXPECT_NEAR(volume, M_PI * 1e-4 * 0.03 + 2 * M_PI / 3 * 1e-6, 1e-6 * volume);
}

TEST(FreeSpace, a_limit_closes_what_it_cuts_and_a_gap_opens_it) {
  const core::Profile mould = domed_mould();
  core::Profile pierced = mould;
  for (auto& segment : pierced.segments)
    for (auto* x : {&segment.start, &segment.end})
      if ((*x)[0] == 0 && (*x)[1] < 0.005) (*x)[0] = 0.001;
  const auto is_closed = [](const std::vector<FreeRegion>& regions) {
    return std::any_of(regions.begin(), regions.end(), [](const auto& region) { return !region.is_open; });
  };
  EXPECT_TRUE(is_closed(*free_regions({{&mould, {true}, 0}}, {})));
  EXPECT_FALSE(is_closed(*free_regions({{&pierced, {true}, 0}}, {})));
  EXPECT_TRUE(is_closed(*free_regions({{&pierced, {true}, 0}}, {{}, {}, 0.0011})));
  const auto half = *free_regions({{&mould, {true}, 0}}, {0.01, {}, 0});
  for (const auto& region : half)
    if (!region.is_open) {
      EXPECT_TRUE(region.from_low_limit);
      EXPECT_NEAR(region.volume, M_PI * 1e-4 * 0.02 + 2 * M_PI / 3 * 1e-6, 1e-6 * region.volume);
    }
}

TEST(FreeSpace, a_joint_between_two_tools_is_closed_where_it_is_narrower_than_the_sealed_gap) {
  const auto box = [](double inner, double low, double high) {
    core::Profile profile;
    const core::Point corners[] = {{inner, low}, {0.05, low}, {0.05, high}, {inner, high}};
    for (int i = 0; i < 4; ++i) profile.segments.push_back({corners[i], corners[(i + 1) % 4]});
    return profile;
  };
  const core::Profile floor = box(0, -0.01, 0), ring = box(0.01, 0, 0.02), lid = box(0, 0.02, 0.03);
  const auto closed_volume = [&](double joint, double sealed) {
    double volume = 0;
    const auto regions =
        *free_regions({{&floor, {true}, 0}, {&ring, {true}, 0}, {&lid, {true}, joint}}, {{}, {}, sealed});
    for (const auto& region : regions)
      if (!region.is_open) volume += region.volume;
    return volume;
  };
  const double whole = M_PI * 1e-4 * 0.02;
  EXPECT_NEAR(closed_volume(0, 0), whole, 1e-6 * whole);
  EXPECT_EQ(closed_volume(5e-5, 0), 0);
  EXPECT_NEAR(closed_volume(5e-5, 1e-4), M_PI * 1e-4 * 0.02, 3e-3 * whole);
  EXPECT_EQ(closed_volume(2e-4, 1e-4), 0);
}

TEST(FreeSpace, outlines_too_fine_for_it_are_given_up_in_a_bounded_time) {
  core::Profile comb;
  core::Point at(0.001, 0);
  for (int i = 1; i <= 4000; ++i) {
    const core::Point next(0.001 + 1e-6 * i, i % 2 ? 1 : 0);
    comb.segments.push_back({at, next});
    at = next;
  }
  comb.segments.push_back({at, core::Point(0.001, 0)});
  EXPECT_FALSE(free_regions({{&comb, {true}, 0}}, {}));
}

}  // namespace
}  // namespace parison::forming
