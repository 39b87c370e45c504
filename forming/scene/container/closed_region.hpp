#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

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

}  // namespace parison::forming
