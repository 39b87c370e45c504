// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/viscosity/composition.hpp"

#include "core/case/units.hpp"

namespace parison::flow {
namespace {

/// Change of the temperature at 10, 1e3 and 1e5 Pa.s by one part of an oxide for 100 parts of SiO2, K.
struct OxideEffect {
  const char* name;
  std::array<double, 3> effect;
};
constexpr std::array<double, 3> pure{1847.8, 1249.7, 962.9};          ///< degC
constexpr std::array<double, 3> boron_squared{0.5122, 0.3182, 0.19};  ///< K for a squared part of B2O3
constexpr std::array<OxideEffect, 10> effects{{{"Al2O3", {8.32, 5.23, 4.01}},
                                               {"Na2O", {-12.65, -9.19, -7.06}},
                                               {"K2O", {-5.93, -4.17, -3.53}},
                                               {"Li2O", {-35.54, -30.04, -26.45}},
                                               {"CaO", {-11.27, -3.99, -0.74}},
                                               {"MgO", {-5.87, -0.12, 0.91}},
                                               {"BaO", {-5.67, -3.04, -1.88}},
                                               {"ZnO", {-5.37, -1.88, -0.71}},
                                               {"PbO", {-4.85, -3.17, -2.24}},
                                               {"B2O3", {-21.62, -11.97, -6.42}}}};

}  // namespace

const std::array<OxideRange, 11>& oxide_ranges() {
  static const std::array<OxideRange, 11> ranges{{{"SiO2", 0.60, 0.775},
                                                  {"Al2O3", 0, 0.083},
                                                  {"Na2O", 0.10, 0.17},
                                                  {"K2O", 0, 0.087},
                                                  {"Li2O", 0, 0.03},
                                                  {"CaO", 0.044, 0.134},
                                                  {"MgO", 0, 0.06},
                                                  {"BaO", 0, 0.166},
                                                  {"ZnO", 0, 0.094},
                                                  {"PbO", 0, 0.123},
                                                  {"B2O3", 0, 0.144}}};
  return ranges;
}

std::array<double, 3> isokom_temperatures(const Composition& composition) {
  const auto share = [&](const char* name) {
    const auto found = composition.find(name);
    return found == composition.end() ? 0 : found->second;
  };
  std::array<double, 3> temperature = pure;
  for (const OxideEffect& oxide : effects) {
    const double parts = 100 * share(oxide.name) / share("SiO2");
    for (std::size_t i = 0; i < 3; ++i) temperature[i] += oxide.effect[i] * parts;
  }
  const double boron = 100 * share("B2O3") / share("SiO2");
  for (std::size_t i = 0; i < 3; ++i) temperature[i] += boron_squared[i] * boron * boron + core::zero_celsius;
  return temperature;
}

Viscosity vft_through(const std::array<double, 3>& temperature, const std::array<double, 3>& log10_viscosity) {
  const auto& T = temperature;
  const auto& L = log10_viscosity;
  const double first = (L[1] - L[0]) / (T[0] - T[1]), second = (L[2] - L[1]) / (T[1] - T[2]);
  Viscosity law;
  law.T0 = (second * T[2] - first * T[0]) / (second - first);
  law.B = first * (T[0] - law.T0) * (T[1] - law.T0);
  law.A = L[0] - law.B / (T[0] - law.T0);
  return law;
}

Viscosity viscosity_of(const Composition& composition) {
  return vft_through(isokom_temperatures(composition), {1, 3, 5});
}

}  // namespace parison::flow
