// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/container/crossings.hpp"

#include <algorithm>
#include <cmath>

namespace parison::forming {
namespace {

/// Whether an arc has the point at an angle, rad.
bool covers(const core::Segment& arc, double angle) {
  const double low = std::min(arc.from, arc.to), high = std::max(arc.from, arc.to);
  const double turns = std::ceil((low - angle) / (2 * M_PI));
  return angle + 2 * M_PI * turns <= high;
}

/// Crossings with the line on which coordinate `across` has a value; the other coordinate is their place.
void add(const core::Segment& segment, int across, double value, bool contact, std::vector<Crossing>& crossings) {
  const int along = 1 - across;
  if (!segment.is_arc) {
    const core::Point &a = segment.start, &b = segment.end;
    if ((a[across] <= value) == (b[across] <= value)) return;
    const double t = (value - a[across]) / (b[across] - a[across]);
    crossings.push_back({a[along] + t * (b[along] - a[along]), contact});
    return;
  }
  const double offset = value - segment.centre[across], square = segment.radius * segment.radius - offset * offset;
  if (square <= 0) return;
  for (const double half : {-std::sqrt(square), std::sqrt(square)}) {
    const double angle = across == 1 ? std::atan2(offset, half) : std::atan2(half, offset);
    if (covers(segment, angle)) crossings.push_back({segment.centre[along] + half, contact});
  }
}

}  // namespace

void add_crossings(const core::Segment& segment, double z, bool contact, std::vector<Crossing>& crossings) {
  add(segment, 1, z, contact, crossings);
}

void add_crossings_along(const core::Segment& segment, double radius, bool contact, std::vector<Crossing>& crossings) {
  add(segment, 0, radius, contact, crossings);
}

std::pair<double, double> range_along_axis(const core::Segment& segment) {
  double low = std::min(segment.start[1], segment.end[1]), high = std::max(segment.start[1], segment.end[1]);
  if (segment.is_arc && covers(segment, -M_PI / 2)) low = segment.centre[1] - segment.radius;
  if (segment.is_arc && covers(segment, M_PI / 2)) high = segment.centre[1] + segment.radius;
  return {low, high};
}

void add_turns(const core::Segment& segment, double shift, std::vector<double>& places) {
  const auto [low, high] = range_along_axis(segment);
  for (const double z : {segment.start[1], segment.end[1], low, high}) places.push_back(z + shift);
}

}  // namespace parison::forming
