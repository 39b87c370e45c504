#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// The boundaries that a stage names between two points, a line each for the terminal; it says where a point lies far
/// from the glass as drawn and from all places where tools may stand, so that a run would end there.
std::string describe_named_points(const Scene& scene, const Stage& stage);

/// The stages in degrees and seconds and how long each tool is in use, for the terminal; empty without a timing.
std::string describe_timing(const Scene& scene);

}  // namespace parison::forming
