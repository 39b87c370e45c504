#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/describe/model_sensitivity.hpp"
#include "forming/study/convergence_study.hpp"

namespace parison::tools {

/// CPU times of the further runs of a variant, s, kept next to its folder. Throws core::CaseError where a line is no
/// time.
std::vector<double> read_timings(const std::string& folder);

/// Adds the CPU time of a further run, s.
void add_timing(const std::string& folder, double cpu);

/// Takes them away, as a variant that runs anew has none.
void forget_timings(const std::string& folder);

/// Reads the results of a study's variants and writes tradeoff.csv, tradeoff.json, tradeoff.md and, where Python can,
/// the plot into the folder; prints the table, with the estimates of what no run can measure. False when the reference
/// or the base has not completed.
bool report_tradeoff(const std::string& folder, const std::vector<forming::Variant>& variants, const std::string& base,
                     const std::vector<forming::PartSensitivity>& estimates);

/// What `parison tradeoff` is asked for.
struct TradeoffRequest {
  std::string case_path, output, study;
  std::string base;                            ///< accuracy at which one setting at a time is changed
  std::string reference;                       ///< empty: that of forming::usual_reference
  std::vector<std::string> overrides, groups;  ///< for every variant; the groups to run, all where none is named
  int jobs = 2;
  int timings = 3;     ///< runs of a short variant, of which the least CPU time counts
  bool list = false;   ///< names the variants and runs none
  bool parts = false;  ///< model_parts in place of the study
};

/// Runs the study of a case in a folder, without what has run before, and writes its results. Returns the exit code.
int tradeoff(const TradeoffRequest& request);

/// Runs a case with each part of its model in and out, all at the base accuracy and without files, and prints what each
/// part changes and the noise. Returns the exit code.
int model_parts(const TradeoffRequest& request);

}  // namespace parison::tools
