#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/air_regions.hpp"

namespace parison::forming {

/// The air that glass and tools seal at the start of a step, of the sector.
struct SealedCavities {
  flow::SolidAir air;
  std::vector<double> amount;  ///< as CavityAir::amount
  std::vector<double> share;   ///< of each cavity that is in the sector: the planes of symmetry cut it
};

/// Finds the cavities before the outer side and the rim: faces that do not wholly touch, as far as they hang together.
/// A cavity is open where the air of the inner side reaches it, where something of it faces no tool, and where it is
/// nearest to a loose end of the tools. Its volume is that between the glass and where the normals of the glass meet
/// the tools. Contact counts the tools of the solid.
/// `size` of the glass, m; `resting`: pressure that its weight makes over its height, Pa.
SealedCavities seal_air(const TrappedAirLaw& law, const std::vector<CavityTool>& tools, double dt,
                        const SolidState& solid, double size, double resting);

/// Stores the air that a step leaves.
void store_air(const SealedCavities& sealed, const flow::SolidStep& step, SolidState& solid);

/// The cavities as they are told, whole ones.
CavityAir whole_cavities(const SolidState& solid);

}  // namespace parison::forming
