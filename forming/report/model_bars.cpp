// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/model_bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/json_read.hpp"
#include "core/math/numbers.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/scene/law_names.hpp"
#include "forming/scene/radiation_choice.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// The text of calibration.json; the build makes the file that defines it.
extern const char* const calibration_text;

namespace {

/// The largest of the known ones; NaN where none is.
double largest_of(const core::JsonValue& scenes, const std::string& model, const char* key) {
  double largest = core::none;
  for (const core::JsonValue& scene : scenes.items)
    if (const core::JsonValue* models = scene.find("models"))
      if (const core::JsonValue* found = models->find(model)) largest = std::fmax(largest, found->number_of(key));
  return largest;
}

/// In the unit of the quantity.
double moved(const Quantities& run, const Quantity& quantity, const ModelDifference& by) {
  if (quantity.name == "thickness_mean") return by.thickness * quantity.value;
  if (quantity.name == "thickness_min") return by.thinnest * quantity.value;
  if (quantity.name.rfind("glass_", 0) == 0) return by.temperature;
  if (quantity.name.rfind("heat_", 0) == 0) return by.heat * size_of_kind(run, quantity);
  return core::none;
}

/// With two digits, or all before the point.
std::string amount(double size) {
  return size < 100 ? fmt::format("{:.2g}", size) : fmt::format("{:.0f}", size);
}

/// The law of most contacts, the simplest of those where as many have others.
const char* law_of_contacts(const std::vector<Interface>& interfaces) {
  std::array<std::ptrdiff_t, law_names.size()> count{};
  for (const Interface& interface : interfaces) ++count[interface.law.index()];
  return law_names[static_cast<std::size_t>(std::max_element(count.begin(), count.end()) - count.begin())];
}

/// Where the glass is pressed: without flow there is no pressure for a law to follow. A table is the user's own.
void add_contact(const Scene& scene, std::vector<ModelUse>& models) {
  if (!scene.has_flow() || scene.interfaces.empty()) return;
  const std::string used = law_of_contacts(scene.interfaces);
  models.push_back({"contact", used, used == "table" ? used : "pressure-viscosity"});
}

std::vector<ModelDifference> differences_of(const std::vector<ModelUse>& models) {
  std::vector<ModelDifference> differences;
  for (const ModelUse& model : models)
    if (model.used != model.best)
      differences.push_back(model_difference(calibration_text, model.part + "_models", model.used));
  return differences;
}

}  // namespace

ModelDifference model_difference(const std::string& calibration, const std::string& part, const std::string& model) {
  const core::JsonValue root = core::read_json(calibration, "calibration.json");
  const core::JsonValue* measured = root.find(part);
  const core::JsonValue* scenes = measured ? measured->find("scenes") : nullptr;
  if (!scenes) return {core::none, core::none, core::none, core::none};
  const auto largest = [&](const char* key) { return largest_of(*scenes, model, key); };
  return {largest("thickness"), largest("thinnest"), largest("heat"), largest("skin_K")};
}

void add_model_bars(const std::vector<ModelDifference>& differences, Quantities& quantities) {
  for (Quantity& quantity : quantities.values) {
    quantity.model = 0;
    for (const ModelDifference& by : differences) quantity.model += moved(quantities, quantity, by);
  }
}

void add_models(const Scene& scene, Quantities& quantities) {
  quantities.models = models_of(scene);
  add_model_bars(differences_of(quantities.models), quantities);
}

std::vector<ModelUse> models_of(const Scene& scene) {
  std::vector<ModelUse> models;
  if (!scene.has_heat()) return models;
  models.push_back({"radiation", model_name(scene.glass.thermal->radiation), "transfer"});
  add_contact(scene, models);
  if (scene.has_flow())
    models.push_back({"density", scene.glass.relative_density().x.empty() ? "constant" : "expansion", "expansion"});
  if (scene.geometry == core::Geometry::axisymmetric && (scene.has_light() || scene.glass.emissivity > 0))
    models.push_back({"enclosure", scene.enclosure ? "true" : "false", "true"});
  return models;
}

std::string model_text(double model) {
  return std::isnan(model) ? "?" : model == 0 ? "-" : amount(model);
}

std::string models_text(const std::vector<ModelUse>& models) {
  std::string text;
  for (const ModelUse& model : models)
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", model.part, model.used,
                        model.used == model.best ? "" : fmt::format(" (best: {})", model.best));
  return text;
}

std::string models_move_text(const std::vector<ModelUse>& models) {
  const std::vector<ModelDifference> differences = differences_of(models);
  if (differences.empty()) return {};
  ModelDifference sum{0, 0, 0, 0};
  for (const ModelDifference& by : differences)
    sum = {sum.thickness + by.thickness, sum.thinnest + by.thinnest, sum.heat + by.heat,
           sum.temperature + by.temperature};
  std::string text;
  const auto add = [&](const char* what, double size, const char* unit) {
    if (std::isfinite(size)) text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", what, amount(size), unit);
  };
  add("wall", 100 * sum.thickness, "%");
  add("thinnest place", 100 * sum.thinnest, "%");
  add("heat into tools", 100 * sum.heat, "%");
  add("skins", sum.temperature, "K");
  return text.empty() ? "not measured" : text + ", at most where measured";
}

}  // namespace parison::forming
