// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/describe/unusual.hpp"

namespace parison::forming {
namespace {

/// Whether glass is pressed by a force or blown.
bool forms_a_container(const Scene& scene) {
  return std::any_of(scene.stages.begin(), scene.stages.end(),
                     [](const Stage& stage) { return stage.has_driven_tool() || stage.blows(); });
}

/// Why no press cavity is known although a force drives a tool, empty where none does or the misfit says it.
std::string why_no_press(const Scene& scene, const ContainerPlan& plan) {
  if (!plan.misfit.empty()) return "";
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    for (const StageTool& tool : scene.stages[i].tools) {
      if (!tool.is_driven()) continue;
      const std::string &name = scene.tools[static_cast<std::size_t>(tool.tool)].name, &stage = scene.stages[i].name;
      if (has_moved_before(scene, static_cast<Index>(i), tool.tool))
        return fmt::format("none found: \"{}\" moves before stage \"{}\", where a force drives it", name, stage);
      return fmt::format(
          "none found: from where \"{}\" starts, in the direction of its force, the drawings close none with the other "
          "tools of stage \"{}\"",
          name, stage);
    }
  return "";
}

std::string why_no_capacity(const Scene& scene, const ContainerPlan& plan) {
  const Stage& last = last_forming_stage(scene);
  if (last.gravity == 0)
    return fmt::format("not known: the last stage, \"{}\", has no gravity that says which end is the rim", last.name);
  if (plan.press) return "none: the glass of the press cavity has no hollow that would hold a liquid as it stands";
  return fmt::format(
      "not known before a run: {} in the last stage, \"{}\", and no press cavity gives the inside; a run measures it",
      last.tools.empty() ? "no tool is there" : "the tools leave the mouth or another opening of their cavity open",
      last.name);
}

}  // namespace

std::string place_in_mm(double place) {
  constexpr double hundredths = 1e5;
  return fmt::format("{:.12g}", std::round(hundredths * place) / 100 + 0.0);  // + 0.0 makes 0 of -0
}

std::string describe_container(const Scene& scene) {
  const auto& plan = scene.container;
  if (!plan) return "";
  std::string text = fmt::format("\ncontainer, from the drawings\n  {:<20}{:.4g} g\n", "weight", 1e3 * plan->mass);
  const auto line = [&](const char* label, const std::string& value) {
    text += fmt::format("  {:<20}{}\n", label, value);
  };
  if (plan->press) {
    const std::string& tool = scene.tools[plan->press->tool].name;
    line("press cavity", fmt::format("{:.4g} cm3 with \"{}\" at {:.5g} mm, {} of stage \"{}\"",
                                     1e6 * plan->press->cavity, tool, 1e3 * plan->press->stop,
                                     plan->press->is_driven ? "where it stops for this mass, the end" : "the end",
                                     scene.stages[plan->press->stage].name));
  } else if (const std::string why = why_no_press(scene, *plan); !why.empty())
    line("press cavity", why);
  if (plan->outside)
    line("mould",
         fmt::format("{:.5g} cm3 closed in stage \"{}\"", 1e6 * *plan->outside, last_forming_stage(scene).name));
  if (plan->capacity)
    line("capacity", fmt::format("{:.5g} ml to the rim at {} mm", 1e6 * *plan->capacity, place_in_mm(*plan->rim)));
  else if (forms_a_container(scene))
    line("capacity", why_no_capacity(scene, *plan));
  if (plan->filled)
    line("fill level", fmt::format("{:.5g} ml to {:.4g} mm below the rim, ullage {:.4g} ml", 1e6 * *plan->filled,
                                   1e3 * *scene.output.fill_level, 1e6 * (*plan->capacity - *plan->filled)));
  if (!plan->misfit.empty()) line("does not fit", plan->misfit);
  if (plan->doubt > most_doubt)
    line("contradiction",
         fmt::format("the volumes within the outlines and within chords of them differ by {:.2g} %: an "
                     "error of the program or of an outline, none of them is to be trusted",
                     100 * plan->doubt));
  return text;
}

}  // namespace parison::forming
