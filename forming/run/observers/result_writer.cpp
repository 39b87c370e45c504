// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/observers/result_writer.hpp"

#include <utility>

#include "forming/report/files/interface_rows.hpp"
#include "forming/step/heat/thermal_interface.hpp"

namespace parison::forming {

ResultWriter::ResultWriter(std::string directory, bool with_fields)
    : directory_(std::move(directory)), with_fields_(with_fields) {}
ResultWriter::ResultWriter(std::string directory, WrittenFiles written, bool with_fields)
    : directory_(std::move(directory)), with_fields_(with_fields), written_(std::move(written)) {}

void ResultWriter::run_begins(const RunView& run) {
  surfaces_ = tool_surfaces(run.scene, run.state);
  stage_lowest_ = written_ ? written_->stage_lowest : 0;
  if (written_)
    files_.emplace(run.scene, directory_, *written_);
  else
    files_.emplace(run.scene, directory_);
}

void ResultWriter::stage_begins(const RunView& run) {
  stage_lowest_ = lowest_downwards(run.scene, run.state);
}

void ResultWriter::step_taken(const RunView& run, const State& /*before*/, const StepReport& report) {
  HistoryRow row = history_row(run.scene, run.state, report);
  row.sag = lowest_downwards(run.scene, run.state) - stage_lowest_;
  files_->row(row, tool_line(run.scene, run.state, surfaces_));
}

void ResultWriter::fields_due(const RunView& run, const State& at) {
  if (!with_fields_ && run.facts.reason.empty()) return;
  files_->fields(at, run.scene.has_heat() ? thermal_interface(run.scene, at) : std::vector<core::InterfacePoint>{});
}

WrittenFiles ResultWriter::sync() {
  WrittenFiles written = files_->sync();
  written.stage_lowest = stage_lowest_;
  return written;
}

}  // namespace parison::forming
