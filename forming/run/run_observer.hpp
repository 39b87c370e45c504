#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <vector>

#include "forming/report/summary.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/step_result.hpp"

namespace parison::forming {

/// A run at one moment, as its observers see it.
struct RunView {
  const Scene& scene;
  const State& state;
  const RunFacts& facts;                     ///< with the times up to this moment
  const std::shared_ptr<SolidState>& solid;  ///< null while the glass is round
};

/// What follows a run: result files, checkpoints, the console, benchmarks. An observer sees everything and changes
/// nothing; one that throws core::RunError, as for a full disk, ends the run there. All functions do nothing unless
/// they are overridden.
class RunObserver {
 public:
  RunObserver() = default;
  RunObserver(const RunObserver&) = delete;
  RunObserver& operator=(const RunObserver&) = delete;
  virtual ~RunObserver() = default;

  /// Before the first stage, or where a run is taken up again. What is thrown here leaves the run.
  virtual void run_begins(const RunView&) {}
  /// A stage has begun or has failed to begin (see the facts).
  virtual void stage_begins(const RunView&) {}
  /// A step is tried from the state of the view; nothing but the step lies between this call and the next.
  virtual void step_begins(const RunView&) {}
  /// What that step gave; the state of the view is still the one before it.
  virtual void step_tried(const RunView&, const StepResult& /*result*/) {}
  /// A step was accepted; `before` is the state that it began with.
  virtual void step_taken(const RunView&, const State& /*before*/, const StepReport& /*report*/) {}
  /// Fields are due: at an output time, at which the state may be interpolated, at the run's start, at the end of a
  /// stage and where a run fails.
  virtual void fields_due(const RunView&, const State& /*at*/) {}
  /// A step of glass in space was accepted; the view's state has the clock and the places of tools.
  virtual void solid_step_taken(const RunView&, const SolidState&) {}
  /// Fields of glass in space are due.
  virtual void solid_fields_due(const RunView&, const SolidState&) {}
  /// From the state of the view the run could be taken up again.
  virtual void checkpoint_possible(const RunView&, bool /*at_stage_boundary*/) {}
  /// A stage is over; its record is the last of the facts.
  virtual void stage_ends(const RunView&) {}
  /// The facts are complete.
  virtual void run_ends(const RunView&) {}
};

/// Observers in the order in which they are called; none is owned.
using Observers = std::vector<RunObserver*>;

}  // namespace parison::forming
