#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>
#include <vector>

#include "core/point.hpp"

namespace parison::core {

/// Straight piece of an outline. `from` and `to` name its ends; chords that meet share a name.
struct Chord {
  Point a, b;  ///< m
  Index from, to;
};

/// Two chords that cross or touch although they do not meet at an end, by exact predicates; the lowest such pair of
/// indices, or {-1, -1} where the outline is simple.
std::pair<Index, Index> find_crossing(const std::vector<Chord>& chords);

}  // namespace parison::core
