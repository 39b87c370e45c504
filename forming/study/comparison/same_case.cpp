// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/same_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "core/case/case_error.hpp"
#include "forming/report/files/case_copy.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::forming {
namespace {

constexpr std::size_t shown_settings = 6;

/// The case of a run with other assignments.
Scene scene_in(const FinishedRun& run, const std::vector<std::string>& overrides) {
  const std::string folder = case_copy_folder(run.directory);
  std::error_code unreadable;
  if (!std::filesystem::exists(folder + "/case.toml", unreadable))
    throw core::CaseError(
        fmt::format("{}: no copy of its case was found, allowed are folders with a case/case.toml, by which it is "
                    "decided whether runs are of the same case",
                    run.directory));
  return read_scene(folder, run.accuracy, overrides);
}

Scene scene_in(const FinishedRun& run) {
  return scene_in(run, run.overrides);
}

std::string names_of(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

using Identity = std::vector<std::pair<std::string, std::string>>;

/// What makes a case the one it is, whatever its settings: a title and a value each, its name first.
Identity identity_of(const Scene& scene) {
  std::vector<std::string> tools, stages;
  for (const Tool& tool : scene.tools) tools.push_back(tool.name);
  for (const Stage& stage : scene.stages) stages.push_back(stage.name);
  return {{"case", scene.name},
          {"geometry", scene.geometry == core::Geometry::axisymmetric ? "axisymmetric" : "planar"},
          {"tools", names_of(tools)},
          {"stages", names_of(stages)}};
}

constexpr std::size_t name_of_case = 1;  ///< entries of the identity: what comes behind it makes runs comparable

std::optional<OtherCase> first_difference(const Identity& expected, const Identity& found, std::size_t from) {
  for (std::size_t i = from; i < expected.size(); ++i)
    if (found[i].second != expected[i].second) return OtherCase{found[i].first, expected[i].second, found[i].second};
  return std::nullopt;
}

bool is_same_field(const StartField& a, const StartField& b) {
  return !a.at && !b.at && a.temperature.size() == b.temperature.size() && a.temperature == b.temperature &&
         a.mesh.nodes == b.mesh.nodes;
}

/// Whether a setting is the name of the results that a tool starts from, and both runs found the same state there.
bool names_same_field(const CaseDifference& setting, const Scene& a, const Scene& b) {
  for (std::size_t t = 0; t < std::min(a.tools.size(), b.tools.size()); ++t) {
    const auto &one = a.tools[t].start_field, &other = b.tools[t].start_field;
    if (setting.key == fmt::format("tool.{}.temperature.from", a.tools[t].name))
      return one && other && is_same_field(*one, *other);
  }
  return false;
}

/// Whether both runs start a tool from what another run or production has left in it, and not from the same.
bool is_field_of_tool(const CaseDifference& setting) {
  const std::string ending = ".temperature.from";
  return setting.key.size() > ending.size() &&
         setting.key.compare(setting.key.size() - ending.size(), ending.size(), ending) == 0 &&
         !setting.before.empty() && !setting.now.empty();
}

}  // namespace

std::optional<OtherCase> other_case(const Scene& base, const Scene& other) {
  return first_difference(identity_of(base), identity_of(other), 0);
}

std::vector<CaseDifference> settings_that_differ(const FinishedRun& base, const FinishedRun& other) {
  const Scene a = scene_in(base), b = scene_in(other);
  if (const auto found = first_difference(identity_of(a), identity_of(b), name_of_case))
    throw core::CaseError(fmt::format(
        "{}: {} {} was found in the copy of its case, where {} has {}; allowed are runs of the same case up "
        "to the values of its settings",
        other.directory, found->what, found->other, base.directory, found->base));
  auto settings = case_differences(case_copy_folder(base.directory), base.overrides, case_copy_folder(other.directory),
                                   other.overrides);
  if (settings.empty() && scene_in(base, {}).fingerprint != scene_in(other, {}).fingerprint)
    settings.push_back({"a drawing or the text of the case", "", ""});
  settings.erase(std::remove_if(settings.begin(), settings.end(),
                                [&](const CaseDifference& setting) { return names_same_field(setting, a, b); }),
                 settings.end());
  return settings;
}

std::size_t stages_without_influence(const FinishedRun& base, const FinishedRun& other) {
  const Scene a = scene_in(base), b = scene_in(other);
  if (a.fingerprint == b.fingerprint) return a.stages.size();
  const auto last = last_common_stage(a, b);
  std::size_t count = 0;
  while (last && a.stages[count].name != *last) ++count;
  return last ? count + 1 : 0;
}

std::string settings_line(const std::vector<CaseDifference>& all) {
  if (all.empty()) return "the same settings";
  std::vector<CaseDifference> settings;
  std::copy_if(all.begin(), all.end(), std::back_inserter(settings),
               [](const CaseDifference& one) { return !is_field_of_tool(one); });
  std::string line;
  for (std::size_t i = 0; i < std::min(settings.size(), shown_settings); ++i) {
    const CaseDifference& setting = settings[i];
    line += (i > 0 ? "; " : "") + setting.key;
    if (!setting.before.empty() || !setting.now.empty())
      line += fmt::format(": {} -> {}", setting.before.empty() ? "absent" : setting.before,
                          setting.now.empty() ? "absent" : setting.now);
  }
  if (settings.size() > shown_settings) line += fmt::format("; {} more", settings.size() - shown_settings);
  if (settings.size() < all.size()) line += std::string(line.empty() ? "" : "; ") + "each on its own tool temperatures";
  return line;
}

}  // namespace parison::forming
