#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case_file.hpp"

namespace parison::forming {

/// How the values of the variables are combined.
enum class Design { grid, list, latin_hypercube, sobol };

/// A key of the case that a sweep changes: by single values, or anywhere between two bounds.
struct SweepVariable {
  std::string key;                  ///< as in --set
  std::vector<std::string> values;  ///< as in --set; empty between bounds
  double from = 0, to = 0;          ///< the bounds, in `unit`
  std::string unit;                 ///< empty for plain numbers
};

/// What is left in the folder of a run that has completed.
enum class Keep { all, summary, history };

/// A sweep file as it is written.
struct Sweep {
  std::string file, directory;  ///< the file and its folder
  std::string name;             ///< the file without its folder and ending
  std::string case_path, accuracy;
  std::vector<std::string> overrides;  ///< of all runs
  core::CaseNode set;                  ///< these in the file, with their lines; of a sweep without one empty
  std::vector<SweepVariable> variables;
  Design design = Design::grid;
  std::size_t runs = 0;
  std::uint64_t seed = 0;
  bool error_bars = false;
  Keep keep = Keep::all;
};

/// The most runs of one sweep.
inline constexpr std::size_t max_sweep_runs = 100000;

/// Reads a sweep file; throws core::CaseError with file, line and key where it is wrong.
Sweep read_sweep(const std::string& path);

/// The values of the variables in each run, as --set takes them. Runs of the same file are the same on every machine.
std::vector<std::vector<std::string>> sweep_values(const Sweep& sweep);

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

/// A run, maybe of another plan, whose first stages all runs share.
struct FirstRun {
  std::string folder;
  std::string stage;  ///< the last of them; the run keeps what it had at its end
};

struct SweepPlan {
  Sweep sweep;
  std::string output;  ///< folder of the runs
  std::vector<SweepRun> runs;
  std::optional<FirstRun> first = {};  ///< runs that begin with no other one of the plan take over from it

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
