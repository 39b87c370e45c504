// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/run_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "core/io/files.hpp"
#include "forming/report/quantity_labels.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/study/comparison/comparison.hpp"
#include "forming/study/comparison/same_case.hpp"
#include "forming/study/comparison/study_folder.hpp"
#include "tools/report/data/production.hpp"
#include "tools/report/data/result_folder.hpp"
#include "tools/report/data/run_names.hpp"
#include "tools/report/data/wall_bars.hpp"

namespace parison::tools {

namespace {

using Json = nlohmann::ordered_json;

/// A text of several indented lines as one line.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line, word;
  while (words >> word) line += (line.empty() ? "" : " ") + word;
  return line;
}

Json rows_of(const forming::RunComparison& result) {
  Json rows = Json::array();
  for (const forming::Difference& difference : result.quantities) {
    const forming::ShownDifference row = forming::shown(difference);
    rows.push_back({{"quantity", row.label},
                    {"base", row.base},
                    {"other", row.other},
                    {"difference", row.difference},
                    {"bar", row.bar},
                    {"model", row.model},
                    {"unit", row.unit},
                    {"verdict", row.verdict}});
  }
  return rows;
}

/// A folder that is damaged, still written or of another case costs its table and not the page.
Json against(const std::string& base, const std::string& folder) {
  try {
    const forming::Comparison comparison = forming::compare_folders(base, {folder});
    const forming::ComparedRun& other = comparison.others.front();
    if (!other.result) return {{"reason", "no results: " + other.reason}};
    return {{"settings", forming::settings_line(other.settings)},
            {"rows", rows_of(*other.result)},
            {"bars", in_one_line(forming::bars_line(*other.result, comparison.base, other.run) +
                                 forming::models_line(*other.result, comparison.base, other.run))}};
  } catch (const std::exception& error) {
    return {{"reason", error.what()}};
  }
}

/// What `parison compare` says of runs beside the first of them, and of variants that did not settle: by the name of
/// each its rows, or the reason why it cannot be compared. Null for one run alone.
Json differences_of(const std::vector<std::string>& folders, const std::vector<std::string>& names,
                    const std::vector<forming::FailedVariant>& failed) {
  if (folders.size() + failed.size() < 2) return {};
  Json others = Json::array();
  for (std::size_t i = 1; i < folders.size(); ++i) {
    Json other = against(folders.front(), folders[i]);
    other["run"] = names[i];
    others.push_back(std::move(other));
  }
  for (const forming::FailedVariant& one : failed)
    others.push_back({{"run", one.name}, {"reason", "no results: " + one.reason}});
  return {{"base", names.front()}, {"others", std::move(others)}};
}

/// Bytes of all films of a page before compression; with the rest a page stays below 5 MB.
constexpr std::size_t film_budget = 4'500'000;

/// Single precision could not tell a volume from the one before: its relative change takes its place.
void replace_volume(ResultTable& history) {
  const int at = history.find("volume_mm3");
  if (at < 0 || history.rows() == 0) return;
  auto& volumes = history.numbers[static_cast<std::size_t>(at)];
  const double first = volumes[0];
  for (double& volume : volumes) volume = volume / first - 1;
  history.names[static_cast<std::size_t>(at)] = "volume_change";
}

/// The stages with the side that points up and their tools, where the case could be read.
Json stages_of(const ResultFolder& folder, const std::optional<forming::Scene>& scene) {
  Json stages = Json::array();
  for (const StageSpan& span : folder.stages) {
    Json one{{"name", span.name}, {"start", span.start}, {"end", span.end}, {"ended_by", span.ended_by}};
    one["upright"] = true;
    for (std::size_t i = 0; i < (scene ? scene->stages.size() : 0); ++i) {
      const forming::Stage& stage = scene->stages[i];
      if (stage.name != span.name) continue;
      one["upright"] = forming::is_upright(*scene, i);
      Json tools = Json::array();
      for (const forming::StageTool& active : stage.tools) tools.push_back(scene->tools[active.tool].name);
      one["tools"] = std::move(tools);
    }
    stages.push_back(std::move(one));
  }
  return stages;
}

/// What the quantities of a summary are called.
Json labels_of(const Json& summary) {
  Json labels = Json::object();
  const auto quantities = summary.is_object() ? summary.find("quantities") : summary.end();
  if (!summary.is_object() || quantities == summary.end() || !quantities->is_object()) return labels;
  for (const auto& quantity : quantities->items()) labels[quantity.key()] = forming::quantity_label(quantity.key());
  return labels;
}

const SceneOfRun& scene_of(const std::string& folder, ReportCache& cache) {
  auto& [stamp, scene] = cache.scenes[folder];
  if (const std::string now = stamp_of_case(folder); stamp != now || (!scene.scene && scene.problem.empty())) {
    scene = read_scene_of(folder);
    stamp = now;
  }
  return scene;
}

/// The summary of glass in space; null where it is missing or damaged.
Json space_summary(const std::string& path) {
  const std::string file = path + "/solid/summary.json";
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(file, unreadable)) return {};
  const Json summary = Json::parse(core::read_text(file), nullptr, false);
  return summary.is_object() ? summary : Json();
}

/// The film of round glass and that of glass in space, which has up to its share of the budget.
void pack_films(const ResultFolder& folder, ReportCache& cache, std::size_t budget, Json& run, PackedBytes& bytes,
                std::vector<std::string>& problems) {
  const std::size_t before = bytes.size(), budget_in_space = budget / 10 * 7;
  run["space"] = pack_space_film(folder, cache.surfaces, budget_in_space, bytes, problems);
  if (!run["space"].is_null() && !folder.summary.empty()) run["space"]["summary"] = space_summary(folder.path);
  const std::size_t used = std::min(budget_in_space, bytes.size() - before);
  run["film"] = pack_film(folder, cache.files, budget - used, bytes, problems);
}

Json run_json(const std::string& path, const std::string& name, std::size_t runs, ReportCache& cache,
              PackedBytes& bytes) {
  ResultFolder folder = read_folder(path);
  const SceneOfRun& scene = scene_of(path, cache);
  std::vector<std::string> problems;
  replace_volume(folder.history);
  Json run{{"name", name},
           {"path", path},
           {"state", name_of(folder.state)},
           {"told", folder.told},
           {"scene", scene.text},
           {"scene_problem", scene.problem},
           {"stages", stages_of(folder, scene.scene)},
           {"planar", scene.scene && scene.scene->geometry == core::Geometry::planar}};
  run["summary"] = folder.summary.empty() ? Json() : Json::parse(folder.summary, nullptr, false);
  run["labels"] = labels_of(run["summary"]);
  run["history"] = pack_table(folder.history, runs, bytes);
  run["tools"] = pack_table(read_table(path + "/tools.csv"), runs, bytes);
  if (!folder.summary.empty()) {
    const auto finished = run_with_coarser(path);
    if (finished) add_errors(*finished, run["summary"]);
    WallTables wall = wall_tables(path, finished);
    run["heights"] = pack_table(wall.heights, runs, bytes);
    run["profile"] = pack_table(wall.profile, runs, bytes);
    run["stress"] = pack_table(read_table(path + "/residual_stress.csv"), runs, bytes);
  }
  pack_films(folder, cache, film_budget / runs, run, bytes, problems);
  run["problems"] = problems;
  return run;
}

/// JSON may stand in a page as it is where nothing in it can end the element that holds it.
std::string without_tags(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json)
    if (c == '<' || c == '>' || c == '&')
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      text += c;
  return text;
}

}  // namespace

std::string mixed_cases(const std::vector<std::string>& folders, ReportCache& cache) {
  const std::vector<std::string> names = run_names(folders);
  const auto& first = scene_of(folders.front(), cache).scene;
  for (std::size_t i = 1; first && i < folders.size(); ++i) {
    const auto& scene = scene_of(folders[i], cache).scene;
    if (const auto other = scene ? forming::other_case(*first, *scene) : std::nullopt)
      return fmt::format(
          "The runs are of different cases: {} has {} {}, {} has {}. Curves and pictures beside each other are not of "
          "the "
          "same thing.",
          names.front(), other->what, other->base, names[i], other->other);
  }
  return {};
}

std::string report_data(const std::vector<std::string>& folders, bool live, ReportCache& cache,
                        const std::string& search, const std::vector<forming::FailedVariant>& failed) {
  Json runs = Json::array();
  PackedBytes bytes;
  const std::vector<std::string> names = run_names(folders);
  for (std::size_t i = 0; i < folders.size(); ++i)
    runs.push_back(run_json(folders[i], names[i], folders.size(), cache, bytes));
  Json productions = productions_of(folders, bytes);
  Json page{{"program", PARISON_VERSION},
            {"live", live},
            {"mixed_cases", mixed_cases(folders, cache)},
            {"differences", differences_of(folders, names, failed)},
            {"productions", std::move(productions)},
            {"runs", std::move(runs)},
            {"bytes", bytes.text()}};
  if (!search.empty()) page["search"] = Json::parse(search);
  return without_tags(page.dump(-1, ' ', true, Json::error_handler_t::replace));
}

}  // namespace parison::tools
