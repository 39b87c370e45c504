// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using cooling::Spectrum;
using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

constexpr core::Dimension per_kelvin{0, 0, 0, -1};

/// Pairs of a weight and a time, at most as many as there are branches; missing ones get no weight.
Spectrum read_spectrum(const CaseNode& node) {
  const auto& pairs = core::list(node);
  if (pairs.empty() || pairs.size() > cooling::branches)
    core::refuse(node, fmt::format("{} pairs were found, allowed are 1 to {} of a weight and a relative time",
                                   pairs.size(), cooling::branches));
  Spectrum spectrum{cooling::Branches::Zero(), cooling::Branches::Ones()};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& pair = core::list(pairs[i]);
    if (pair.size() != 2) core::refuse(pairs[i], "no pair was found, allowed is a weight and a relative time");
    const auto branch = static_cast<Eigen::Index>(i);
    spectrum.weight[branch] = core::positive(pair[0], dimension::none);
    spectrum.time[branch] = core::positive(pair[1], dimension::none);
  }
  constexpr double off = 0.01;
  if (std::abs(spectrum.weight.sum() - 1) > off)
    core::refuse(node, fmt::format("weights with the sum {:.4g} were found, allowed is a spectrum: weights that add "
                                   "up to 1",
                                   spectrum.weight.sum()));
  spectrum.weight /= spectrum.weight.sum();
  return spectrum;
}

/// Temperature, K, at which the equilibrium viscosity has a logarithm.
double temperature_at(const std::function<double(double)>& log_viscosity, double wanted) {
  double cold = 300, hot = 2500;  // K
  while (hot - cold > 1e-9 * hot) {
    const double middle = 0.5 * (cold + hot);
    (log_viscosity(middle) > wanted ? cold : hot) = middle;
  }
  return hot;
}

/// Activation of the equilibrium viscosity over the gas constant, K, where the glass sets: at 1e12 Pa.s.
double activation(const std::function<double(double)>& log_viscosity) {
  const double T = temperature_at(log_viscosity, std::log(1e12)), dT = 1;
  return -T * T * (log_viscosity(T + dT) - log_viscosity(T - dT)) / (2 * dT);
}

}  // namespace

cooling::GlassLaw read_annealing(const CaseNode& node, const CaseTable& material, const flow::Viscosity& viscosity) {
  const CaseTable table(node, {"young", "poisson", "frozen_share", "shear", "structure"});
  const CaseTable expansion(material.get("expansion"), {"cold_density", "solid", "liquid", "transformation"});
  cooling::GlassLaw law{core::positive(table.get("young"), dimension::pressure),
                        core::not_negative(table.get("poisson"), dimension::none),
                        core::not_negative(expansion.get("solid"), per_kelvin),
                        core::not_negative(expansion.get("liquid"), per_kelvin),
                        read_spectrum(table.get("shear")),
                        read_spectrum(table.get("structure")),
                        0,
                        [viscosity](double T) { return viscosity.equilibrium_logarithm(T); }};
  if (law.poisson >= 0.5)
    core::refuse(table.get("poisson"), fmt::format("{:g} was found, allowed is 0 to below 0.5", law.poisson));
  const double mean = law.shear.mean();
  law.shear.time /= mean;
  law.structure.time /= mean;
  const double share = core::not_negative(table.get("frozen_share"), dimension::none);
  if (share > 1) core::refuse(table.get("frozen_share"), fmt::format("{:g} was found, allowed is 0 to 1", share));
  law.frozen_activation = share * activation(law.log_equilibrium);
  return law;
}

}  // namespace parison::forming
