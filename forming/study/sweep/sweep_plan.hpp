#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/study/sweep/sweep_file.hpp"

namespace parison::forming {

/// A run whose first stages another one has made already.
struct SharedStart {
  std::size_t run;    ///< the other one, an earlier row
  std::string stage;  ///< at whose end this one takes over
};

/// A run of a sweep.
struct SweepRun {
  std::string name;                    ///< also of its folder
  std::vector<std::string> values;     ///< of the variables
  std::vector<std::string> overrides;  ///< with those of all runs
  std::string fingerprint;             ///< of its case; empty where nothing else than this process makes the run
  std::optional<SharedStart> start;    ///< none: from the beginning
};

struct SweepPlan {
  Sweep sweep;
  std::string output;  ///< folder of the runs
  std::vector<SweepRun> runs;

  std::string folder(const SweepRun& run) const { return output + '/' + run.name; }
};

/// Reads the case of each run and finds which runs share their first stages. Throws core::CaseError where one is
/// refused or its tools overlap where those of the case do not, with its row and what it sets before the sentence.
SweepPlan plan_sweep(const Sweep& sweep, const std::string& output);

/// What a run sets: that of all runs, then a value of each variable.
std::vector<std::string> overrides_of(const Sweep& sweep, const std::vector<std::string>& values);

/// The plan of a sweep that was begun, from its `sweep.json`, without reading the case of each run. Throws
/// core::CaseError where the values are not those that it has.
SweepPlan begun_plan(const Sweep& sweep, const std::string& output);

/// Where a run stands.
struct SweepState {
  enum class Status { waiting, done, failed };
  Status status = Status::waiting;
  std::string reason = {};  ///< why it failed, or was stopped
};

/// What the folder of a run says: done or failed with a complete summary, and with those of its coarser runs where
/// error bars are asked for.
SweepState state_of(const SweepPlan& plan, const SweepRun& run);

/// Takes the folder of a sweep, with those of the runs that begin anew. Throws core::CaseError where something in it is
/// in the way.
void claim_sweep(const SweepPlan& plan);

/// Writes `sweep.json`, the list of the runs of the folder. Throws core::CaseError where the folder has another list,
/// of which this one is no continuation.
void write_manifest(const SweepPlan& plan);

/// Makes a run that is not done, or the rest of it, with the coarser runs of its error bars. `stop` is asked after each
/// step. Throws core::CaseError where the case is no longer that of the plan.
void make_run(const SweepPlan& plan, const SweepRun& run, bool (*stop)());

/// Leaves what is to be kept of a run and of its coarser ones: with `summary` summary.json and thickness.csv, with
/// `history` history.csv too.
void keep_only(Keep keep, const std::string& folder);

}  // namespace parison::forming
