// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/math/numbers.hpp"
#include "forming/flow/viscosity/composition.hpp"
#include "forming/scene/materials/material_library.hpp"
#include "forming/scene/read/read_density.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "thermal/radiation/fresnel.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

/// A property over temperature, above zero everywhere.
core::Table property(const CaseNode& node, const core::Dimension& x, const core::Dimension& y) {
  require_few_pairs(node);
  const auto table = core::quantity_table(node, x, y);
  for (const double value : table.y)
    if (!(value > 0)) core::refuse(node, fmt::format("{:g} was found, allowed are values above zero", value));
  return table;
}

/// The index of a table's law among the allowed ones.
int law_of(const CaseNode& node, const std::vector<std::string>& allowed) {
  for (const auto& item : core::entries(node))
    if (item.name == "law") return core::choice(item, allowed);
  return core::choice(CaseTable(node, {"law"}).get("law"), allowed);
}

flow::Viscosity read_vft(const CaseNode& node) {
  const CaseTable table(node, {"law", "A", "B", "T0"});
  flow::Viscosity viscosity;
  viscosity.A = core::quantity(table.get("A"), dimension::none);
  constexpr double largest = 30;
  if (std::abs(viscosity.A) > largest)
    core::refuse(table.get("A"), fmt::format("{} was found, allowed are values from -{} to {}: the logarithm to base "
                                             "10 of a viscosity in Pa.s",
                                             viscosity.A, largest, largest));
  viscosity.B = core::positive(table.get("B"), dimension::temperature_difference);
  viscosity.T0 = core::quantity(table.get("T0"), dimension::temperature);
  return viscosity;
}

/// Measured points [["1200 degC", "101 Pa.s"], ...].
flow::Viscosity read_points(const CaseNode& node) {
  const auto& points = CaseTable(node, {"law", "points"}).get("points");
  core::list(points);
  const core::Table table = property(points, dimension::temperature, dimension::viscosity);
  if (table.x.size() < 2)
    core::refuse(points, "one point was found, allowed are two or more pairs of a temperature and a viscosity");
  for (std::size_t i = 1; i < table.y.size(); ++i)
    if (!(table.y[i] < table.y[i - 1]))
      core::refuse(points.items[i], fmt::format("{:g} Pa.s is not below the {:g} Pa.s before it, allowed are "
                                                "viscosities that fall with the temperature",
                                                table.y[i], table.y[i - 1]));
  flow::Viscosity viscosity;
  viscosity.table.emplace(table.x, table.y);
  return viscosity;
}

double share_of(const CaseNode& oxide, const flow::OxideRange& range) {
  const double share = core::not_negative(oxide, dimension::none);
  if (share < range.least - core::round_off || share > range.most + core::round_off)
    core::refuse(oxide, fmt::format("{:.4g} % was found, allowed are {:.4g} to {:.4g} %, the range of the glasses that "
                                    "the model of Lakatos rests on; give the viscosity by vft or table",
                                    100 * share, 100 * range.least, 100 * range.most));
  return share;
}

/// Shares by mass of the oxides.
flow::Viscosity read_composition(const CaseNode& node) {
  const auto& oxides = CaseTable(node, {"law", "oxides"}).get("oxides");
  std::vector<std::string> names;
  for (const auto& range : flow::oxide_ranges()) names.push_back(range.name);
  const CaseTable table(oxides, names);
  flow::Composition composition;
  double sum = 0;
  for (const auto& range : flow::oxide_ranges()) {
    const auto* oxide = range.least > 0 ? &table.get(range.name) : table.find(range.name);
    if (oxide) sum += composition[range.name] = share_of(*oxide, range);
  }
  constexpr double least = 0.98, most = 1.005;
  if (sum < least || sum > most)
    core::refuse(oxides,
                 fmt::format("the oxides add up to {:.4g} %, allowed are {:g} to {:g} %; what is missing counts "
                             "as without effect",
                             100 * sum, 100 * least, 100 * most));
  return flow::viscosity_of(composition);
}

flow::Viscosity read_viscosity(const CaseNode& node) {
  switch (law_of(node, {"constant", "vft", "table", "composition"})) {
    case 0: {
      flow::Viscosity viscosity;
      viscosity.constant = core::positive(CaseTable(node, {"law", "value"}).get("value"), dimension::viscosity);
      return viscosity;
    }
    case 1:
      return read_vft(node);
    case 2:
      return read_points(node);
    default:
      return read_composition(node);
  }
}

flow::Carreau read_shear_thinning(const CaseNode& node) {
  const CaseTable table(node, {"time", "exponent"});
  return {core::positive(table.get("time"), dimension::time), core::positive(table.get("exponent"), dimension::none)};
}

/// Values without a source: their keys, or each with the range in which it is assumed and why.
void read_assumed(const CaseNode& node, const CaseTable& table, NamedMaterial& material) {
  std::vector<std::string> given;
  for (const auto& item : table.node().items) given.push_back(item.name);
  if (node.kind != CaseNode::Kind::table) {
    for (const auto& key : core::list(node)) {
      core::choice(key, given);
      material.assumed.push_back({key.text, ""});
    }
    return;
  }
  const CaseTable reasons(node, given);
  for (const auto& item : reasons.node().items) material.assumed.push_back({item.name, core::text(item)});
}

/// What is told about a material.
void read_notes(const CaseTable& table, NamedMaterial& material) {
  if (const auto* about = table.find("about")) material.about = core::text(*about);
  if (const auto* source = table.find("source")) material.source = core::text(*source);
  if (const auto* assumed = table.find("assumed")) read_assumed(*assumed, table, material);
}

void read_thermal(const CaseTable& table, const Density& density, NamedMaterial& material) {
  if (!table.find("conductivity") && !table.find("heat_capacity")) return;
  material.thermal.emplace();
  material.thermal->density = density.value;
  material.thermal->relative_density = density.relative;
  material.thermal->conductivity = property(table.get("conductivity"), dimension::temperature, dimension::conductivity);
  material.thermal->heat_capacity =
      property(table.get("heat_capacity"), dimension::temperature, dimension::heat_capacity);
  if (const auto* radiation = table.find("radiation")) material.thermal->radiation = read_radiation(*radiation);
}

void read_flow(const CaseTable& table, const Density& density, NamedMaterial& material) {
  const auto* viscosity = table.find("viscosity");
  if (!viscosity) return;
  material.flow.emplace();
  material.flow->density = density.value;
  material.flow->relative_density = density.relative;
  material.flow->viscosity = read_viscosity(*viscosity);
  if (const auto* carreau = table.find("shear_thinning")) material.flow->shear_thinning = read_shear_thinning(*carreau);
  if (const auto* tension = table.find("surface_tension"))
    material.flow->surface_tension = core::not_negative(*tension, dimension::surface_tension);
  const bool sets = !material.flow->viscosity.constant;
  if (const auto* annealing = table.find("annealing"); annealing && sets)
    material.annealing = read_annealing(*annealing, table, material.flow->viscosity);
}

/// Refuses a material that gives single values only, as if to change a bundled one.
void check_density(const CaseTable& table, const std::string& name) {
  if (table.find("density") || table.find("expansion")) return;
  const auto names = library_names();
  if (std::count(names.begin(), names.end(), name))
    core::refuse(table.node(), fmt::format("the density is missing; to change single values of the bundled material, "
                                           "add like = \"{}\"",
                                           name));
}

core::Table read_emissivity(const CaseNode& node) {
  const bool varies = node.kind == CaseNode::Kind::list;
  core::Table table = core::quantity_table(node, dimension::temperature, dimension::none);
  for (std::size_t i = 0; i < table.y.size(); ++i)
    if (!(table.y[i] >= 0 && table.y[i] <= 1))
      core::refuse(varies ? node.items[i].items[1] : node,
                   fmt::format("{:g} was found, allowed is 0 to 1", table.y[i]));
  return table;
}

NamedMaterial read_material(const CaseNode& node) {
  const CaseTable table(
      node, {"density", "expansion", "heat_capacity", "conductivity", "radiation", "viscosity", "shear_thinning",
             "surface_tension", "annealing", "emissivity", "like", "about", "source", "assumed"});
  NamedMaterial material;
  material.name = core::identifier(core::key_of(node));
  read_notes(table, material);
  check_density(table, material.name);
  const Density density = read_density(table);
  read_thermal(table, density, material);
  read_flow(table, density, material);
  for (const auto* key : {"radiation", "emissivity"})
    if (const auto* item = table.find(key); item && !material.thermal)
      core::refuse(
          *item, "the material carries no heat, this key is allowed only together with conductivity and heat_capacity");
  for (const auto* key : {"shear_thinning", "surface_tension", "annealing"})
    if (const auto* item = table.find(key); item && !material.flow)
      core::refuse(*item, "the material does not flow, this key is allowed only together with viscosity");
  if (material.thermal && thermal::has_light(*material.thermal))
    material.emissivity = core::constant(thermal::surface_emissivity(material.thermal->radiation->refractive_index));
  if (const auto* emissivity = table.find("emissivity")) {
    material.has_emissivity = true;
    material.emissivity = read_emissivity(*emissivity);
  }
  return material;
}

}  // namespace

void require_few_pairs(const CaseNode& table) {
  constexpr std::size_t most = 1000;
  if (table.items.size() > most)
    core::refuse(table, fmt::format("{} pairs were found, allowed are up to {}", table.items.size(), most));
}

std::vector<NamedMaterial> read_materials(const CaseNode& node) {
  std::vector<NamedMaterial> materials;
  for (const auto& item : core::entries(node)) materials.push_back(read_material(item));
  return materials;
}

}  // namespace parison::forming
