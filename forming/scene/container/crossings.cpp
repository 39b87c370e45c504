// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/container/crossings.hpp"

#include <algorithm>
#include <cmath>

#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {

namespace {

/// The outline with arcs as chords that turn by up to 3 degrees: 0.05 % less across.
core::Profile chords_of(const core::Profile& profile) {
  constexpr double most = M_PI / 60;
  core::Profile chords{{}, profile.boundary_names};
  for (const core::Segment& segment : profile.segments) {
    const int count = segment.is_arc ? 1 + static_cast<int>(std::abs(segment.to - segment.from) / most) : 1;
    core::Segment chord;
    chord.boundary_id = segment.boundary_id;
    chord.end = segment.start;
    for (int i = 1; i <= count; ++i) {
      chord.start = chord.end;
      chord.end = i == count ? segment.end : core::point_at(segment, double(i) / count);
      chords.segments.push_back(chord);
    }
  }
  return chords;
}

}  // namespace

Solid Placed::solid(Index tool) const {
  const Tool& body = scene.tools[tool];
  return {chords.empty() ? &body.profile : &chords[tool], contact_boundaries(body), offset[tool].value_or(0)};
}

double Placed::sealed_gap() const {
  return tolerance::sealed * core::size(scene.glass.profile);
}

void Placed::draw_chords() {
  for (const Tool& tool : scene.tools) chords.push_back(chords_of(tool.profile));
}

std::optional<FreeRegion> closed_region(const Placed& placed, const Stage& stage, std::optional<Index> needed) {
  std::vector<Solid> solids;
  std::size_t which = 0;
  for (const StageTool& entry : stage.tools) {
    if (!placed.offset[entry.tool]) return {};
    if (needed && entry.tool == *needed) which = solids.size();
    solids.push_back(placed.solid(entry.tool));
  }
  const auto regions = free_regions(solids, {{}, {}, placed.sealed_gap()});
  std::optional<FreeRegion> best;
  if (regions)
    for (const FreeRegion& region : *regions) {
      const auto touched = std::count(region.touches.begin(), region.touches.end(), true);
      const bool wanted = needed ? region.touches[which] && touched > 1 : touched > 0;
      if (wanted && !region.is_open && (!best || region.volume > best->volume)) best = region;
    }
  return best;
}

namespace {

/// Calls `use` with the parts of an arc over which coordinate `across` only rises or only falls: its values at the ends
/// of the part, m, and 1 or -1 for the side of the centre on which the part lies in the other coordinate. Neighbours
/// share the number at their common end, the first and last part have those of the segment: an outline is crossed an
/// even number of times whatever the round-off of its arcs.
template <typename Use>
void for_monotone_parts(const core::Segment& arc, int across, const Use& use) {
  const double first_turn = across == 1 ? M_PI / 2 : 0, sense = arc.to > arc.from ? 1 : -1;
  double at = arc.from, value = arc.start[across];
  const auto side = [across](double angle) { return (across == 1 ? std::cos(angle) : std::sin(angle)) > 0 ? 1 : -1; };
  for (double k = std::ceil(sense * (arc.from - first_turn) / M_PI);; ++k) {
    const double turn = first_turn + sense * k * M_PI;
    if (sense * (arc.to - turn) <= 0) break;
    const double direction = across == 1 ? std::sin(turn) : std::cos(turn);
    const double extreme = arc.centre[across] + (direction > 0 ? arc.radius : -arc.radius);
    use(value, extreme, side(0.5 * (at + turn)));
    at = turn, value = extreme;
  }
  use(value, arc.end[across], side(0.5 * (at + arc.to)));
}

/// Crossings with the line on which coordinate `across` has a value; the other coordinate is their place.
void add(const core::Segment& segment, int across, double value, bool contact, std::vector<Crossing>& crossings) {
  const int along = 1 - across;
  const auto is_between = [value](double a, double b) { return (a <= value) != (b <= value); };
  if (!segment.is_arc) {
    const core::Point &a = segment.start, &b = segment.end;
    if (!is_between(a[across], b[across])) return;
    const double t = (value - a[across]) / (b[across] - a[across]);
    crossings.push_back({a[along] + t * (b[along] - a[along]), contact});
    return;
  }
  const double offset = value - segment.centre[across], square = segment.radius * segment.radius - offset * offset;
  for_monotone_parts(segment, across, [&](double first, double last, int side) {
    if (is_between(first, last))
      crossings.push_back({segment.centre[along] + side * std::sqrt(std::max(square, 0.0)), contact});
  });
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
  if (segment.is_arc)
    for_monotone_parts(segment, 1, [&](double first, double last, int) {
      low = std::min({low, first, last}), high = std::max({high, first, last});
    });
  return {low, high};
}

void add_turns(const core::Segment& segment, double shift, std::vector<double>& places) {
  const auto [low, high] = range_along_axis(segment);
  for (const double z : {segment.start[1], segment.end[1], low, high}) places.push_back(z + shift);
}

}  // namespace parison::forming
