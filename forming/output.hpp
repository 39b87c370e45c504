#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <string>
#include <vector>

#include "core/pvd.hpp"
#include "forming/scene.hpp"
#include "forming/state.hpp"

namespace parison::forming {

/// The files of a run in its result folder; they observe and never steer.
class ResultFiles {
 public:
  /// Makes the folder; throws core::CaseError where it exists and holds anything.
  ResultFiles(const Scene& scene, const std::string& directory);

  /// A row of history.csv; flushed.
  void row(const HistoryRow& row);
  /// VTU pieces of all bodies and the rows of interface.csv; a second call at the same time does nothing.
  void fields(const State& state, const StepReport& report);

  const std::string& directory() const { return directory_; }

 private:
  const Scene& scene_;
  std::string directory_;
  std::ofstream history_, interface_;
  std::vector<core::PvdCollection> collections_;  ///< glass, then the tools
  int written_ = 0;
  double last_time_ = 0;
};

}  // namespace parison::forming
