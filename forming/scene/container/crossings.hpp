#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/profile.hpp"
#include "forming/scene/container/free_space.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// The tools of a scene at their offsets, as far as these are known before a run.
struct Placed {
  const Scene& scene;
  std::vector<std::optional<double>> offset;  ///< by tool, m
  std::vector<core::Profile> chords;          ///< by tool, in place of its outline; empty: the outlines as they are

  Solid solid(Index tool) const;
  double sealed_gap() const;
  /// Takes short chords for all arcs from here on.
  void draw_chords();
};

/// The closed region that tools of a stage bound, the largest; with `needed` one that this tool touches.
std::optional<FreeRegion> closed_region(const Placed& placed, const Stage& stage, std::optional<Index> needed);

/// Where an outline crosses a line: the radius on a line across the axis, the place along the axis on a line along it.
struct Crossing {
  double at;  ///< m
  bool contact;
};

/// The crossings of a segment with the line across the axis at z, or along the axis at a radius.
void add_crossings(const core::Segment& segment, double z, bool contact, std::vector<Crossing>& crossings);
void add_crossings_along(const core::Segment& segment, double radius, bool contact, std::vector<Crossing>& crossings);

/// Lowest and highest place of a segment along the axis, m.
std::pair<double, double> range_along_axis(const core::Segment& segment);

/// Adds the places along the axis where a moved segment ends or turns, m.
void add_turns(const core::Segment& segment, double shift, std::vector<double>& places);

}  // namespace parison::forming
