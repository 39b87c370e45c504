#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/resample.hpp"

namespace parison::remesh {

/// What became of the places where a surface crosses itself.
struct Laps {
  int closed = 0;                       ///< notches cut off
  double volume = 0;                    ///< of their air, m3
  core::Index first = -1, second = -1;  ///< vertices at the ends of a crossing that stays; -1 where none does
};

/// Closes laps: where glass has folded onto itself the notch between is cut off by a chord, if that changes the volume
/// by no more than `largest`, m3. A greater lap is left.
Laps close_laps(core::Geometry geometry, double largest, Surface& surface);

}  // namespace parison::remesh
