#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "forming/remeshing/remesh_state.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/run_observer.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Asked after each step whether the run is to stop there.
using StopRequest = std::function<bool()>;

/// Runs a scene through all its stages. A run that cannot continue (also because an observer cannot
/// write a file) gives the reason in the facts and returns what it has. Glass is remeshed by `mesher`. Throws
/// core::RunError where a body cannot be meshed at the start, and what an observer throws in RunObserver::run_begins.
RunOutcome run(const Scene& scene, const Observers& observers = {}, const StopRequest& stop = {},
               const remesh::Mesher& mesher = remesh::triangulate);

/// Continues a run from the state and the facts at a moment at which RunObserver::checkpoint_possible was called, bit
/// for bit as if it had never stopped.
RunOutcome resume(const Scene& scene, RunOutcome from, const Observers& observers = {}, const StopRequest& stop = {},
                  const remesh::Mesher& mesher = remesh::triangulate);

}  // namespace parison::forming
