#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/run/run_observer.hpp"

namespace parison::tools {

/// Steps that each stage of a scene may take, from the case alone: those in which the contact front passes the contact
/// boundaries of tools that the glass has yet to meet, in stages in which a tool or air drives the glass; and those
/// that a stage takes in which little happens. Only their proportions count.
std::vector<double> expected_steps(const forming::Scene& scene);

/// Predicts what is left of a run from what its stages have cost so far.
class RemainingTime {
 public:
  void run_begins(const forming::RunView& run);
  void stage_begins(const forming::RunView& run);

  /// Share of the whole cost that is done, 0 to 1, by the steps of the stages over, of the present one and of those to
  /// come.
  double fraction_done(const forming::RunView& run);

 private:
  std::vector<double> expected_;
  forming::Index steps_at_stage_ = 0;  ///< done when the present stage began
  double expected_of_done_ = 0;        ///< of the stages over, since the run was taken up
  forming::Index steps_at_start_ = 0;  ///< done when the run was taken up
};

}  // namespace parison::tools
