#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "remesh/surface/resample.hpp"

namespace parison::remesh {

/// A loop has at least so many edges.
inline constexpr core::Index min_edges = 3;

/// First edge of the loop of an edge, and the one behind its last.
std::pair<core::Index, core::Index> loop_of(const Outline& outline, core::Index edge);

/// Volume between the outline from vertex `begin` to vertex `end` of one loop and the chord between them, m3; positive
/// where it is on the left, as the body is.
double volume_cut(const Outline& outline, core::Index begin, core::Index end, core::Geometry geometry);

/// Volume in the loop of an edge, m3; negative where it encloses air.
double loop_volume(const Outline& outline, core::Index edge, core::Geometry geometry);

/// Takes the loop of an edge away.
void erase_loop(Surface& surface, core::Index edge);

/// Lets the loop of an edge begin with it.
void rotate_loop(Surface& surface, core::Index edge);

/// Lets edge a, from A to B, go to D, and edge c, from C to D, go to B. Of one loop they make two: the one behind a and
/// c, in the place of the old one, and at the end of the surface that between a and c. Of two loops they make one. Both
/// edges become straight and free. Gives their new indices.
std::pair<core::Index, core::Index> reconnect(Surface& surface, core::Index a, core::Index c);

/// Largest volumes, m3, of what may be cut off where a surface crosses itself.
struct CrossingLimits {
  double lap;       ///< notch between folded glass, or glass that overlaps itself
  double torn;      ///< piece that hangs on a neck of negative width, or one thinner than `neck`
  double neck = 0;  ///< thickness, m, of a neck without contact that has torn
};

/// What was cut off where a surface crossed itself.
struct Crossings {
  int laps = 0;                         ///< notches and overlaps
  double lap_volume = 0;                ///< of the air enclosed in them, or of the overlap, m3
  int enclosed = 0;                     ///< places at which glass has joined around more air than in a lap
  double enclosed_volume = 0;           ///< of that air, m3
  int torn = 0;                         ///< pieces that had torn off
  double torn_volume = 0;               ///< m3
  core::Index first = -1, second = -1;  ///< first vertices of two edges that still cross; -1 without such
  double left_volume = 0;               ///< what their crossing would cut off, m3
  bool left_torn = false;               ///< whether that is a piece torn off
};

/// Removes the places where a surface crosses itself. Where glass has folded onto itself, the notch in between is cut
/// off by a chord; where it is greater than the limit, the glass joins there, and the air gets a loop of its own. Where
/// the film between two loops has torn, they become one; a loop of little air whose sides have met is filled. Where a
/// neck of the glass has become so thin that its sides have crossed, the smaller piece behind it has torn off and is
/// cut off as well; so it is where the neck is thinner than the limit. What is greater than the limits is left as it
/// is.
Crossings remove_crossings(core::Geometry geometry, const CrossingLimits& limits, Surface& surface);

}  // namespace parison::remesh
