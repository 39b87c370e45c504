// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/sweep/sweep_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/resume/case_change.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/comparison/what_if/tool_overlap.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"
#include "forming/study/setting_error.hpp"

namespace parison::forming {

namespace {

namespace fs = std::filesystem;

/// The run itself and the coarser ones of its error bars; below the folder of the run with `folder`.
std::vector<CoarseCase> cases_of(const SweepPlan& plan, const SweepRun& run, const std::string& folder) {
  const Scene scene = read_scene(plan.sweep.case_path, plan.sweep.accuracy, run.overrides);
  if (!run.fingerprint.empty() && run.fingerprint != core::fingerprint_text(scene.fingerprint))
    throw core::CaseError(
        fmt::format("{}: the case has changed since the sweep was begun, allowed is the same one, or another --output",
                    plan.sweep.case_path));
  std::vector<CoarseCase> cases{{scene.file, scene.accuracy_name, folder, scene.overrides, 1}};
  if (!plan.sweep.error_bars) return cases;
  for (CoarseCase& coarse : coarse_cases(scene, folder)) cases.push_back(std::move(coarse));
  return cases;
}

/// Begins it with what another run had at the end of the shared stages, where that one still has it.
void take_over(const SweepPlan& plan, const SweepRun& run, const CoarseCase& one) {
  if (!run.start && !plan.first) return;
  const std::string below = one.directory.substr(plan.folder(run).size());
  const std::string source = (run.start ? plan.folder(plan.runs[run.start->run]) : plan.first->folder) + below;
  const std::string& stage = run.start ? run.start->stage : plan.first->stage;
  if (source != one.directory && fs::exists(source + "/checkpoint_after_" + stage + ".h5"))
    make_branch({run.name, one.directory, one.accuracy, one.overrides, BranchPoint{source, stage}, ""}, one.file);
}

/// Only what is kept of the run, or what others take over.
RunFiles files_of(const SweepPlan& plan, const SweepRun& run) {
  RunFiles files;
  files.fields = files.stage_checkpoints = plan.sweep.keep == Keep::all;
  if (plan.first && plan.first->folder == plan.folder(run)) files.shared_stages.insert(plan.first->stage);
  for (const SweepRun& other : plan.runs)
    if (other.start && plan.runs[other.start->run].name == run.name) files.shared_stages.insert(other.start->stage);
  return files;
}

}  // namespace

void make_run(const SweepPlan& plan, const SweepRun& run, bool (*stop)()) {
  const RunFiles files = files_of(plan, run);
  for (const CoarseCase& one : cases_of(plan, run, plan.folder(run))) {
    if (!has_ended(one)) {
      if (!has_checkpoint(one.directory)) take_over(plan, run, one);
      if (!finish(one, {}, stop, files)) return;
    }
    if (state_of(plan, run).status == SweepState::Status::failed) return;
  }
}

namespace {

std::string assignment(const SweepVariable& variable, const std::string& value) {
  return variable.key + '=' + value;
}

/// The case with what holds for all runs.
Scene base_scene(const Sweep& sweep) {
  try {
    return read_scene(sweep.case_path, sweep.accuracy, sweep.overrides);
  } catch (const core::CaseError& error) {
    refuse_setting(sweep.set.items.empty() ? nullptr : &sweep.set, error);
  }
}

/// The case of a run; what is refused carries its row and what it sets.
Scene checked_scene(const Sweep& sweep, const Scene& base, std::size_t row, const std::vector<std::string>& values) {
  try {
    Scene scene = read_scene(sweep.case_path, sweep.accuracy, overrides_of(sweep, values));
    if (const std::string overlap = new_tool_overlap(base, scene); !overlap.empty()) throw core::CaseError(overlap);
    return scene;
  } catch (const core::CaseError& error) {
    std::vector<std::string> settings;
    for (std::size_t i = 0; i < values.size(); ++i) settings.push_back(assignment(sweep.variables[i], values[i]));
    throw core::CaseError(
        fmt::format("{}: row {} ({}): {}", sweep.file, row + 1, fmt::join(settings, ", "), refusal_text(error)));
  }
}

/// How many of the first stages of the case a change has not influenced at their end.
std::size_t stages_before(const Scene& base, const Scene& changed) {
  for (std::size_t count = base.stages.size() - 1; count > 0; --count)
    if (used_change(base.file, base.overrides, changed, static_cast<Index>(count) - 1).empty()) return count;
  return 0;
}

/// How many of the first stages of the case a variable does not influence, as two of its values tell; what rows really
/// share is asked again for each. None where such a value alone makes no case.
std::size_t stages_before_variable(const Sweep& sweep, const Scene& base,
                                   const std::vector<std::vector<std::string>>& values, std::size_t variable) {
  std::set<std::string> tried;
  std::size_t count = base.stages.size();
  for (const auto& row : values) {
    if (tried.size() == 2) break;
    if (!tried.insert(row[variable]).second) continue;
    std::vector<std::string> overrides = sweep.overrides;
    overrides.push_back(assignment(sweep.variables[variable], row[variable]));
    try {
      count = std::min(count, stages_before(base, read_scene(sweep.case_path, sweep.accuracy, overrides)));
    } catch (const core::CaseError&) {
      return 0;
    }
  }
  return count;
}

/// Finds for a row the first one before it that goes the same way for the most stages.
class SharedStages {
 public:
  explicit SharedStages(std::vector<std::size_t> before) : before_(std::move(before)) {
    for (const std::size_t count : before_)
      if (count > 0 && !std::count(counts_.begin(), counts_.end(), count)) counts_.push_back(count);
    std::sort(counts_.rbegin(), counts_.rend());
  }

  bool is_possible() const { return !counts_.empty(); }

  std::optional<SharedStart> find(const SweepPlan& plan, const SweepRun& run, const Scene& scene) const {
    for (const std::size_t count : counts_)
      if (const auto first = first_.find(signature(run, count)); first != first_.end()) {
        const SweepRun& other = plan.runs[first->second];
        if (used_change(scene.file, other.overrides, scene, static_cast<Index>(count) - 1).empty())
          return SharedStart{first->second, scene.stages[count - 1].name};
      }
    return std::nullopt;
  }

  void add(const SweepRun& run, std::size_t row) {
    for (const std::size_t count : counts_) first_.emplace(signature(run, count), row);
  }

 private:
  /// The values that influence the first `count` stages.
  std::string signature(const SweepRun& run, std::size_t count) const {
    std::string text = fmt::format("{}", count);
    for (std::size_t i = 0; i < before_.size(); ++i)
      if (before_[i] < count) text += '\n' + run.values[i];
    return text;
  }

  std::vector<std::size_t> before_, counts_;  ///< by variable; those among them, the largest first
  std::map<std::string, std::size_t> first_;  ///< the row of a signature
};

void find_shared_starts(SweepPlan& plan, SharedStages stages) {
  if (!stages.is_possible()) return;
  for (std::size_t row = 0; row < plan.runs.size(); ++row) {
    SweepRun& run = plan.runs[row];
    run.start = stages.find(plan, run, read_scene(plan.sweep.case_path, plan.sweep.accuracy, run.overrides));
    stages.add(run, row);
  }
}

}  // namespace

std::vector<std::string> overrides_of(const Sweep& sweep, const std::vector<std::string>& values) {
  std::vector<std::string> overrides = sweep.overrides;
  for (std::size_t i = 0; i < values.size(); ++i) overrides.push_back(assignment(sweep.variables[i], values[i]));
  return overrides;
}

SweepPlan plan_sweep(const Sweep& sweep, const std::string& output) {
  SweepPlan plan{sweep, output, {}};
  const Scene base = base_scene(sweep);
  const auto values = sweep_values(sweep);
  for (std::size_t row = 0; row < values.size(); ++row) {
    const Scene scene = checked_scene(sweep, base, row, values[row]);
    plan.runs.push_back({fmt::format("run_{:04}", row + 1), values[row], scene.overrides,
                         core::fingerprint_text(scene.fingerprint), std::nullopt});
  }
  std::vector<std::size_t> before;
  for (std::size_t i = 0; i < sweep.variables.size(); ++i)
    before.push_back(stages_before_variable(sweep, base, values, i));
  find_shared_starts(plan, SharedStages(std::move(before)));
  return plan;
}

}  // namespace parison::forming
