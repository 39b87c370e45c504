#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/flow/air/air_pocket.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

inline constexpr double gas_constant_of_air = 287.05;  ///< J/(kg K)

/// Shares of a cavity's exposed surface that belonged to each earlier cavity, and to the open.
struct AirOrigin {
  std::vector<double> cavity;
  double open = 0;
};

/// Whether a cavity has opened in contact alone, so that it holds no air.
bool is_void(const AirOrigin& origin, const CavityAir& before);

/// The air of cavities as CavityAir has it.
struct AirShares {
  std::vector<double> energy, amount;
};
/// Divides the air of earlier cavities among those that have their surface, by volume, m3. A cavity that comes from the
/// open has air of the stage, one that comes from contact none.
AirShares share_air(const std::vector<AirOrigin>& origins, const std::vector<double>& volume, const CavityAir& before,
                    const TrappedAirLaw& law);

/// Appends a cavity at the end of a step, which it began as `first` with an `amount` of air: its volume, m3, and what
/// flowed out of it, J.
void add_cavity(const flow::AirPocket& first, double amount, double volume, double outflow, CavityAir& air);

}  // namespace parison::forming
