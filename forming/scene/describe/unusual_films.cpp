// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "forming/scene/describe/unusual.hpp"

namespace parison::forming {
namespace {

/// Least height along the axis of the parts of a cavity at a radius, m; infinite where it has none there.
double least_height(const std::vector<Slice>& by_line, double radius) {
  double least = std::numeric_limits<double>::infinity(), height = 0;
  std::size_t last = 0;
  for (const Slice& slice : by_line) {
    if (radius < slice.inner || radius > slice.outer) continue;
    if (height > 0 && slice.line > last + 1) {
      least = std::min(least, height);
      height = 0;
    }
    height += (slice.to - slice.from) / 2;
    last = slice.line;
  }
  return height > 0 ? std::min(least, height) : least;
}

struct ThinPart {
  double height, from, to;  ///< least height along the axis, radii, m
};

/// The widest part of a cavity across the axis that is lower than `limit`, m, on radii that far apart; of height 0
/// where there is none.
ThinPart thin_part(std::vector<Slice> cavity, double limit) {
  constexpr int most = 1000;
  std::sort(cavity.begin(), cavity.end(), [](const Slice& a, const Slice& b) { return a.line < b.line; });
  double outer = 0;
  for (const Slice& slice : cavity) outer = std::max(outer, slice.outer);
  const double apart = std::max(limit, outer / most);
  ThinPart widest{0, 0, 0}, part{0, 0, 0};
  for (double radius = apart / 2; radius < outer; radius += apart) {
    const double height = least_height(cavity, radius);
    if (height < limit) {
      if (part.height == 0) part = {height, radius - apart / 2, 0};
      part.height = std::min(part.height, height);
      part.to = radius + apart / 2;
      if (part.to - part.from > widest.to - widest.from) widest = part;
    } else {
      part.height = 0;
    }
  }
  return widest;
}

}  // namespace

std::vector<std::string> films_too_thin(const Scene& scene, const ContainerPlan& plan) {
  constexpr double counts = 5;  // widths of a film over its least thickness; less is the feather edge of a cavity
  const FilmLimit& limit = scene.glass.film;
  if (!plan.press || !plan.misfit.empty() || limit.then != FilmLimit::Then::stop) return {};
  const ThinPart thin = thin_part(plan.press->glass, limit.min_thickness);
  if (thin.height == 0 || thin.to - thin.from < counts * limit.min_thickness) return {};
  return {fmt::format(
      "where \"{}\" of stage \"{}\" {}, at {:.4g} mm, the glass is {:.2g} mm thick from radius {:.3g} to {:.3g} mm, "
      "thinner than film.min_thickness = {:.3g} mm of the glass: the run will end there. More glass leaves a thicker "
      "film; a smaller film.min_thickness or film.then = \"freeze\" lets the run go on",
      scene.tools[plan.press->tool].name, scene.stages[plan.press->stage].name,
      plan.press->is_driven ? "stops for this mass" : "ends its motion", 1e3 * plan.press->stop, 1e3 * thin.height,
      1e3 * thin.from, 1e3 * thin.to, 1e3 * limit.min_thickness)};
}

}  // namespace parison::forming
