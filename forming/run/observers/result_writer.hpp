#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include "forming/report/files/result_files.hpp"
#include "forming/run/run_observer.hpp"
#include "forming/state/tool_surface.hpp"

namespace parison::forming {

/// Writes the history, the fields and the interface of a run into its result folder.
class ResultWriter : public RunObserver {
 public:
  /// In a new folder, which is made when the run begins. Without fields those of a run that fails or is stopped alone.
  explicit ResultWriter(std::string directory, bool with_fields = true);
  /// In the folder of a run that is resumed; whatever was written since the checkpoint is cut off.
  ResultWriter(std::string directory, WrittenFiles written, bool with_fields = true);

  void run_begins(const RunView& run) override;
  void stage_begins(const RunView& run) override;
  void step_taken(const RunView& run, const State& before, const StepReport& report) override;
  void fields_due(const RunView& run, const State& at) override;

  /// Flushes everything to the disk and returns how much has been written.
  WrittenFiles sync();
  const std::string& directory() const { return directory_; }

 private:
  std::string directory_;
  bool with_fields_;
  std::optional<WrittenFiles> written_;  ///< before this run
  std::optional<ResultFiles> files_;
  std::vector<ToolSurface> surfaces_;
  double stage_lowest_ = 0;  ///< lowest_downwards at the start of the present stage, m
};

}  // namespace parison::forming
