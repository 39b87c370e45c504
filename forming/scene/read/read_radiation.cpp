// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

/// Absorption of a band, 1/m. Less is that of no glass; where more is absorbed the light dies within less than a first
/// cell, and the glass counts as opaque.
constexpr double min_absorption = 0.1, max_absorption = 2000;
constexpr std::size_t max_bands = 20;

/// An absorption coefficient, 1/m, and what it is at other temperatures, K, as a multiple of it.
struct Absorption {
  double first;
  core::Table relative;  ///< empty where it does not depend on temperature
};

Absorption relative_to_first(core::Table table) {
  const double first = table.y.front();
  for (double& y : table.y) y /= first;
  return {first, std::move(table)};
}

/// A quantity, or a list of [temperature, quantity]; `check` is called with each and where it stands.
template <typename Check>
Absorption read_absorption(const CaseNode& node, const Check& check) {
  require_few_pairs(node);
  core::Table table = core::quantity_table(node, dimension::temperature, dimension::inverse_length);
  const bool varies = node.kind == CaseNode::Kind::list;
  for (std::size_t i = 0; i < table.y.size(); ++i) check(table.y[i], varies ? node.items[i].items[1] : node);
  Absorption absorption = relative_to_first(std::move(table));
  if (!varies) absorption.relative = {};
  return absorption;
}

thermal::Band read_band(const CaseNode& node, double from, bool last) {
  const CaseTable table(node, {"up_to", "absorption"});
  thermal::Band band{std::numeric_limits<double>::infinity(), 0};
  if (const auto* up_to = last ? table.find("up_to") : &table.get("up_to")) {
    band.up_to = core::positive(*up_to, dimension::length);
    if (band.up_to <= from)
      core::refuse(*up_to, fmt::format("\"{}\" was found, allowed are wavelengths above {:g} um, where the band before "
                                       "ends",
                                       up_to->text, 1e6 * from));
  }
  const auto absorption = read_absorption(table.get("absorption"), [](double value, const CaseNode& at) {
    if (value < min_absorption || value > max_absorption)
      core::refuse(at, fmt::format("\"{}\" was found, allowed are {:g} to {:g} 1/m; a glass that absorbs more is "
                                   "opaque: end the bands before it",
                                   at.text, min_absorption, max_absorption));
  });
  band.absorption = absorption.first;
  band.relative = absorption.relative;
  return band;
}

/// The bands of a bundled glass by its name.
std::vector<thermal::Band> library_bands(const CaseNode& node) {
  std::vector<std::string> names;
  for (const NamedMaterial& material : library_materials())
    if (material.thermal && material.thermal->radiation && !material.thermal->radiation->bands.empty())
      names.push_back(material.name);
  const std::string& name = names[static_cast<std::size_t>(core::choice(node, names))];
  for (const NamedMaterial& material : library_materials())
    if (material.name == name) return material.thermal->radiation->bands;
  return {};
}

std::vector<thermal::Band> read_bands(const CaseNode& node) {
  if (node.kind == CaseNode::Kind::text) return library_bands(node);
  const auto& items = core::list(node);
  if (items.empty() || items.size() > max_bands)
    core::refuse(node, fmt::format("{} bands were found, allowed are 1 to {}", items.size(), max_bands));
  std::vector<thermal::Band> bands;
  bands.reserve(items.size());
  for (const CaseNode& item : items)
    bands.push_back(read_band(item, bands.empty() ? 0 : bands.back().up_to, &item == &items.back()));
  return bands;
}

/// The error that a model chosen by `auto` may have, a share.
double read_within(const CaseNode& node) {
  constexpr double least = 1e-4, most = 1;
  const double within = core::positive(node, dimension::none);
  if (within < least || within > most)
    core::refuse(node, fmt::format("\"{}\" was found, allowed are errors from {:g} % to {:g} %", node.text, 100 * least,
                                   100 * most));
  return within;
}

/// The material of the glass in the table of materials; null where the case has none of that name.
CaseNode* material_of_glass(core::CaseFile& file) {
  CaseNode* glass = member(file.root, "glass");
  const CaseNode* name = glass ? member(*glass, "material") : nullptr;
  CaseNode* materials = member(file.root, "material");
  return name && materials ? member(*materials, name->text) : nullptr;
}

/// Models cheaper than `transfer` that a case has the keys of. With an enclosure P1 is none of them.
std::vector<std::string> allowed_models(core::CaseFile& file, CaseNode& material) {
  std::vector<std::string> allowed;
  if (member(material, "emissivity")) allowed.push_back("rosseland");
  const CaseNode* enclosure = member(file.root, "enclosure");
  if (enclosure && !enclosure->flag) allowed.insert(allowed.end(), {"p1", "p1_cones"});
  return allowed;
}

/// The node of `radiation.model`, which is `auto` where a glass with bands has none.
CaseNode* model_of(CaseNode& radiation) {
  CaseNode* model = member(radiation, "model");
  if (model || !member(radiation, "bands")) return model;
  CaseNode automatic = radiation;
  automatic.kind = CaseNode::Kind::text;
  automatic.name = "model";
  automatic.text = "auto";
  automatic.items.clear();
  const auto after = std::find_if(radiation.items.begin(), radiation.items.end(),
                                  [](const CaseNode& item) { return item.name > "model"; });
  return &*radiation.items.insert(after, automatic);
}

}  // namespace

std::optional<RadiationChoice> choose_radiation(core::CaseFile& file, const AccuracyChoice& accuracy) {
  CaseNode* material = material_of_glass(file);
  CaseNode* radiation = material ? member(*material, "radiation") : nullptr;
  CaseNode* model = radiation ? model_of(*radiation) : nullptr;
  if (!model || model->text != "auto") return {};
  read_radiation(*radiation);  // has what every model needs, or is refused
  const CaseNode* within = member(*radiation, "within");
  const double asked = within ? read_within(*within) : accuracy.target.value_or(expected_error(accuracy.level));
  RadiationChoice choice{
      material->name, asked,
      cheapest_model(ranked_models(calibration().radiation), allowed_models(file, *material), asked)};
  model->text = choice.model.name;
  return choice;
}

std::optional<thermal::Radiation> read_radiation(const CaseNode& node) {
  const CaseTable table(node, {"model", "within", "refractive_index", "absorption", "thin_wall", "bands"});
  enum { none, rosseland, p1, p1_cones, transfer, automatic };
  const auto* named = table.find("model");
  const int model = named ? core::choice(*named, {"none", "rosseland", "p1", "p1_cones", "transfer", "auto"})
                    : table.find("bands") ? automatic
                                          : rosseland;
  if (const auto* within = table.find("within")) read_within(*within);
  // What another model needs may stand beside it, so that a case can be run with each; it is read all the same.
  const auto wanted = [&](const char* key, bool needed) { return needed ? &table.get(key) : table.find(key); };
  thermal::Radiation radiation{1, 0, false};
  if (const auto* index = model == none ? table.find("refractive_index") : &table.get("refractive_index")) {
    radiation.refractive_index = core::positive(*index, dimension::none);
    if (radiation.refractive_index < 1)
      core::refuse(*index,
                   fmt::format("{:g} was found, allowed are refractive indices from 1", radiation.refractive_index));
  }
  if (const auto* bands = wanted("bands", model >= p1)) radiation.bands = read_bands(*bands);
  if (const auto* mean = wanted("absorption", model == rosseland && radiation.bands.empty())) {
    const auto absorption =
        read_absorption(*mean, [](double, const CaseNode& at) { core::positive(at, dimension::inverse_length); });
    radiation.absorption = absorption.first;
    radiation.relative = absorption.relative;
  } else if (!radiation.bands.empty()) {
    const auto absorption = relative_to_first(thermal::rosseland_absorption(radiation.bands));
    radiation.absorption = absorption.first;
    radiation.relative = absorption.relative;
  }
  if (const auto* thin_wall = wanted("thin_wall", model == rosseland && radiation.bands.empty()))
    radiation.thin_wall = core::flag(*thin_wall);
  if (model == none) return {};
  if (model == p1) radiation.model = thermal::Radiation::Model::p1;
  if (model == p1_cones) radiation.model = thermal::Radiation::Model::p1_cones;
  if (model >= transfer) radiation.model = thermal::Radiation::Model::transfer;
  return radiation;
}

}  // namespace parison::forming
