// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/new_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <regex>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/describe/unusual.hpp"
#include "forming/scene/outline_place.hpp"
#include "forming/scene/scene.hpp"
#include "tools/program/bundled_cases.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

void check_name(const std::string& folder, const std::string& name) {
  const auto allowed = [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '_' || c == '-'); };
  constexpr std::size_t longest = 100;  // of a case's name
  if (name.empty() || name.size() > longest || !std::all_of(name.begin(), name.end(), allowed))
    throw core::CaseError(
        fmt::format("{}: the name \"{}\" was found, allowed are names of up to {} letters, digits, _ and -", folder,
                    name, longest));
  std::error_code error;
  if (fs::exists(folder, error))
    throw core::CaseError(fmt::format("{}: exists already, allowed is a new folder", folder));
  if (error) throw core::CaseError(fmt::format("{}: the folder cannot be made: {}", folder, error.message()));
}

/// The tool of the first stage that does not move and has its contact boundaries around the middle of the glass.
std::string taker_of(const forming::Scene& scene, double middle) {
  for (const forming::StageTool& entry : scene.stages.front().tools) {
    const forming::Tool& tool = scene.tools[static_cast<std::size_t>(entry.tool)];
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const core::Segment& segment : tool.profile.segments)
      if (tool.boundaries[static_cast<std::size_t>(segment.boundary_id)].kind == core::BoundaryKind::contact)
        for (const double z : {segment.start[1], segment.end[1]}) low = std::min(low, z), high = std::max(high, z);
    const bool moves = forming::has_moved_before(scene, static_cast<forming::Index>(scene.stages.size()), entry.tool);
    if (!moves && low + tool.position < middle && middle < high + tool.position) return tool.name;
  }
  return "";
}

/// The capsule as a `gob` that is laid into the tool around it, empty where the glass is drawn in another way.
std::string gob_line(const forming::Scene& scene) {
  const auto& segments = scene.glass.profile.segments;
  const auto& boundaries = scene.glass.boundaries;
  const bool is_capsule = boundaries.size() == 2 && boundaries[0].name == "surface" && boundaries[1].name == "axis" &&
                          segments.size() == 4 && segments[0].is_arc && segments[2].is_arc && !segments[1].is_arc;
  if (!is_capsule || scene.geometry != core::Geometry::axisymmetric) return "";
  const std::string taker = taker_of(scene, (segments[0].start[1] + segments[3].start[1]) / 2);
  if (taker.empty()) return "";
  return fmt::format("gob = {{ mass = \"{:.7g} g\", diameter = \"{:g} mm\", in = \"{}\" }} # laid down on the tools\n",
                     1e3 * forming::dimensionless_numbers(scene).mass, 2e3 * segments[0].radius, taker);
}

/// The text from a place to the start of the line after the next line that is `end`.
std::size_t after_line(const std::string& text, std::size_t from, const std::string& end) {
  const auto at = text.find("\n" + end + "\n", from);
  return at == text.npos ? text.npos : at + end.size() + 2;
}

/// Takes away the comments with figures, which hold for the dimensions of the old case alone; whether there were some.
bool drop_old_figures(std::string& text) {
  static const std::regex line(R"(\n[ \t]*#[^"\n]*[0-9][^"\n]*(?=\n))"), end(R"([ \t]*#[^"\n]*[0-9][^"\n]*(?=\n))");
  const auto before = text.size();
  text = std::regex_replace(std::regex_replace(text, line, ""), end, "");
  return text.size() < before;
}

/// Gives a capsule by its mass; the line that it put in place of the outline, empty where it did not.
std::string give_gob_by_mass(const forming::Scene& scene, std::string& text) {
  const std::string gob = gob_line(scene);
  const auto glass = text.find("\n[glass]");
  if (gob.empty() || glass == text.npos) return "";
  const auto next = text.find("\n[", glass + 1), boundary = text.find("\nboundary = [", glass);
  const auto end = after_line(text, boundary, "]");
  if (boundary == text.npos || end == text.npos || next < boundary) return "";  // the case has a gob itself
  text.replace(boundary + 1, end - boundary - 1, gob);
  text.replace(glass + 1, text.find('\n', glass + 1) - glass - 1, "[glass]");
  return gob;
}

/// Binds the thermocouples of the tools to the boundary that they lie behind, so that they follow a changed drawing;
/// how many.
int bind_probes(const forming::Scene& scene, std::string& text) {
  int count = 0;
  for (const forming::Probe& probe : scene.probes) {
    if (probe.body == 0) continue;
    const forming::Tool& tool = scene.tools[probe.body - 1];
    const auto place = forming::closest_contact(tool, probe.point);
    const double depth = place ? (probe.point - place->point).norm() : 0, rounding = 1e-5 * core::size(tool.profile);
    if (!place || (place->point - depth * place->normal - probe.point).norm() > rounding) continue;
    const std::regex point("(name = \"" + probe.name + "\", body = \"[^\"]*\", )point = \"\\([-0-9., ]*\\) mm\"");
    if (!std::regex_search(text, point)) continue;
    text = std::regex_replace(text, point,
                              fmt::format("$1boundary = \"{}\", depth = \"{:.4g} mm\", point = \"({:.5g}, {:.5g}) mm\"",
                                          tool.boundaries[place->boundary].name, 1e3 * depth,
                                          1e3 * place->point[0] + 0.0, 1e3 * place->point[1] + 0.0));
    ++count;
  }
  return count;
}

}  // namespace

int new_case(const NewRequest& request) {
  const fs::path folder = fs::path(request.folder).lexically_normal();
  const std::string name = folder.filename().string();
  check_name(request.folder, name);
  const std::string like = find_case(request.like);
  const forming::Scene scene = forming::read_scene(like, "draft");
  std::string text = core::read_text(scene.file);
  while (!text.empty() && text.front() == '#') text.erase(0, text.find('\n') + 1);
  const std::string old = fmt::format("case = \"{}\"", scene.name);
  if (const auto at = text.find(old); at != text.npos) text.replace(at, old.size(), fmt::format("case = \"{}\"", name));
  const bool had_figures = drop_old_figures(text);
  const std::string gob = give_gob_by_mass(scene, text);
  const int bound = bind_probes(scene, text);
  const std::string head = fmt::format(
      "# {0}: begun like the bundled case {1}. Change the paths of the tools, the mass of the gob and the times.\n"
      "#   parison check {2} --picture {0}.svg    draws it and says weight, capacity and where the plunger stops\n"
      "#   parison run {2} --accuracy draft       runs it; results/{0} has the results\n"
      "# Every key: cases/README.md. Dimensions that several paths share may have names: [dimension] r_body = \"37 "
      "mm\".\n",
      name, scene.name, request.folder);
  fs::create_directories(folder);
  for (const auto& entry : fs::recursive_directory_iterator(scene.directory)) {
    const fs::path file = entry.path().lexically_relative(scene.directory);
    if (text.find("\"" + file.string() + "\"") == text.npos) continue;
    fs::create_directories((folder / file).parent_path());
    fs::copy_file(entry.path(), folder / file);
  }
  core::write_text((folder / "case.toml").string(), head + text);
  forming::read_scene(folder.string(), "draft");
  fmt::print("{}\n", (folder / "case.toml").string());
  if (!gob.empty())
    fmt::print("  the outline of the glass was replaced by the same capsule given by its mass:\n  {}", gob);
  if (bound > 0) fmt::print("  probes that follow the drawing, each at its depth behind a boundary: {}\n", bound);
  if (had_figures) fmt::print("  comments with figures of {} were left out\n", scene.name);
  return 0;
}

}  // namespace parison::tools
