#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include "forming/report/files/solid_files.hpp"
#include "forming/run/run_observer.hpp"

namespace parison::forming {

/// Writes the history and the fields of glass in space into the result folder of its run.
class SolidWriter : public RunObserver {
 public:
  /// `written` says what a run that is taken up again keeps. Without fields those of a run that fails or is stopped
  /// alone.
  explicit SolidWriter(std::string directory, bool with_fields = true, WrittenFiles written = {})
      : directory_(std::move(directory)), with_fields_(with_fields), written_(std::move(written)) {}

  void solid_step_taken(const RunView& run, const SolidState& solid) override {
    files(run, solid).row(run.state, solid);
  }
  void solid_fields_due(const RunView& run, const SolidState& solid) override {
    if (with_fields_ || !run.facts.reason.empty()) files(run, solid).fields(run.state, solid);
  }

  /// Adds what has been written.
  void note(WrittenFiles& written) const {
    if (files_)
      files_->note(written);
    else
      written.solid_history_size = written_.solid_history_size,
      written.solid_output_times = written_.solid_output_times;
  }

 private:
  SolidFiles& files(const RunView& run, const SolidState& solid) {
    if (!files_) files_.emplace(run.scene, directory_, solid, written_);
    return *files_;
  }

  std::string directory_;
  bool with_fields_;
  WrittenFiles written_;  ///< before this run
  std::optional<SolidFiles> files_;
};

}  // namespace parison::forming
