#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// A tool of the present stage during a step.
struct CavityTool {
  const contact::SectionSurface* surface;
  const Tool* tool;
  double from, to;  ///< its place along the axis at the start and the end of the step, m
};

bool is_inner(const SolidState& solid, std::size_t face);
/// Faces with a point that does not touch.
std::vector<bool> exposed_faces(const SolidState& solid);
/// The faces beside each face.
std::vector<std::vector<std::size_t>> face_neighbours(const SolidState& solid);

/// Exposed faces of the outer side and the rim, as they hang together.
struct AirRegions {
  std::vector<Index> of_face;  ///< -1: none
  std::vector<std::vector<std::size_t>> faces;
  std::vector<bool> open;
};
/// Those are open that the air of the inner side reaches, and those nearest to a loose end of the contact surfaces of
/// the tools: one that no other tool is within `seal_gap` of, m.
AirRegions exposed_regions(const SolidState& solid, const std::vector<bool>& exposed,
                           const std::vector<std::vector<std::size_t>>& beside, const std::vector<CavityTool>& tools,
                           double seal_gap);

}  // namespace parison::forming
