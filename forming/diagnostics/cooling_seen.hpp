#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The largest tension on a part of the surface.
struct SurfaceTension {
  double stress = 0;  ///< principal, Pa; 0 where nothing is pulled
  core::Point at = core::Point::Zero();
  double time = 0;  ///< s since the start of the run
};

/// Keeps the larger of two.
void keep_larger(const SurfaceTension& now, SurfaceTension& largest);

/// Tension on the outer and on the inner side.
struct SidesTension {
  SurfaceTension outer, inner;
};
/// That of a state; nothing where the glass remembers no stress.
SidesTension surface_tension(const State& state);

/// What a run has seen of the end of cooling.
struct CoolingSeen {
  SidesTension largest;                           ///< at any time
  double capacity = 0, height = 0, diameter = 0;  ///< of the container when it began, m3, m; 0 where it has none
  double volume = 0;                              ///< of the glass when it began, m3

  /// By how much the height is less, as a share, than shrinkage alone would leave it; negative: more.
  double sag(double height_now, double volume_now) const;
};

/// Adds the tension at the end of a step that cools.
void follow_cooling(const SidesTension& now, CoolingSeen& seen);

template <typename Visitor, typename Tension>
void visit_tension(Visitor visit, Tension& tension) {
  visit("stress", tension.stress);
  visit("r", tension.at[0]);
  visit("z", tension.at[1]);
  visit("time", tension.time);
}

template <typename Visitor, typename Seen>
void visit_cooling(Visitor visit, Seen& seen) {
  visit_tension(visit.part("outer"), seen.largest.outer);
  visit_tension(visit.part("inner"), seen.largest.inner);
  visit("capacity", seen.capacity);
  visit("height", seen.height);
  visit("diameter", seen.diameter);
  visit("volume", seen.volume);
}

}  // namespace parison::forming
