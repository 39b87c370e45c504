#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/report/quantities.hpp"
#include "forming/study/sweep/sweep_plan.hpp"

namespace parison::forming {

/// The values of a variable as numbers in one unit, or as they were written where they have none in common.
struct SweepColumn {
  std::string heading;  ///< the key with the unit
  std::string unit;
  std::vector<std::string> fields;  ///< one a run, as a CSV file takes them
  std::vector<double> numbers;      ///< the same; empty where they are no numbers
};
std::vector<SweepColumn> variable_columns(const SweepPlan& plan);

/// A quantity of interest over the runs; NaN where a run does not have it.
struct QuantityColumn {
  std::string name, unit;
  std::vector<double> values, errors;
};

/// The results of the runs of a sweep.
struct SweepTable {
  std::vector<SweepColumn> variables;
  std::vector<SweepState> states;
  std::vector<bool> trustworthy;
  std::vector<double> cpu_seconds;  ///< NaN without results
  std::vector<QuantityColumn> quantities;
  std::vector<std::vector<double>> profiles;  ///< wall thickness, mm, at Quantities::profile; empty without a wall
};

/// Reads the summaries of all runs that are done.
SweepTable read_results(const SweepPlan& plan, const std::vector<SweepState>& states);

/// Writes results.csv and results.h5 into the folder of the sweep.
void write_results(const SweepPlan& plan, const SweepTable& table);

}  // namespace parison::forming
