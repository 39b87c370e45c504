// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/cooling/glass_law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parison::cooling {

namespace {

/// Change of ln viscosity within a part of a step, and the most parts that a step is divided into: 1e3 to 1e15 Pa.s is
/// 28 of them at most.
constexpr double log_change = 1;
constexpr int most_parts = 64;
/// Relaxation of the fastest branch below which a point is solid: its stress keeps twelve digits.
constexpr double no_relaxation = 1e-12;
/// That below which a step need not be divided: it is as small as what the viscosity of the middle is off by.
constexpr double undivided = 1e-4;

/// Relaxation after which nothing is left, in place of numbers too small for the processor's full pace.
constexpr double gone = 100;

/// exp(-q) of each branch, and the mean of exp(-q s) over s from 0 to 1.
struct Decay {
  Branches left, mean;

  explicit Decay(const Branches& q) : left((q < gone).select((-q).exp(), 0)) {
    constexpr double small = 1e-5;  // below it the series to second order has all digits
    mean = (q > small).select((1 - left) / q.max(small), 1 - q / 2 + q * q / 6);
  }
};

/// Fictive temperatures after a time of dt, s, in which the temperature goes straight from `from` to `to`, K, and a
/// branch relaxes by `q`.
Branches follow(const Branches& fictive, const Decay& decay, double from, double to) {
  return fictive * decay.left + from * (1 - decay.left) + (to - from) * (1 - decay.mean);
}

}  // namespace

Relaxation relax(const GlassLaw& law, const Branches& fictive, double from, double to, double dt) {
  const Branches& weight = law.structure.weight;
  const double modulus = law.shear_modulus(), start = (weight * fictive).sum();
  double equilibrium = law.log_equilibrium(start);  // of the fictive temperature that counts
  const auto log_viscosity = [&](double temperature, double counted) {
    return equilibrium + law.frozen_activation * (1 / temperature - 1 / counted);
  };
  const double at_start = log_viscosity(from, start), at_end = log_viscosity(to, start);
  const double fastest = std::min(law.shear.time.minCoeff(), law.structure.time.minCoeff());
  const double most = dt * modulus / (fastest * std::exp(std::min(at_start, at_end)));
  if (most < no_relaxation)
    return {Branches::Ones(), modulus * law.shear.weight, fictive, law.solid_expansion * (to - from)};
  const double changes = most < undivided ? 1 : std::abs(at_end - at_start) / log_change;
  const int parts = std::clamp(static_cast<int>(std::ceil(changes)), 1, most_parts);
  Relaxation result{Branches::Ones(), Branches::Zero(), fictive, 0};
  for (int part = 0; part < parts; ++part) {
    const double here = from + (to - from) * part / parts, next = from + (to - from) * (part + 1) / parts;
    const double before = (weight * result.fictive).sum();
    double middle = before, relaxed = 0;
    if (part > 0) equilibrium = law.log_equilibrium(middle);
    Branches after;
    constexpr int passes = 2;            // the second is of second order
    constexpr double hardly_any = 1e-3;  // K, which changes no viscosity by more than a ten thousandth
    for (int pass = 0; pass < passes; ++pass) {
      relaxed = dt / parts * modulus / std::exp(log_viscosity(0.5 * (here + next), middle));
      after = follow(result.fictive, Decay(relaxed / law.structure.time), here, next);
      const double found = 0.5 * (before + (weight * after).sum());
      if (std::abs(std::exchange(middle, found) - found) < hardly_any) break;
      if (pass + 1 < passes) equilibrium = law.log_equilibrium(middle);
    }
    const Decay shear(relaxed / law.shear.time);
    result.kept *= shear.left;
    result.modulus = result.modulus * shear.left + modulus / parts * law.shear.weight * shear.mean;
    result.fictive = after;
  }
  const double structure = (weight * result.fictive).sum() - start;
  result.strain = law.solid_expansion * (to - from) + (law.liquid_expansion - law.solid_expansion) * structure;
  return result;
}

double weight_of_change(const GlassLaw& law, const Relaxation* points, int count) {
  constexpr double more = 7, steep = 10;  // full weight where between a tenth and nine tenths of the strain stay stress
  double relaxing = 0;
  for (int q = 0; q < count; ++q) {
    const double share = points[q].modulus.sum() / law.shear_modulus();
    relaxing = std::max(relaxing, share * (1 - share));
  }
  return 1 + more * std::min(1.0, steep * relaxing);
}

}  // namespace parison::cooling
