// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_error.hpp"
#include "core/process/run_error.hpp"
#include "forming/run/stage.hpp"
#include "forming/scene/describe/scene_json.hpp"
#include "tools/workbench/answers/workbench_state.hpp"
#include "tools/workbench/contour/given_contour.hpp"
#include "tools/workbench/handles/handles.hpp"

namespace parison::tools {
std::vector<std::string> assignments_of(const OpenCase& one, const Asked& asked) {
  std::vector<std::string> assignments;
  if (const Asked* set = asked.find("set"))
    for (const Asked& item : set->items) assignments.push_back(item.text);
  if (const Asked* corner = asked.find("corner")) {
    constexpr double mm = 1e-3;
    const auto handles = corner_handles(one.file(), forming::read_scene(one.file(), "draft"));
    return moved_corner(handles, corner->number_of("number"),
                        mm * core::Point(corner->number_of("r_mm"), corner->number_of("z_mm")));
  }
  if (const Asked* contour = asked.find("contour")) {
    const auto text = [&](const char* key) { return contour->text_of(key); };
    return given_contour(
        one.file(), text("key"),
        {text("file"), text("unit"), text("layer"), text("from"), text("via"), text("to"), text("origin"), text("axis"),
         text("turn"), text("thickness"), contour->flag_of("as_points"), contour->flag_of("with_sections")});
  }
  return assignments;
}

void add_check(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  const OpenCase& one = state.open(asked.text_of("case"));
  json.add("version", one.version());
  const std::lock_guard<std::mutex> lock(state.reading);
  try {
    const forming::Scene scene = forming::read_scene(one.file(), "draft", assignments_of(one, asked));
    forming::add_scene(scene, json);
    if (asked.flag_of("meshes")) json.add("cannot_begin", forming::first_stage_failure(scene));
  } catch (const core::CaseError& error) {
    add_error(error, one.text(), json);
  }
}

void add_handles(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  constexpr double mm = 1e-3;
  const OpenCase& one = state.open(asked.text_of("case"));
  json.add("version", one.version());
  const std::lock_guard<std::mutex> lock(state.reading);
  const forming::Scene scene = forming::read_scene(one.file(), "draft");
  add_dimension_handles(one.file(), scene, json);
  json.open_list("corners");
  for (const CornerHandle& corner : corner_handles(one.file(), scene)) {
    const core::Point at = corner.at + corner.position * core::axis_direction();
    json.open_object("");
    json.add("tool", corner.tool);
    json.add("r_mm", at[0] / mm);
    json.add("z_mm", at[1] / mm);
    json.close();
  }
  json.close();
}

}  // namespace parison::tools
