// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/cavities/shared_air.hpp"

#include <algorithm>
#include <cmath>

namespace parison::forming {

bool is_void(const AirOrigin& origin, const CavityAir& before) {
  double energy = origin.open;
  for (std::size_t k = 0; k < origin.cavity.size(); ++k) energy += origin.cavity[k] * before.energy[k];
  return energy == 0;
}

AirShares share_air(const std::vector<AirOrigin>& origins, const std::vector<double>& volume, const CavityAir& before,
                    const TrappedAirLaw& law) {
  AirShares shares;
  const std::size_t count = origins.size();
  for (std::size_t i = 0; i < count; ++i) shares.energy.push_back(origins[i].open * law.ambient * volume[i]);
  shares.amount = shares.energy;
  for (std::size_t k = 0; k < before.volume.size(); ++k) {
    double all = 0;
    for (std::size_t i = 0; i < count; ++i) all += origins[i].cavity[k] * volume[i];
    for (std::size_t i = 0; all > 0 && i < count; ++i) {
      const double part = origins[i].cavity[k] * volume[i] / all;
      shares.energy[i] += part * before.energy[k];
      shares.amount[i] += part * before.amount[k];
    }
  }
  return shares;
}

void add_cavity(const flow::AirPocket& first, double amount, double volume, double outflow, CavityAir& air) {
  air.volume.push_back(std::max(volume, 1e-6 * first.volume));
  const double sealed = first.energy * std::pow(first.volume / air.volume.back(), first.exponent - 1);
  air.energy.push_back(std::max(0.0, sealed - first.exponent * outflow));
  air.amount.push_back(std::max(0.0, amount - outflow));
}

}  // namespace parison::forming
