#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
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

}  // namespace parison::forming
