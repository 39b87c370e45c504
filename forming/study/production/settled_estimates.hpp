#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/state/state.hpp"

namespace parison::forming {

/// What one forming run says of the periodic state.
struct SettledEstimate {
  Eigen::VectorXd settled;       ///< to which heat-only cycles with the heat of this run settle, K, by node
  std::vector<double> change;    ///< of the surface of each tool over this cycle, K
  std::vector<double> distance;  ///< from the start of this cycle to `settled`, surface of each tool, K
};

/// The periodic state by several forming runs. The distances of the first ones fall; where they fall no more, they are
/// what forming runs scatter by, whose heats contact and remeshing decide a little otherwise each time. From there on
/// the runs are repeated measurements, and their mean counts.
class SettledEstimates {
 public:
  /// `tools` has the meshes; the tolerance is that of tool surfaces, K.
  SettledEstimates(const State& tools, double tolerance) : tools_(tools), tolerance_(tolerance) {}

  void add(const Eigen::VectorXd& start, const Eigen::VectorXd& end, const Eigen::VectorXd& settled);
  const std::vector<SettledEstimate>& runs() const { return runs_; }

  /// Whether distances fall no more: there are at least two repeated measurements.
  bool only_scatter() const { return repeated() > 1; }
  /// Of the repeated measurements, K, by node.
  Eigen::VectorXd mean() const;
  /// How far the mean may be from the periodic state on any tool surface, K. Of repeated measurements: half the
  /// interval of Student's t that holds 90 of 100 true means. Of a single one twice
  /// what is left of a geometric series of distances, no less than the cycle changed a surface.
  double uncertainty() const;

 private:
  /// How many of the last runs are repeated measurements: the distance of none is more than twice the mean of those
  /// after it, and none changes a surface by more than the tolerance. At least the last one, unless there is none.
  int repeated() const;

  const State& tools_;
  double tolerance_;
  std::vector<SettledEstimate> runs_;
};

}  // namespace parison::forming
