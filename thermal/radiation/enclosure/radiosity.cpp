// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/enclosure/enclosure.hpp"
#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

/// Emissive power of a black body in the part of the spectrum in which surfaces are grey: all of it, or beyond the
/// bands of the glass.
Emission grey_emission(const HeatSystem& system, double temperature) {
  if (!system.light.empty()) return system.light.front().laws().opaque_emission(temperature);
  const double cube = stefan_boltzmann * temperature * temperature * std::abs(temperature);
  return {cube * temperature, 4 * cube};
}

double value_at(const EnclosurePoint& point, const Eigen::VectorXd& values) {
  return interpolate(values, point.unknowns.data(), point.shape);
}

/// What the patches absorb of the excess, of the emissive powers of patches and surroundings, W/m2.
Eigen::ArrayXd grey_absorbed(const Enclosure& enclosure, const Eigen::ArrayXd& emitted,
                             const Eigen::ArrayXd& surroundings) {
  const Eigen::ArrayXd radiosity = enclosure.emissivity * emitted + (1 - enclosure.emissivity) * surroundings;
  return enclosure.emissivity * enclosure.grey.solve(excess_source(enclosure, radiosity, surroundings)).array();
}

}  // namespace

Eigen::ArrayXd surroundings_of(const Enclosure& enclosure, double time, const std::function<double(double)>& emission) {
  Eigen::ArrayXd emitted(static_cast<Eigen::Index>(enclosure.patches.size()));
  for (Eigen::Index p = 0; p < emitted.size(); ++p)
    emitted[p] = emission((*enclosure.patches[static_cast<std::size_t>(p)].surroundings)(time));
  return emitted;
}

Eigen::VectorXd excess_source(const Enclosure& enclosure, const Eigen::ArrayXd& radiosity,
                              const Eigen::ArrayXd& surroundings) {
  return (enclosure.views.between * radiosity.matrix()).array() -
         (enclosure.area - enclosure.views.open.array()) * surroundings;
}

void add_excess(const Enclosure& enclosure, const HeatSystem& system, const Eigen::ArrayXd& absorbed, Flows& flows,
                Eigen::VectorXd* power, Index but) {
  for (const EnclosurePoint& point : enclosure.points) {
    const EnclosurePatch& patch = enclosure.patches[static_cast<std::size_t>(point.patch)];
    const double heat = point.area * absorbed[point.patch];
    flows.to_air[patch.body] -= heat;
    flows.from_enclosure[patch.body] += heat;
    if (patch.body == but) continue;
    flows.exchanged[system.first_boundary[static_cast<std::size_t>(patch.body)] + patch.boundary] -= heat;
    if (power)
      for (int i = 0; i < 3; ++i) (*power)[point.unknowns[i]] += point.shape[i] * heat;
  }
}

void add_enclosure(const HeatSystem& system, double time, const Eigen::VectorXd& temperature, Flows& flows,
                   Eigen::VectorXd* power) {
  const Enclosure& enclosure = *system.enclosure;
  if (enclosure.patches.empty()) return;
  const auto emission = [&](double T) { return grey_emission(system, T).value; };
  const Eigen::ArrayXd emitted =
      patch_means(enclosure, [&](std::size_t i) { return emission(value_at(enclosure.points[i], temperature)); });
  const Eigen::ArrayXd absorbed = grey_absorbed(enclosure, emitted, surroundings_of(enclosure, time, emission));
  const Eigen::VectorXd before = flows.to_air;
  add_excess(enclosure, system, absorbed, flows, power);
  for (const Light& light : system.light)
    flows.light_to_air[light.body] += flows.to_air[light.body] - before[light.body];
}

Eigen::ArrayXd linearise_enclosure(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  const Enclosure& enclosure = *system.enclosure;
  Eigen::ArrayXd derivatives(static_cast<Eigen::Index>(enclosure.points.size()));
  for (Eigen::Index i = 0; i < derivatives.size(); ++i)
    derivatives[i] =
        grey_emission(system, value_at(enclosure.points[static_cast<std::size_t>(i)], temperature)).derivative;
  return derivatives;
}

void apply_enclosure(const HeatSystem& system, const Eigen::ArrayXd& derivatives, double step,
                     const Eigen::VectorXd& change, Eigen::VectorXd& result) {
  const Enclosure& enclosure = *system.enclosure;
  if (enclosure.patches.empty()) return;
  const Eigen::ArrayXd emitted = patch_means(enclosure, [&](std::size_t i) {
    return derivatives[static_cast<Eigen::Index>(i)] * value_at(enclosure.points[i], change);
  });
  const Eigen::ArrayXd absorbed = grey_absorbed(enclosure, emitted, Eigen::ArrayXd::Zero(emitted.size()));
  for (const EnclosurePoint& point : enclosure.points)
    for (int i = 0; i < 3; ++i) result[point.unknowns[i]] -= step * point.shape[i] * point.area * absorbed[point.patch];
}

}  // namespace parison::thermal
