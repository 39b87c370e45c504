#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Curves of a drawing one behind the other; private to the reading of drawings.
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "core/mesh/profile.hpp"

namespace parison::forming {

using Chain = std::vector<core::Segment>;

/// The same way back.
Chain turned(const Chain& chain);
/// "(31, 14) mm".
std::string in_mm(const core::Point& x);
/// Whether the last curve ends where the first one starts.
bool is_closed(const Chain& chain);

/// Refuses an open chain whose ends are so near each other that a closed outline is meant; `gap` is what would be
/// closed, m.
void refuse_nearly_closed(const core::CaseNode& file, const Chain& chain, double gap);

/// Gaps between the ends of curves that were closed.
struct ClosedGaps {
  std::size_t count = 0;
  double widest = 0;                        ///< m
  core::Point where = core::Point::Zero();  ///< of the widest
};

/// A chain of a drawing, and the curves of its other outlines.
struct Chained {
  Chain chain, rest;
  ClosedGaps closed;
};

/// Brings the curve that is closest to a place and those that follow it at both ends into a chain, each end meeting the
/// next start; ends up to `gap` apart, m, are brought together: that of a line to that of an arc, else both to the
/// middle. Refuses wider gaps and branches.
Chained chained(const core::CaseNode& file, Chain curves, const core::Point& from, double gap);

/// Refuses a drawing for the outlines that it has besides a chain.
[[noreturn]] void refuse_several(const core::CaseNode& file, const Chained& drawn, const std::string& why);

}  // namespace parison::forming
