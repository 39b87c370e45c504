#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "forming/study/production/cycle_run.hpp"

namespace parison::forming {

/// Machine cycles of the tools alone, without forming: what one forming run has left in them, field by field, is added
/// to a cycle in which no glass touches them. It is in proportion to the excess of the glass, when it first meets the
/// tool, over the temperature of the place at the cycle's start. At the temperatures of the run itself this is the run.
class HeatCycles {
 public:
  HeatCycles(const Scene& scene, const MachineCycle& cycle, const State& initial);

  /// Takes what this run has left in the tools. False where the tools alone cannot be computed.
  bool learn(const CycleRun& run);
  /// Takes the heat with which a cycle gives these temperatures back; learn has been called. False as there.
  bool hold(const Eigen::VectorXd& temperatures);
  /// Tool temperatures a cycle later.
  std::optional<Eigen::VectorXd> next(const Eigen::VectorXd& temperatures) const;
  /// Tool temperatures that a cycle does not change, from those given; nothing where none are found.
  std::optional<Eigen::VectorXd> settled(const Eigen::VectorXd& start, double tolerance) const;

 private:
  /// When the cycles of the tools end, s since the start of a container.
  std::vector<double> tool_ends() const;
  std::optional<Eigen::VectorXd> without_glass(const Eigen::VectorXd& temperatures) const;

  const Scene& scene_;
  const MachineCycle& cycle_;
  State tools_;
  Eigen::VectorXd start_, imprint_;  ///< of the run: temperatures at its start and what it has left, K, by node
  std::vector<double> met_;          ///< K, by tool
};

}  // namespace parison::forming
