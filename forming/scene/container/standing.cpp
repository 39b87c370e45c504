// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/container/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace parison::forming {

namespace {

/// Where along the axis a slice has its radii, m: at one of Gauss's two points of its panel.
double height_of(const Slice& slice) {
  const double side = slice.line % 2 == 0 ? -1 : 1;
  return 0.5 * (slice.from + slice.to) + side * (slice.to - slice.from) / (2 * std::sqrt(3.0));
}

}  // namespace

std::string why_it_falls(const FreeRegion& mould, int up) {
  constexpr double foot = 1e-3, millimetre = 1e-3;  // m; what lies so close to the plate touches it sooner or later
  const double plate = up > 0 ? mould.low : mould.high;
  double curvature = 0, wall = 0, moment = 0;
  for (const Slice& slice : mould.slices) {
    const double height = std::abs(height_of(slice) - plate), area = slice.outer * (slice.to - slice.from);
    wall += area;
    moment += area * height;
    if (height > 0 && height < foot) curvature = std::max(curvature, slice.outer * slice.outer / (2 * height));
  }
  if (curvature == 0 || moment <= wall * curvature) return {};
  return fmt::format(
      "a container that cannot stand was found: its bottom is round, with a radius of {:.3g} mm at the axis, and its "
      "centre of mass lies {:.3g} mm above the plate",
      curvature / millimetre, moment / wall / millimetre);
}

}  // namespace parison::forming
