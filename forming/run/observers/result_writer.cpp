// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/observers/result_writer.hpp"

#include <utility>

#include "forming/step/heat/thermal_interface.hpp"

namespace parison::forming {

ResultWriter::ResultWriter(std::string directory) : directory_(std::move(directory)) {}
ResultWriter::ResultWriter(std::string directory, WrittenFiles written)
    : directory_(std::move(directory)), written_(std::move(written)) {}

void ResultWriter::run_begins(const RunView& run) {
  if (written_)
    files_.emplace(run.scene, directory_, *written_);
  else
    files_.emplace(run.scene, directory_);
}

void ResultWriter::step_taken(const RunView& run, const State& before, const StepReport& report) {
  files_->row(history_row(run.scene, before, run.state, report));
}

void ResultWriter::fields_due(const RunView& run, const State& at) {
  files_->fields(at, run.scene.has_heat() ? thermal_interface(run.scene, at) : std::vector<core::InterfacePoint>{});
}

WrittenFiles ResultWriter::sync() {
  return files_->sync();
}

}  // namespace parison::forming
