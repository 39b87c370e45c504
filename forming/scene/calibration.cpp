// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/calibration.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "core/io/json_read.hpp"

namespace parison::forming {

/// The text of calibration.json; the build makes the file that defines it.
extern const char* const calibration_text;

namespace {

using core::JsonValue;

constexpr const char* source = "calibration.json";

const JsonValue& member(const JsonValue& object, const std::string& name) {
  const JsonValue* found = object.find(name);
  if (!found) throw std::runtime_error(fmt::format("{}: \"{}\" is missing", source, name));
  return *found;
}

double number(const JsonValue& object, const std::string& name) {
  const double value = member(object, name).number;
  if (!std::isfinite(value)) throw std::runtime_error(fmt::format("{}: \"{}\" is no number", source, name));
  return value;
}

ErrorLaw error_law(const JsonValue& object) {
  return {number(object, "at_draft"), number(object, "order")};
}

MeasuredRadiation measured_radiation(const JsonValue& object) {
  const auto& scenes = member(object, "scenes").items;
  MeasuredRadiation measured{member(object, "commit").text, member(object, "date").text, {}};
  for (const JsonValue& scene : scenes) {
    auto& models = measured.scenes.emplace_back();
    for (const JsonValue& model : member(scene, "models").items)
      models[model.name] = {number(model, "thickness"), number(model, "heat"), number(model, "cost")};
  }
  if (scenes.empty()) throw std::runtime_error(fmt::format("{}: \"scenes\" has no scene", source));
  return measured;
}

}  // namespace

double ErrorLaw::at(double level) const {
  return at_draft * std::exp2(-order * level);
}

Calibration read_calibration(const std::string& json) {
  const JsonValue root = core::read_json(json, source);
  const JsonValue &law = member(root, "error_law"), &parts = member(root, "model_parts");
  const JsonValue& shapes = member(root, "model_shapes");
  Calibration result;
  result.error_law = {error_law(member(law, "thickness")), error_law(member(law, "heat"))};
  result.model_parts = {number(parts, "duration_s"), {}};
  for (const JsonValue& part : member(parts, "parts").items)
    result.model_parts.parts[part.name] = {number(part, "number"), number(part, "thickness"), number(part, "heat")};
  result.model_shapes = {number(shapes, "pressed_freedom"), number(shapes, "pressed_open_heat"),
                         number(shapes, "heat_of_strain")};
  result.radiation = measured_radiation(member(root, "radiation_models"));
  return result;
}

const Calibration& calibration() {
  static const Calibration own = read_calibration(calibration_text);
  return own;
}

}  // namespace parison::forming
