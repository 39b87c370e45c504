// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/unusual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/case/units.hpp"
#include "core/math/numbers.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/describe/support.hpp"
#include "forming/scene/read/temperature/temperature_table.hpp"

namespace parison::forming {
namespace {

/// Whether hot glass of one temperature is pressed or blown between tools, as a gob is.
bool forms_a_gob(const Scene& scene) {
  const auto works = [](const Stage& stage) { return stage.blows() || stage.has_driven_tool(); };
  return scene.has_flow() && scene.has_heat() && !scene.tools.empty() && !scene.glass.start_field &&
         std::any_of(scene.stages.begin(), scene.stages.end(), works);
}

void add_gob_temperature(const Scene& scene, std::vector<std::string>& notes) {
  constexpr double least = 100, most = 730;         // Pa.s: container glass at 1200 and 1050 degC
  constexpr double coldest = 1050, hottest = 1200;  // degC
  const flow::Viscosity& viscosity = scene.glass.flow->viscosity;
  const double kelvin = scene.glass.initial_temperature, eta = viscosity(kelvin);
  if (viscosity.constant || (eta >= least && eta <= most)) return;
  const bool is_swapped = kelvin >= coldest && kelvin <= hottest;
  notes.push_back(fmt::format(
      "the glass starts at {0:.4g} degC ({1:.4g} K), where its viscosity is {2:.3g} Pa.s; usual are gobs of {3:g} to "
      "{4:g} degC of container glass, {5:g} to {6:g} Pa.s{7}",
      kelvin - core::zero_celsius, kelvin, eta, coldest, hottest, least, most,
      is_swapped ? fmt::format("; was \"{:.4g} degC\" meant?", kelvin) : ""));
}

/// Whether a tool forms the glass, and does not only carry it while it cools.
bool forms(const Scene& scene, std::size_t tool) {
  return std::any_of(scene.stages.begin(), scene.stages.end(), [&](const Stage& stage) {
    return !stage.cools && std::any_of(stage.tools.begin(), stage.tools.end(),
                                       [&](const StageTool& one) { return one.tool == static_cast<Index>(tool); });
  });
}

/// Of tools around a gob what is unusual; of any others what no tool can have.
void add_tool_temperatures(const Scene& scene, bool is_around_gob, std::vector<std::string>& notes) {
  constexpr double coldest = 350, hottest = 600, iron_melts = 1150;  // degC; the eutectic of iron and graphite
  for (const Tool& tool : scene.tools) {
    const double celsius = tool.initial_temperature - core::zero_celsius;
    const bool is_around = is_around_gob && forms(scene, static_cast<std::size_t>(&tool - scene.tools.data()));
    const bool is_usual = is_around ? celsius >= coldest && celsius <= hottest : celsius < iron_melts;
    if (!tool.thermal || tool.start_field || is_usual) continue;
    std::string note = fmt::format("\"{}\" starts at {:.4g} degC", tool.name, celsius);
    if (celsius >= iron_melts) note += fmt::format(", but grey iron melts at {:g} degC and bronze below", iron_melts);
    if (is_around)
      note +=
          "; usual are 400 to 530 degC of moulds and blanks, 450 to 600 degC of rings and plungers, and 375 degC "
          "where cooling is strong";
    notes.push_back(std::move(note));
  }
}

void add_table_of_start(const Body& body, core::Geometry geometry, std::vector<std::string>& notes) {
  constexpr double little = 0.01;
  if (const double beyond = share_beyond_table(body, geometry); beyond > little)
    notes.push_back(fmt::format(
        "{:.0f} % of \"{}\" lies beyond the temperatures of {}, where the nearest of them count; usual are tables "
        "that cover the body",
        100 * beyond, body.name, body.start_field->source));
}

void add_pressures(const Scene& scene, std::vector<std::string>& notes) {
  constexpr double most = 3 * core::bar;
  for (const Stage& stage : scene.stages)
    for (const auto& [boundary, pressure] : stage.pressure)
      if (pressure.max() > most)
        notes.push_back(
            fmt::format("stage \"{}\" blows with {:.4g} bar on \"{}\"; usual are 0.3 to 2 bar, up to 3 bar to hold the "
                        "container in its mould",
                        stage.name, pressure.max() / core::bar, boundary));
}

void add_durations(const Scene& scene, std::vector<std::string>& notes) {
  constexpr double longest = 30;  // s
  for (const Stage& stage : scene.stages)
    if (!stage.cools && !stage.may_end_early() && stage.duration > longest)
      notes.push_back(
          fmt::format("stage \"{}\" takes {:.4g} s; usual are 10 to 13.4 s for the whole cycle of a section, 0.3 to "
                      "1.8 s of it for "
                      "a reheat",
                      stage.name, stage.duration));
}

/// A parison that leaves its blank is turned over before it is blown in its mould.
void add_gravity(const Scene& scene, std::vector<std::string>& notes) {
  const ContainerPlan& plan = *scene.container;
  if (!plan.parison) return;
  const Stage& formed = scene.stages[static_cast<std::size_t>(plan.parison->stage)];
  for (auto s = static_cast<std::size_t>(plan.parison->stage) + 1; s < scene.stages.size(); ++s) {
    const Stage& stage = scene.stages[s];
    const bool has_new_tool = std::any_of(stage.tools.begin(), stage.tools.end(),
                                          [&](const StageTool& tool) { return !formed.uses(tool.tool); });
    if (!stage.blows() || !has_new_tool || stage.gravity * formed.gravity <= 0) continue;
    notes.push_back(fmt::format(
        "gravity acts in stage \"{}\" as in \"{}\"; usual is a parison that is turned over between blank and mould: "
        "gravity of the other sign from the stage on in which it leaves the blank",
        stage.name, formed.name));
    return;
  }
}

void add_wall(const ContainerPlan& plan, std::vector<std::string>& notes) {
  if (!plan.outside || !plan.mould_range) return;
  constexpr double thinnest = 0.8e-3, thickest = 12e-3;  // m
  const double height = plan.mould_range->second - plan.mould_range->first;
  const double radius = std::sqrt(*plan.outside / (M_PI * height));  // of a cylinder that holds as much
  const double wall = plan.glass_volume / (M_PI * radius * (2 * height + radius));
  if (wall >= thinnest && wall <= thickest) return;
  notes.push_back(
      fmt::format("{:.4g} g of glass in a mould of {:.4g} cm3, {:.4g} mm high, make a wall of about {:.2g} mm on "
                  "average; usual are "
                  "1.8 to 5.8 mm, 1 mm in a thin bowl: are mass and dimensions of the mould as they are meant?",
                  1e3 * plan.mass, 1e6 * *plan.outside, 1e3 * height, 1e3 * wall));
}

void add_fill_level(const Scene& scene, const ContainerPlan& plan, std::vector<std::string>& notes) {
  const auto inside = inside_height(plan);
  if (!scene.output.fill_level || !inside || *scene.output.fill_level < *inside) return;
  notes.push_back(
      fmt::format("the fill level is {:.4g} mm below the rim, but the container is {:.4g} mm high: nothing can be "
                  "filled to there; usual are a few centimetres below the rim",
                  1e3 * *scene.output.fill_level, 1e3 * *inside));
}

void add_drawings(const Body& body, std::vector<std::string>& notes) {
  for (const std::string& note : body.drawing_notes) notes.push_back(fmt::format("\"{}\": {}", body.name, note));
}

}  // namespace

std::vector<std::string> unusual_values(const Scene& scene) {
  std::vector<std::string> notes;
  add_drawings(scene.glass, notes);
  for (const Tool& tool : scene.tools) add_drawings(tool, notes);
  const bool is_gob = forms_a_gob(scene);
  if (is_gob) add_gob_temperature(scene, notes);
  if (scene.has_heat()) add_tool_temperatures(scene, is_gob, notes);
  if (is_gob) add_durations(scene, notes);
  add_table_of_start(scene.glass, scene.geometry, notes);
  for (const Tool& tool : scene.tools) add_table_of_start(tool, scene.geometry, notes);
  add_pressures(scene, notes);
  for (auto& note : unusual_forces(scene)) notes.push_back(std::move(note));
  if (auto note = falling_note(scene); !note.empty()) notes.push_back(std::move(note));
  for (auto& note : gob_in_later_tools(scene)) notes.push_back(std::move(note));
  for (auto& note : faces_without_contact(scene)) notes.push_back(std::move(note));
  if (const auto& plan = scene.container) {
    add_wall(*plan, notes);
    add_gravity(scene, notes);
    add_fill_level(scene, *plan, notes);
    for (auto& note : tools_run_into(scene, *plan)) notes.push_back(std::move(note));
    for (auto& note : cavity_without_contact(scene, *plan)) notes.push_back(std::move(note));
    for (auto& note : films_too_thin(scene, *plan)) notes.push_back(std::move(note));
    for (auto& note : parison_too_large(scene, *plan)) notes.push_back(std::move(note));
  }
  return notes;
}

std::string describe_unusual(const Scene& scene) {
  std::string text;
  for (const std::string& note : unusual_values(scene)) text += "  " + note + "\n";
  return text.empty() ? "" : "\nunusual, no error: is it meant?\n" + text;
}

}  // namespace parison::forming
