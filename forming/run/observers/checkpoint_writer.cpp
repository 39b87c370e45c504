// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/observers/checkpoint_writer.hpp"

#include <utility>

#include "core/process/clock.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {

CheckpointWriter::CheckpointWriter(ResultWriter& results, SolidWriter& solid, const RunFiles& files,
                                   Index last_checkpoint, bool case_changed)
    : results_(results),
      solid_(solid),
      files_(files),
      case_changed_(case_changed),
      steps_(last_checkpoint),
      written_at_(core::wall_seconds()) {}

bool CheckpointWriter::is_due(const RunView& run, bool at_stage_boundary) const {
  const Output& output = run.scene.output;
  const std::string& stage = run.scene.stages[run.state.stage].name;
  const bool is_wanted = files_.stage_checkpoints || !run.facts.reason.empty() || files_.shared_stages.count(stage) > 0;
  return (at_stage_boundary && is_wanted) || core::wall_seconds() - written_at_ >= output.checkpoint_interval ||
         (output.checkpoint_steps && run.state.totals.steps - steps_ >= *output.checkpoint_steps);
}

void CheckpointWriter::write(const RunView& run) {
  WrittenFiles written = results_.sync();
  solid_.note(written);
  write_checkpoint(results_.directory(), run.scene, {{run.state, run.facts, run.solid}, std::move(written)});
  written_at_ = core::wall_seconds();
  steps_ = run.state.totals.steps;
}

void CheckpointWriter::run_begins(const RunView& run) {
  if (case_changed_) write(run);
}

void CheckpointWriter::checkpoint_possible(const RunView& run, bool at_stage_boundary) {
  if (run.state.totals.steps != steps_ && is_due(run, at_stage_boundary)) write(run);
  if (at_stage_boundary && run.state.totals.steps == steps_ && run.state.stage_time > 0 &&
      stage_end(run.scene, run.state) != StageEnd::none)
    keep_checkpoint(results_.directory(), run.scene.stages[run.state.stage].name);
}

}  // namespace parison::forming
