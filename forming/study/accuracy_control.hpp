#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/report/error_bars.hpp"
#include "forming/report/quantities.hpp"

namespace parison::forming {

/// How far two runs of a scene are apart, as a share: the larger of the wall in the mean and of the heat into the
/// tools; where a scene has neither, the largest of all quantities. NaN where the runs have nothing in common.
double difference_of_runs(const Quantities& run, const Quantities& reference);

/// Finds how fine a scene has to be run for an error that is asked for, by runs of the scene itself: the difference of
/// two runs at edges h and H gives the constant c of the error c h^1.5 (L. F. Richardson, Phil. Trans. R. Soc. A 210
/// (1911) 307-357), and from the weighted root mean square of c over all pairs of runs follow the error of the last run
/// and the edges and steps of the next. At least two runs are made, and a third unless they are very near each other.
class AccuracyControl {
 public:
  explicit AccuracyControl(double target);

  /// Edges and steps of the next run, in units of those of the draft preset, and the accuracy that asks for it.
  double factor() const { return factor_; }
  std::string accuracy() const;
  /// What the run gave; nothing where it stopped before its end.
  void add(const std::optional<Quantities>& run, double cpu_seconds);
  /// Whether there is nothing more to run: the accuracy is reached or out of reach.
  bool finished() const;
  const AccuracyRecord& record() const { return record_; }
  /// The completed runs before the last one that are not many times as coarse, but at least two where there are two,
  /// for its error bars.
  std::vector<CoarserRun> coarser() const;

 private:
  /// Error of the last completed run, a share; at least two have been completed.
  double estimate() const;

  AccuracyRecord record_;
  double factor_;
  std::vector<CoarserRun> completed_;  ///< factors in units of draft
};

}  // namespace parison::forming
