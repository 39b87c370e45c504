#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::forming {

/// The mirror image about the line through two points of a path of points (which have only an end), lines and arcs,
/// drawn from its end to its start: it goes on where a path ends on the line.
std::vector<core::Segment> mirrored(const std::vector<core::Segment>& path, const core::Point& first,
                                    const core::Point& second);

}  // namespace parison::forming
