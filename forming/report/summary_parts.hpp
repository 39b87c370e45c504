#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/json.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/report/summary.hpp"

namespace parison::forming {

/// What the steps took, as an object of summary.json.
void add_solver_statistics(core::JsonWriter& json, const SolverStatistics& statistics);

/// The work on the glass, likewise.
void add_work(core::JsonWriter& json, const Work& work);

/// The sealed cavities of a state, where a stage of the scene seals any.
void add_cavities(core::JsonWriter& json, const Scene& scene, const State& state);

/// Error bars, and the runs that were made for an accuracy that was asked for.
void add_errors(core::JsonWriter& json, const ErrorBars& bars);
void add_control(core::JsonWriter& json, const AccuracyRecord& control);

/// Imbalance of the work at any stage's end, without sign; NaN where nothing flows.
double max_work_imbalance(const Scene& scene, const State& state, const RunFacts& run);

}  // namespace parison::forming
