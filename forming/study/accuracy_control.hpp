#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "forming/report/checks/check.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/report/quantities.hpp"

namespace parison::forming {

/// How far two runs of a scene are apart, as a share: the larger of the wall in the mean and of the heat into the
/// tools; where a scene has neither, the largest of all quantities. NaN where the runs have nothing in common.
double difference_of_runs(const Quantities& run, const Quantities& reference);

/// Finds how fine a scene has to be run for an error that is asked for, by runs of the scene itself. Errors are taken
/// as c h^1.5 at edges h and as much luck beside as single runs were found to show, so the difference of two runs at H
/// and h has the expected square c^2 ((H^1.5 - h^1.5)^2 + s^2 (H^3 + h^3)); without luck, s = 0, that is the estimate
/// of L. F. Richardson, Phil. Trans. R. Soc. A 210 (1911) 307-357. From the weighted mean of c^2 over all pairs of runs
/// follow the error of the last run and the edges and steps of the next. At least two runs are made.
class AccuracyControl {
 public:
  explicit AccuracyControl(double target);

  /// Edges and steps of the next run, in units of those of the draft preset, and the accuracy that asks for it.
  double factor() const { return factor_; }
  std::string accuracy() const;
  /// What the run gave, nothing where it stopped before its end, and its checks. A run with one far beyond its limit,
  /// or with one that tells of a larger error than asked for, has not reached it: the next is finer while that helps.
  void add(const std::optional<Quantities>& run, double cpu_seconds, const Checks& checks = {});
  /// Whether there is nothing more to run: the accuracy is reached or out of reach.
  bool finished() const;
  const AccuracyRecord& record() const { return record_; }
  /// The completed runs before the last one that are not many times as coarse, but at least two where there are two,
  /// for its error bars.
  std::vector<CoarserRun> coarser() const;

 private:
  /// Error of the last completed run, a share; at least two have been completed.
  double likely_error() const;
  /// Notes the checks that speak against the last run, and which of them finer runs do not mend.
  void judge(const Checks& checks);
  /// Whether finer runs may bring within what is allowed a check that exceeds it by the factor `now`: none that a finer
  /// mesh does not change, nor one that falls with the edges, as in the last two completed runs, too slowly for all
  /// runs that are left.
  bool mends(const Check& check, double now) const;

  AccuracyRecord record_;
  double factor_;
  double excess_ = 0;  ///< of the worst check that speaks against the last completed run, over what is allowed
  std::map<std::string, double> excesses_;  ///< of each such check
  std::vector<CoarserRun> completed_;       ///< factors in units of draft
};

}  // namespace parison::forming
