// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "core/io/json_read.hpp"
#include "core/io/manifest.hpp"
#include "core/io/written_files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/sweep/sweep_plan.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;
using Status = SweepState::Status;

/// `solid` is of glass in space; the last one on request.
constexpr std::array kept_files{"summary.json", "thickness.csv", "solid", "history.csv"};

/// Of one folder, without its coarser runs. Refuses a run of another case or with other settings than the fingerprint
/// stands for; an empty one stands for all.
SweepState state_of_folder(const std::string& folder, const std::string& fingerprint) {
  const auto summary = core::read_json_file(folder + "/summary.json");
  if (!summary) return {};
  if (!fingerprint.empty() && summary->text_of("case_fingerprint") != fingerprint)
    throw core::CaseError(
        fmt::format("{}: a run of another case or with other settings was found, allowed is the run of this row, or "
                    "another --output",
                    folder));
  if (summary->flag_of("stopped")) return {Status::waiting, summary->text_of("reason")};
  if (summary->flag_of("completed")) return {Status::done};
  return {Status::failed, summary->text_of("reason")};
}

std::vector<std::string> coarser_folders(const SweepPlan& plan, const std::string& folder) {
  std::vector<std::string> folders;
  if (!plan.sweep.error_bars) return folders;
  const double own = read_accuracy(plan.sweep.accuracy).coarsening_factor;
  for (std::size_t i = 0; i < coarse_folders.size(); ++i)
    if (coarser_factors[i] * own <= max_coarsening) folders.push_back(folder + '/' + coarse_folders[i]);
  return folders;
}

std::string manifest_path(const SweepPlan& plan) {
  return plan.output + "/sweep.json";
}

std::string manifest_text(const SweepPlan& plan) {
  core::JsonWriter json;
  json.add("case", plan.sweep.case_path);
  json.add("accuracy", plan.sweep.accuracy);
  json.add("error_bars", plan.sweep.error_bars);
  json.open_list("variables");
  for (const SweepVariable& variable : plan.sweep.variables) json.add("", variable.key);
  json.close();
  json.open_list("runs");
  for (const SweepRun& run : plan.runs) {
    json.open_object("");
    json.add("run", run.name);
    json.add("case_fingerprint", run.fingerprint);
    json.open_list("values");
    for (const std::string& value : run.values) json.add("", value);
    json.close();
    if (run.start) {
      json.add("starts_after", run.start->stage);
      json.add("of", plan.runs[run.start->run].name);
    }
    json.close();
  }
  return json.finish();
}

/// Rows may be added, and the manifest of a killed sweep may lack those that never began; none may be another.
void require_same_runs(const SweepPlan& plan, const core::JsonValue& before) {
  const auto refuse = [&](const std::string& found) {
    throw core::CaseError(
        fmt::format("{}: {} was found there, allowed is the same sweep with more rows, or another "
                    "--output",
                    plan.output, found));
  };
  if (before.text_of("accuracy") != plan.sweep.accuracy)
    refuse(fmt::format("a sweep at {} accuracy", before.text_of("accuracy")));
  const core::JsonValue* runs = before.find("runs");
  if (!runs) refuse("a list of runs that cannot be read");
  if (runs->items.size() > plan.runs.size()) refuse(fmt::format("a sweep of {} runs", runs->items.size()));
  for (std::size_t i = 0; i < runs->items.size(); ++i)
    if (runs->items[i].text_of("case_fingerprint") != plan.runs[i].fingerprint)
      refuse(fmt::format("another case or other values in row {}", i + 1));
}

/// The values that the manifest has for a run.
std::vector<std::string> values_of(const core::JsonValue& run) {
  std::vector<std::string> values;
  if (const core::JsonValue* list = run.find("values"))
    for (const core::JsonValue& value : list->items) values.push_back(value.text);
  return values;
}

}  // namespace

SweepPlan begun_plan(const Sweep& sweep, const std::string& output) {
  SweepPlan plan{sweep, output, {}};
  const std::string path = manifest_path(plan);
  if (!fs::exists(path))
    throw core::CaseError(fmt::format("{}: no such file, allowed is a sweep that was begun", path));
  const core::JsonValue manifest = core::read_json_file(path).value_or(core::JsonValue{});
  const core::JsonValue* runs = manifest.find("runs");
  const auto values = sweep_values(sweep);
  std::map<std::string, std::size_t> rows;
  for (std::size_t row = 0; runs && row < runs->items.size(); ++row) {
    const core::JsonValue& item = runs->items[row];
    if (row >= values.size() || values_of(item) != values[row])
      throw core::CaseError(fmt::format("{}: row {} has changed since the sweep was begun", sweep.file, row + 1));
    plan.runs.push_back({item.text_of("run"), values[row], overrides_of(sweep, values[row]),
                         item.text_of("case_fingerprint"), std::nullopt});
    rows[plan.runs.back().name] = row;
    if (const auto other = rows.find(item.text_of("of")); other != rows.end() && other->second < row)
      plan.runs.back().start = SharedStart{other->second, item.text_of("starts_after")};
  }
  return plan;
}

SweepState state_of(const SweepPlan& plan, const SweepRun& run) {
  const std::string folder = plan.folder(run);
  const SweepState own = state_of_folder(folder, run.fingerprint);
  if (own.status != Status::done) return own;
  for (const std::string& coarser : coarser_folders(plan, folder))
    if (state_of_folder(coarser, "").status == Status::waiting) return {};
  return own;
}

void claim_sweep(const SweepPlan& plan) {
  std::set<std::string> names{"sweep.json", "results.csv", "results.h5", "slurm_*"};
  for (const SweepRun& run : plan.runs)
    for (const char* ending : {"", ".log", ".lock"}) names.insert(run.name + ending);
  core::claim_folder(plan.output, "sweep", names);
  for (const SweepRun& run : plan.runs) {
    const std::string folder = plan.folder(run);
    const auto summary = core::read_json_file(folder + "/summary.json");
    const bool is_over = summary && !summary->flag_of("stopped");
    if (!is_over && !has_checkpoint(folder)) core::require_own(folder);  // it is removed
  }
}

void write_manifest(const SweepPlan& plan) {
  const std::string path = manifest_path(plan);
  if (const auto before = core::read_json_file(path)) require_same_runs(plan, *before);
  core::replace_file(path, manifest_text(plan));
}

void keep_only(Keep keep, const std::string& folder) {
  if (keep == Keep::all) return;
  const auto last = kept_files.end() - (keep == Keep::history ? 0 : 1);
  std::vector<fs::path> removed;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (std::count(coarse_folders.begin(), coarse_folders.end(), name))
      keep_only(keep, entry.path().string());
    else if (!std::count(kept_files.begin(), last, name) && name != core::manifest_name)
      removed.push_back(entry.path());
  }
  for (const fs::path& path : removed) core::remove_own_files(path.string());
}

}  // namespace parison::forming
