#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// A tool at an offset along the axis, m.
struct PlacedTool {
  const Tool& tool;
  double offset;
};

/// How deep two tools lie in each other, m, and where; 0 where they do not.
struct Overlap {
  double depth = 0;
  core::Point at = core::Point::Zero();
};

/// The overlap of what is drawn of two tools; none where it is no deeper than `touching`, m.
Overlap overlap_of(const PlacedTool& first, const PlacedTool& second, double touching);

/// What counts as contact of two tools that stand, m.
double touching_of(const Tool& a, const Tool& b);

/// Whether tools overlap in a changed case, m, where those of the base do not, or by notably less: by more than half
/// again and a clearance, m.
bool is_new_overlap(double changed, double base, double clearance);
/// What the base has instead, as the end of a sentence: "those of the base do not", or by how much.
std::string overlap_in_base(double base);

/// Tools of a changed case that overlap where they stand, in a stage in which both are active and rest, or on the way
/// of a given motion, while those of the base do not or notably less, as a sentence; empty where there are none. Tools
/// that overlap in a stage of the base too are meant to: their union counts.
std::string new_tool_overlap(const Scene& base, const Scene& changed);

}  // namespace parison::forming
