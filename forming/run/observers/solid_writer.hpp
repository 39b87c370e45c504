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
  explicit SolidWriter(std::string directory) : directory_(std::move(directory)) {}

  void solid_step_taken(const RunView& run, const SolidState& solid) override {
    files(run, solid).row(run.state, solid);
  }
  void solid_fields_due(const RunView& run, const SolidState& solid) override {
    files(run, solid).fields(run.state, solid);
  }

 private:
  SolidFiles& files(const RunView& run, const SolidState& solid) {
    if (!files_) files_.emplace(run.scene, directory_, solid);
    return *files_;
  }

  std::string directory_;
  std::optional<SolidFiles> files_;
};

}  // namespace parison::forming
