#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/report/quantities.hpp"
#include "forming/study/comparison/remarks.hpp"

namespace parison::forming {

/// Twins of a run: the same with tools a little warmer, from the start or from the end of a stage; with the gob a
/// little warmer where all tools begin with fields of temperature. They lie in folders of the run's folder.
inline constexpr const char* twin_folder = "twin";
inline constexpr const char* twin_after = "twin_after_";  ///< with the name of the stage behind it

/// A tool warmer by this makes remeshing and contact decide otherwise and changes nothing else, K.
inline constexpr double twin_warmer = 0.01;

/// A stage as it ended: numbers that are the same, to the last bit, where two runs went the same way.
struct StageMark {
  std::string name;
  std::vector<double> numbers;
};

/// The quantities of a run that went the way of another one but for what cannot matter.
struct Twin {
  std::size_t stages;  ///< after how many stages it began to differ
  Quantities quantities;
  bool warmer_gob = false;  ///< instead of warmer tools
};

/// A result folder as a comparison sees it.
struct FinishedRun {
  std::string directory, name;  ///< the last word of the folder
  std::string accuracy;
  std::vector<std::string> overrides;
  bool completed = false, trustworthy = true;
  std::string reason;  ///< why it has not completed
  double cpu_seconds = 0;
  Quantities quantities;
  std::vector<Remark> remarks;  ///< flags, warnings and failed checks
  std::vector<StageMark> stages;
  std::vector<Twin> twins;
  double factor = 1;                 ///< edges and steps over those of the run that this is a coarser one of
  std::vector<FinishedRun> coarser;  ///< its coarser runs that came to their end
  std::string not_possible;          ///< of a container of settled production: CycleResult::not_possible
  std::string coarser_stopped;       ///< why the first of those that did not stopped; empty where all did
};

/// How many times as long as those of one accuracy are edges and steps of another of the same level, both as texts;
/// nothing where they differ in more than that.
std::optional<double> coarsening(const std::string& text, const std::string& reference);

/// Reads a result folder with its coarser runs and twins; throws core::CaseError where it has no summary.
FinishedRun read_finished_run(const std::string& directory);

/// A coarser run of a run by its factor; null without one.
const FinishedRun* coarser_by(const FinishedRun& run, double factor);

/// The number of stages, from the first, in which two runs went the same way to the last bit.
std::size_t stages_in_common(const FinishedRun& a, const FinishedRun& b);

/// "folder/name" of a run in a result folder `name` in a `folder`.
std::string name_with_folder(const FinishedRun& run);

}  // namespace parison::forming
