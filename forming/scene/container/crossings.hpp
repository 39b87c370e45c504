#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::forming {

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
