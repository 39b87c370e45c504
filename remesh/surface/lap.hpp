#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/resample.hpp"

namespace parison::remesh {

/// Places where a surface crosses itself.
struct Laps {
  int closed = 0;                       ///< notches that were cut off
  double volume = 0;                    ///< air enclosed in them, m3
  core::Index first = -1, second = -1;  ///< first vertices of two edges that still cross; -1 without such
};

/// Closes laps: where glass has folded onto itself, the notch in between is cut off by a chord if that changes the
/// volume by at most `largest`, m3. A larger lap is left as it is.
Laps close_laps(core::Geometry geometry, double largest, Surface& surface);

}  // namespace parison::remesh
