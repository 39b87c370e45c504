// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"
#include "forming/study/sweep/sweep_plan.hpp"

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

/// Begins it with what the other run had at the end of the shared stages, where that one still has it.
void take_over(const SweepPlan& plan, const SweepRun& run, const CoarseCase& one) {
  const std::string below = one.directory.substr(plan.folder(run).size());
  const std::string source = plan.folder(plan.runs[run.start->run]) + below, &stage = run.start->stage;
  if (fs::exists(source + "/checkpoint_after_" + stage + ".h5"))
    make_branch({run.name, one.directory, one.accuracy, one.overrides, BranchPoint{source, stage}, ""}, one.file);
}

/// Only what is kept of the run, or what others take over.
RunFiles files_of(const SweepPlan& plan, const SweepRun& run) {
  RunFiles files;
  files.fields = files.stage_checkpoints = plan.sweep.keep == Keep::all;
  for (const SweepRun& other : plan.runs)
    if (other.start && plan.runs[other.start->run].name == run.name) files.shared_stages.insert(other.start->stage);
  return files;
}

}  // namespace

void make_run(const SweepPlan& plan, const SweepRun& run, bool (*stop)()) {
  const RunFiles files = files_of(plan, run);
  for (const CoarseCase& one : cases_of(plan, run, plan.folder(run))) {
    if (!has_ended(one)) {
      if (run.start && !has_checkpoint(one.directory)) take_over(plan, run, one);
      if (!finish(one, {}, stop, files)) return;
    }
    if (state_of(plan, run).status == SweepState::Status::failed) return;
  }
}

}  // namespace parison::forming
