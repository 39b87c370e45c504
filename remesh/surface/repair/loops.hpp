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

}  // namespace parison::remesh
