#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/observers/result_writer.hpp"
#include "forming/run/observers/solid_writer.hpp"

namespace parison::forming {

/// Writes checkpoints into the result folder at the boundaries of stages that are to have one, where the run fails or
/// is stopped, and when the case's wall time or steps between checkpoints are over.
class CheckpointWriter : public RunObserver {
 public:
  /// `last_checkpoint` is the number of steps done at the one that the run is taken up from, -1 for a new run. Where
  /// the case has changed since, one of the new case is written at once.
  CheckpointWriter(ResultWriter& results, SolidWriter& solid, const RunFiles& files, Index last_checkpoint = -1,
                   bool case_changed = false);

  void run_begins(const RunView& run) override;

  void checkpoint_possible(const RunView& run, bool at_stage_boundary) override;

 private:
  void write(const RunView& run);
  bool is_due(const RunView& run, bool at_stage_boundary) const;

  ResultWriter& results_;
  SolidWriter& solid_;
  const RunFiles& files_;
  bool case_changed_;
  Index steps_;        ///< done at the last checkpoint
  double written_at_;  ///< wall clock at the last checkpoint, s
};

}  // namespace parison::forming
