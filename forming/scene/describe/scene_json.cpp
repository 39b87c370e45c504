// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/scene_json.hpp"

#include "core/math/numbers.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/describe/unusual.hpp"

namespace parison::forming {
namespace {

constexpr double gram = 1e-3;

void add_point(const core::Point& x, core::JsonWriter& json) {
  json.add("", x[0] / core::millimetre);
  json.add("", x[1] / core::millimetre);
}

void add_if(const char* key, const std::optional<double>& value, double unit, core::JsonWriter& json) {
  if (value) json.add(key, *value / unit);
}

void add_container(const Scene& scene, const ContainerPlan& plan, core::JsonWriter& json) {
  json.open_object("container");
  add_if("mould_cm3", plan.outside, core::millilitre, json);
  add_if("capacity_ml", plan.capacity, core::millilitre, json);
  add_if("rim_mm", plan.rim, core::millimetre, json);
  add_if("filled_ml", plan.filled, core::millilitre, json);
  if (plan.filled) json.add("ullage_ml", (*plan.capacity - *plan.filled) / core::millilitre);
  if (const auto& press = plan.press) {
    json.open_object("press");
    json.add("tool", scene.tools[static_cast<std::size_t>(press->tool)].name);
    json.add("stage", scene.stages[static_cast<std::size_t>(press->stage)].name);
    json.add("driven", press->is_driven);
    json.add("stop_mm", press->stop / core::millimetre);
    json.add("cavity_cm3", press->cavity / core::millilitre);
    json.close();
  }
  json.add("misfit", plan.misfit);
  if (plan.doubt > most_doubt) json.add("doubt", plan.doubt);
  json.close();
  json.open_list("clearance");
  for (const ParisonClearance& one : parison_clearance(scene, plan)) {
    json.open_list("");
    add_point(one.at, json);
    json.add("", one.clearance / core::millimetre);
    json.close();
  }
  json.close();
}

void add_body(const Body& body, core::JsonWriter& json) {
  const double size = core::size(body.profile);
  json.open_object("");
  json.add("name", body.name);
  json.add("position_mm", body.position / core::millimetre);
  json.open_list("outline_mm");  // r, z, r, z, ... where the body is drawn
  for (const core::Point& x : core::polyline(body.profile, size, 2e-4 * size)) add_point(x, json);
  json.close();
  json.open_list("corners_mm");
  for (const core::Segment& segment : body.profile.segments) add_point(segment.start, json);
  json.close();
  json.close();
}

void add_stage(const Scene& scene, std::size_t i, core::JsonWriter& json) {
  const Stage& stage = scene.stages[i];
  json.open_object("");
  json.add("name", stage.name);
  json.add("duration_s", stage.duration);
  json.add("upright", is_upright(scene, i));
  if (stage.timed) json.add("until", stage.timed->until_event);
  json.open_list("tools");
  for (const StageTool& tool : stage.tools) json.add("", scene.tools[static_cast<std::size_t>(tool.tool)].name);
  json.close();
  json.close();
}

}  // namespace

void add_scene(const Scene& scene, core::JsonWriter& json) {
  const DimensionlessNumbers numbers = dimensionless_numbers(scene);
  json.add("name", scene.name);
  json.add("axisymmetric", scene.geometry == core::Geometry::axisymmetric);
  json.add("weight_g", numbers.mass / gram);
  json.add("volume_cm3", numbers.volume / core::millilitre);
  if (scene.container) add_container(scene, *scene.container, json);
  json.open_list("findings");
  for (const std::string& note : unusual_values(scene)) json.add("", note);
  json.close();
  json.open_list("bodies");
  add_body(scene.glass, json);
  for (const Tool& tool : scene.tools) add_body(tool, json);
  json.close();
  if (scene.timing) json.add("cycle_s", scene.timing->cycle);
  json.open_list("stages");
  for (std::size_t i = 0; i < scene.stages.size(); ++i) add_stage(scene, i, json);
  json.close();
}

}  // namespace parison::forming
