#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>
#include <optional>

#include "forming/study/production/cycle_run.hpp"

namespace parison::forming {

/// A map of vectors; nothing where it cannot be evaluated.
using VectorMap = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd&)>;

struct FixedPointOptions {
  double tolerance;     ///< of the size of x - map(x)
  int depth;            ///< of Anderson's acceleration
  int delay;            ///< plain iterations before it
  int max_evaluations;  ///< of the map
  std::function<double(const Eigen::VectorXd& change)> size;
};

struct FixedPointOutcome {
  bool converged = false;
  int evaluations = 0;
  double change = 0;      ///< size of the last x - map(x)
  Eigen::VectorXd value;  ///< the last map(x)
};

/// Looks for x = map(x) by the fixed-point iteration of SUNDIALS KINSOL with Anderson's acceleration (D. G. Anderson,
/// J. ACM 12 (1965) 547-560; H. F. Walker, P. Ni, SIAM J. Numer. Anal. 49 (2011) 1715-1735). Where that leads
/// away it begins anew from the best so far. It stops at the first x that meets the tolerance and where the map cannot
/// be evaluated.
FixedPointOutcome find_fixed_point(const Eigen::VectorXd& start, const VectorMap& map,
                                   const FixedPointOptions& options);

/// Machine cycles of the tools alone, without forming. When the glass leaves a tool, each place of it is as much nearer
/// to the temperature of the glass, when that first meets the tool, as one forming run has brought it there. That
/// share is between none and all, so that no place passes the glass, and cycle after cycle settles. Then the tool
/// cools as it does without glass. At the temperatures of the run itself this is the run.
class HeatCycles {
 public:
  HeatCycles(const Scene& scene, const MachineCycle& cycle, const State& initial);

  /// Takes what this run has done to the tools. False where the tools alone cannot be computed.
  bool learn(const CycleRun& run);
  /// Corrects it by what a cycle lacks to give these temperatures back; learn has been called. False as there.
  bool hold(const Eigen::VectorXd& temperatures);
  /// Tool temperatures a cycle later.
  std::optional<Eigen::VectorXd> next(const Eigen::VectorXd& temperatures) const;
  /// Tool temperatures that a cycle does not change, from those given; nothing where none are found.
  std::optional<Eigen::VectorXd> settled(const Eigen::VectorXd& start, double tolerance) const;

 private:
  /// What the use of the tool of this index does to its temperatures, that are given without glass.
  using Use = std::function<void(std::size_t tool, Eigen::VectorXd& temperature)>;

  /// When the cycles of the tools end, s since the start of a container.
  std::vector<double> tool_ends() const;
  /// Tool temperatures a cycle later, with what their uses do at the end of each.
  std::optional<Eigen::VectorXd> cycle_with(const Eigen::VectorXd& temperatures, const Use& use) const;

  const Scene& scene_;
  const MachineCycle& cycle_;
  State tools_;
  std::vector<double> use_ends_;        ///< s since the start of a container, by tool; infinity for one without use
  std::vector<Eigen::VectorXd> kept_;   ///< by tool and node: share of the temperature without glass
  std::vector<Eigen::VectorXd> given_;  ///< what is added to it when the use ends, K
  Eigen::VectorXd rest_;                ///< what is added to tool_temperatures at the end of the cycle, K
};

}  // namespace parison::forming
