#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/report/thickness_profile.hpp"

namespace parison::forming {

/// Stress in one direction along the wall, Pa: its mean through the wall, which bears as a membrane does, and what is
/// left without it at the outer side, in the middle and at the inner side.
struct StressThroughWall {
  double mean, outer, middle, inner;
};

/// Stress through the wall at a row of the thickness profile.
struct WallStress {
  double arc, thickness;  ///< m
  Point outer;            ///< place on the outer side, m
  StressThroughWall hoop, meridional;
};
/// At all rows that are wall; none where the glass has not cooled.
std::vector<WallStress> wall_stress(const GlassState& glass, const std::vector<ThicknessRow>& rows);

/// residual_stress.csv as a text.
std::string wall_stress_text(const std::vector<WallStress>& wall);

}  // namespace parison::forming
