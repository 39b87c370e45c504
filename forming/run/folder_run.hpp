#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/report/files/result_files.hpp"
#include "forming/run/run.hpp"

namespace parison::forming {

/// Runs a scene and writes its results and checkpoints, as much as `files` says, into a new folder; other observers
/// come after these. Throws core::CaseError where the folder exists and is not empty.
RunOutcome run_in_folder(const Scene& scene, const std::string& directory, const Observers& others = {},
                         const StopRequest& stop = {}, const remesh::Mesher& mesher = remesh::triangulate,
                         const RunFiles& files = {});

/// Continues a run in its folder from the last checkpoint, bit for bit as if it had never stopped. Throws
/// core::CaseError where there is no checkpoint of this scene, core::RunError where another process writes there.
RunOutcome resume_in_folder(const Scene& scene, const std::string& directory, const Observers& others = {},
                            const StopRequest& stop = {}, const remesh::Mesher& mesher = remesh::triangulate,
                            const RunFiles& files = {});

}  // namespace parison::forming
