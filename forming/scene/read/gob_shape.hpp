#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/container/free_space.hpp"

namespace parison::forming {

/// The room along the axis into which a gob runs.
struct GobRoom {
  std::vector<Solid> solids;  ///< around it
  double low, high;           ///< where it ends, m along the axis, unless a solid ends it before
  double up;                  ///< 1 or -1: against gravity along the axis
  double clearance;           ///< between the gob and the solids, m
};

/// A gob in such a room.
struct GobShape {
  double most = 0;                      ///< largest volume that finds room, m3
  std::vector<core::Segment> sides;     ///< from its low to its high end on the axis; empty where it finds no room
  std::size_t first_top = 0, tops = 0;  ///< those of them that are its top
};

/// The gob of a volume, m3, that fills its room from below: all balls around points of the axis that find room, up to
/// one of them, none wider than the throats that it has passed. So it follows a tapered wall, and its ends are round.
GobShape shape_gob(const GobRoom& room, double volume);

}  // namespace parison::forming
