// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/finished_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/json_read.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/comparison/study_folder.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

std::string summary_path(const std::string& directory) {
  return directory + "/summary.json";
}

std::string last_word(const std::string& directory) {
  const fs::path path = fs::path(directory).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

void add_numbers(const core::JsonValue& value, std::vector<double>& numbers) {
  if (std::isfinite(value.number)) numbers.push_back(value.number);
  for (const core::JsonValue& item : value.items) add_numbers(item, numbers);
}

std::vector<StageMark> read_stages(const core::JsonValue& summary) {
  std::vector<StageMark> stages;
  if (const core::JsonValue* list = summary.find("stages"))
    for (const core::JsonValue& stage : list->items) {
      stages.push_back({stage.text_of("name"), {}});
      add_numbers(stage, stages.back().numbers);
    }
  return stages;
}

/// The run of a folder alone; nothing where it has not ended.
std::optional<FinishedRun> read_run(const std::string& directory) {
  const auto found = core::read_json_file(summary_path(directory));
  if (!found) return std::nullopt;
  const core::JsonValue& summary = *found;
  FinishedRun run;
  run.directory = directory;
  run.name = last_word(directory);
  run.accuracy = summary.text_of("accuracy");
  run.completed = summary.flag_of("completed");
  run.trustworthy = !summary.find("trustworthy") || summary.flag_of("trustworthy");
  run.reason = summary.text_of("reason");
  run.cpu_seconds = summary.number_of("cpu_seconds");
  run.quantities = read_quantities(summary);
  run.remarks = read_remarks(summary);
  run.stages = read_stages(summary);
  if (const core::JsonValue* overrides = summary.find("overrides"))
    for (const core::JsonValue& assignment : overrides->items) run.overrides.push_back(assignment.text);
  return run;
}

constexpr const char* gob_key = "glass.temperature=";

bool is_set(const std::vector<std::string>& overrides, const std::string& key) {
  return std::any_of(overrides.begin(), overrides.end(),
                     [&](const std::string& assignment) { return assignment.rfind(key, 0) == 0; });
}

/// Those that came to their end.
std::vector<Twin> read_twins(const FinishedRun& run) {
  std::vector<Twin> twins;
  const auto add = [&](const std::string& folder, std::size_t stages) {
    if (const auto twin = read_run(run.directory + '/' + folder); twin && twin->completed)
      twins.push_back({stages, twin->quantities, is_set(twin->overrides, gob_key) && !is_set(run.overrides, gob_key)});
  };
  add(twin_folder, 0);
  for (std::size_t i = 0; i < run.stages.size(); ++i) add(twin_after + run.stages[i].name, i + 1);
  return twins;
}

/// Error bars of a run alone, by its coarser runs.
void add_errors(FinishedRun& run) {
  std::vector<CoarserRun> coarser;
  for (const FinishedRun& one : run.coarser) coarser.push_back({one.factor, one.quantities});
  run.quantities = error_bars(run.quantities, coarser).quantities;
}

}  // namespace

std::optional<double> coarsening(const std::string& text, const std::string& reference) {
  const AccuracyChoice a = read_accuracy(text), b = read_accuracy(reference);
  if (a.target || b.target || a.level != b.level) return std::nullopt;
  return a.coarsening_factor / b.coarsening_factor;
}

FinishedRun read_finished_run(const std::string& directory) {
  auto run = read_run(directory);
  if (!run)
    throw core::CaseError(
        fmt::format("{}: no summary.json was found, allowed is the result folder of a run that has ended", directory));
  run->twins = read_twins(*run);
  for (const char* folder : {coarse_folders.front(), partner_folders.front(), coarse_folders.back()}) {
    auto coarser = read_run(directory + '/' + folder);
    if (!coarser) continue;
    if (!coarser->completed) {
      if (run->coarser_stopped.empty()) run->coarser_stopped = coarser->reason;
      continue;
    }
    const auto factor = coarsening(coarser->accuracy, run->accuracy);
    if (!factor || *factor <= 1) continue;
    coarser->factor = *factor;
    coarser->twins = read_twins(*coarser);
    run->coarser.push_back(std::move(*coarser));
  }
  if (!run->coarser.empty()) add_errors(*run);
  if (run->name == "settled" || run->name == "just_swabbed")
    if (const auto cycle = read_cycle_result(directory + "/..")) run->not_possible = cycle->not_possible;
  return *run;
}

const FinishedRun* coarser_by(const FinishedRun& run, double factor) {
  for (const FinishedRun& coarser : run.coarser)
    if (std::abs(coarser.factor / factor - 1) < 1e-6) return &coarser;
  return nullptr;
}

std::size_t stages_in_common(const FinishedRun& a, const FinishedRun& b) {
  std::size_t count = 0;
  while (count < std::min(a.stages.size(), b.stages.size()) && a.stages[count].name == b.stages[count].name &&
         a.stages[count].numbers == b.stages[count].numbers)
    ++count;
  return count;
}

std::string name_with_folder(const FinishedRun& run) {
  const fs::path path = fs::absolute(run.directory).lexically_normal();
  const fs::path own = path.has_filename() ? path : path.parent_path();
  return own.parent_path().filename().string() + '/' + run.name;
}

}  // namespace parison::forming
