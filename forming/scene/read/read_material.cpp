// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>

#include "forming/scene/read/scene_reading.hpp"
#include "thermal/radiation/fresnel.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

/// A property over temperature, above zero everywhere.
core::Table property(const CaseNode& node, const core::Dimension& dimension) {
  const auto table = core::quantity_table(node, dimension::temperature, dimension);
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

flow::Viscosity read_viscosity(const CaseNode& node) {
  flow::Viscosity viscosity;
  if (law_of(node, {"constant", "vft"}) == 0) {
    viscosity.constant = core::positive(CaseTable(node, {"law", "value"}).get("value"), dimension::viscosity);
  } else {
    const CaseTable table(node, {"law", "A", "B", "T0"});
    viscosity.A = core::quantity(table.get("A"), dimension::none);
    constexpr double largest = 30;
    if (std::abs(viscosity.A) > largest)
      core::refuse(table.get("A"), fmt::format("{} was found, allowed are values from -{} to {}: the logarithm to base "
                                               "10 of a viscosity in Pa.s",
                                               viscosity.A, largest, largest));
    viscosity.B = core::positive(table.get("B"), dimension::temperature_difference);
    viscosity.T0 = core::quantity(table.get("T0"), dimension::temperature);
  }
  return viscosity;
}

flow::Carreau read_shear_thinning(const CaseNode& node) {
  const CaseTable table(node, {"time", "exponent"});
  return {core::positive(table.get("time"), dimension::time), core::positive(table.get("exponent"), dimension::none)};
}

NamedMaterial read_material(const CaseNode& node) {
  const CaseTable table(node, {"density", "heat_capacity", "conductivity", "radiation", "viscosity", "shear_thinning",
                               "surface_tension", "emissivity"});
  NamedMaterial material;
  material.name = core::identifier(core::key_of(node));
  const double density = core::positive(table.get("density"), dimension::density);
  if (table.find("conductivity") || table.find("heat_capacity")) {
    material.thermal.emplace();
    material.thermal->density = density;
    material.thermal->conductivity = property(table.get("conductivity"), dimension::conductivity);
    material.thermal->heat_capacity = property(table.get("heat_capacity"), dimension::heat_capacity);
    if (const auto* radiation = table.find("radiation")) material.thermal->radiation = read_radiation(*radiation);
  }
  if (const auto* viscosity = table.find("viscosity")) {
    material.flow.emplace();
    material.flow->density = density;
    material.flow->viscosity = read_viscosity(*viscosity);
    if (const auto* carreau = table.find("shear_thinning"))
      material.flow->shear_thinning = read_shear_thinning(*carreau);
    if (const auto* tension = table.find("surface_tension"))
      material.flow->surface_tension = core::not_negative(*tension, dimension::surface_tension);
  }
  for (const auto* key : {"radiation", "emissivity"})
    if (const auto* item = table.find(key); item && !material.thermal)
      core::refuse(
          *item, "the material carries no heat, this key is allowed only together with conductivity and heat_capacity");
  for (const auto* key : {"shear_thinning", "surface_tension"})
    if (const auto* item = table.find(key); item && !material.flow)
      core::refuse(*item, "the material does not flow, this key is allowed only together with viscosity");
  if (material.thermal && thermal::has_light(*material.thermal))
    material.emissivity = thermal::surface_emissivity(material.thermal->radiation->refractive_index);
  if (const auto* emissivity = table.find("emissivity")) {
    material.has_emissivity = true;
    material.emissivity = core::not_negative(*emissivity, dimension::none);
    if (material.emissivity > 1)
      core::refuse(*emissivity, fmt::format("{:g} was found, allowed is 0 to 1", material.emissivity));
  }
  return material;
}

}  // namespace

std::vector<NamedMaterial> read_materials(const CaseNode& node) {
  std::vector<NamedMaterial> materials;
  for (const auto& item : core::entries(node)) materials.push_back(read_material(item));
  return materials;
}

}  // namespace parison::forming
