// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/case/given_file.hpp"
#include "forming/scene/materials/material_library.hpp"

namespace parison::forming {

namespace {

using core::CaseNode;

/// Dead plate, conveyor, lehr and cold end as of a container line. The surroundings are assumed: a lehr holds flint
/// some minutes near 10^12 Pa.s, then cools slowly to 480 degC and faster from there. The plate stands for belts as
/// well, so it is thin and takes little. {gravity} is that of the last stage, {under} lies below the plate.
constexpr const char* standard_cooling = R"(
[[tool]]
name = "dead_plate"
material = "grey_iron"
temperature = "300 degC"
friction = "slip"
boundary = [{boundaries}]

[[interface]]
tools = ["dead_plate"]
law = "constant"
h = "100 W/m2/K"

[[stage]]
name = "dead_plate"
kind = "cooling"
duration = "8 s"
tools = ["dead_plate"]
air = {{ temperature = "60 degC", h = "40 W/m2/K", ambient = "60 degC" }}

[[stage]]
name = "conveyor"
kind = "cooling"
duration = "30 s"
tools = ["dead_plate"]
air = {{ temperature = "150 degC", h = "15 W/m2/K", ambient = "150 degC" }}

[[stage]]
name = "lehr"
kind = "cooling"
tools = ["dead_plate"]
[stage.lehr]
belt_speed = "0.6 m/min"
zones = [["3 m", "565 degC", "20 W/m2/K"], ["3 m", "565 degC", "20 W/m2/K"], ["2 m", "545 degC", "20 W/m2/K"],
  ["2 m", "520 degC", "20 W/m2/K"], ["2 m", "490 degC", "20 W/m2/K"], ["2 m", "420 degC", "25 W/m2/K"],
  ["2 m", "300 degC", "30 W/m2/K"], ["2 m", "180 degC", "30 W/m2/K"], ["2 m", "80 degC", "30 W/m2/K"]]

[[stage]]
name = "cold_end"
kind = "cooling"
duration = "15 min"
tools = ["dead_plate"]
air = {{ temperature = "20 degC", h = "40 W/m2/K", ambient = "20 degC" }}
)";

/// The outline of the plate, whose top is at z = 0, for gravity along +z or -z.
constexpr const char* plate_below =
    R"({ name = "under", condition = "insulated", path = "(0, -2) (150, -2) mm" },
  { name = "rim", condition = "insulated", path = "(150, 0) mm" }, { name = "top", condition = "contact", path = "(0, 0) mm" },
  { name = "axis", condition = "symmetry", path = "(0, -2) mm" })";
constexpr const char* plate_above =
    R"({ name = "top", condition = "contact", path = "(0, 0) (150, 0) mm" },
  { name = "rim", condition = "insulated", path = "(150, 2) mm" }, { name = "under", condition = "insulated", path = "(0, 2) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" })";

/// Puts the entries of a list behind those of the case.
void append(const CaseNode& entries, CaseNode& root) {
  if (CaseNode* list = member(root, entries.name))
    list->items.insert(list->items.end(), entries.items.begin(), entries.items.end());
  else
    root.items.push_back(entries);
}

}  // namespace

void add_standard_cooling(core::CaseFile& file) {
  CaseNode* wanted = member(file.root, "cooling");
  if (!wanted) return;
  core::choice(*wanted, {"standard"});
  CaseNode* stages = member(file.root, "stage");
  if (!stages || stages->items.empty()) core::refuse(*wanted, "found in a case without stages, allowed is one with");
  for (CaseNode& stage : stages->items)
    if (member(stage, "kind"))
      core::refuse(*wanted, "found in a case that names the kind of a stage, allowed is one whose stages all form");
  const CaseNode* gravity = member(stages->items.back(), "gravity");
  if (!gravity)
    core::refuse(*wanted, "found with a last stage without gravity, allowed is one that says what is below");
  const bool up = core::trimmed(gravity->text).front() != '-';
  const std::string text = fmt::format(standard_cooling, fmt::arg("boundaries", up ? plate_above : plate_below));
  CaseNode added = core::parse_case_text(text, "standard cooling");
  for (CaseNode& stage : member(added, "stage")->items) stage.items.push_back(*gravity);
  file.root.items.erase(file.root.items.begin() + (wanted - file.root.items.data()));
  for (const CaseNode& entries : added.items) append(entries, file.root);
}

}  // namespace parison::forming
