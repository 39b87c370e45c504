// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/read_density.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/case/units.hpp"
#include "core/math/numbers.hpp"
#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

constexpr core::Dimension per_kelvin{0, 0, 0, -1};

/// Largest linear expansion coefficient, 1/K: liquid glasses have 20e-6 to 60e-6.
constexpr double most_expansion = 100e-6;

double celsius(double temperature) {
  return temperature - core::zero_celsius;
}

Density relative_to_first(core::Table table) {
  const double first = table.y.front();
  for (double& value : table.y) value /= first;
  return {first, std::move(table)};
}

/// Density by measured points.
Density read_points(const CaseNode& node) {
  const core::Table table = core::quantity_table(node, dimension::temperature, dimension::density);
  constexpr std::size_t fewest = 2, most = 1000;
  if (table.x.size() < fewest || table.x.size() > most)
    core::refuse(node, fmt::format("{} pairs were found, allowed are {} to {} of a temperature and a density",
                                   table.x.size(), fewest, most));
  for (std::size_t i = 0; i < table.y.size(); ++i) {
    core::positive(node.items[i].items[1], dimension::density);
    if (i == 0) continue;
    const double expansion = std::log(table.y[i - 1] / table.y[i]) / (3 * (table.x[i] - table.x[i - 1]));
    if (expansion < 0)
      core::refuse(node.items[i], fmt::format("{:g} kg/m3 is above the {:g} kg/m3 before it, allowed are densities "
                                              "that fall with the temperature",
                                              table.y[i], table.y[i - 1]));
    if (expansion > most_expansion)
      core::refuse(node.items[i], fmt::format("the glass would expand by {:.3g} 1/K in length from {:g} degC, allowed "
                                              "is up to {:g} 1/K",
                                              expansion, celsius(table.x[i - 1]), most_expansion));
  }
  return relative_to_first(table);
}

double read_coefficient(const CaseNode& node) {
  const double value = core::not_negative(node, per_kelvin);
  if (value > most_expansion)
    core::refuse(node, fmt::format("{:g} 1/K was found, allowed is up to {:g} 1/K", value, most_expansion));
  return value;
}

/// Density whose logarithm is straight below and above the transformation, by points between which that makes no
/// difference.
Density read_expansion(const CaseNode& node) {
  constexpr double lowest = 100, highest = 6000, spacing = 5;  // K
  const CaseTable table(node, {"cold_density", "solid", "liquid", "transformation"});
  const double cold = core::positive(table.get("cold_density"), dimension::density);
  const double solid = read_coefficient(table.get("solid")), liquid = read_coefficient(table.get("liquid"));
  const double transformation = core::quantity(table.get("transformation"), dimension::temperature);
  if (transformation < core::room_temperature || transformation > highest)
    core::refuse(table.get("transformation"),
                 fmt::format("\"{}\" was found, allowed is {:g} to {:g} degC", table.get("transformation").text,
                             celsius(core::room_temperature), celsius(highest)));
  core::Table density;
  const auto add = [&](double T) {
    const double strain =
        solid * (std::min(T, transformation) - core::room_temperature) + liquid * std::max(0.0, T - transformation);
    density.x.push_back(T);
    density.y.push_back(cold * std::exp(-3 * strain));
  };
  for (double T = lowest; T < transformation; T += spacing) add(T);
  for (double T = transformation; T <= highest; T += spacing) add(T);
  return relative_to_first(density);
}

}  // namespace

Density read_density(const CaseTable& material) {
  const CaseNode* expansion = material.find("expansion");
  if (expansion && !material.find("density")) return read_expansion(*expansion);
  const CaseNode& given = material.get("density");
  if (given.kind == CaseNode::Kind::list) return read_points(given);
  return {core::positive(given, dimension::density)};
}

void relate_density(const std::function<double(const core::Table&)>& mean, Glass& glass) {
  if (glass.relative_density().x.empty()) return;
  const double relative = mean(glass.relative_density());
  const auto relate = [&](auto& material) {
    if (!material) return;
    material->density *= relative;
    for (double& value : material->relative_density.y) value /= relative;
  };
  relate(glass.thermal);
  relate(glass.flow);
}

void check_density(const Scene& scene, const CaseNode& glass) {
  if (!scene.expands()) return;
  constexpr double slack = 1e-6;  // K
  const core::Table density = scene.glass.relative_density();
  const TemperatureRange range = temperature_range(scene);
  const double coldest = std::min(core::room_temperature, range.min_temperature), hottest = range.max_temperature;
  if (density.x.front() <= coldest + slack && density.x.back() >= hottest - slack) return;
  core::refuse(
      CaseTable(glass, glass_keys()).get("material"),
      fmt::format("the density of the glass is given from {:.4g} to {:.4g} degC, allowed are tables from {:.4g} "
                  "to {:.4g} degC: all temperatures of the case, and 20 degC at which a container is measured",
                  celsius(density.x.front()), celsius(density.x.back()), celsius(coldest), celsius(hottest)));
}

}  // namespace parison::forming
