// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/container/closed_region.hpp"

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

}  // namespace parison::forming
