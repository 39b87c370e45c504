// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/folder_run.hpp"

#include <utility>

#include "forming/run/checkpoint.hpp"
#include "forming/run/observers/checkpoint_writer.hpp"
#include "forming/run/observers/result_writer.hpp"
#include "forming/run/observers/solid_writer.hpp"

namespace parison::forming {

namespace {

Observers with_others(ResultWriter& results, CheckpointWriter& checkpoints, SolidWriter& solid,
                      const Observers& others) {
  Observers all{&results, &checkpoints, &solid};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

}  // namespace

RunOutcome run_in_folder(const Scene& scene, const std::string& directory, const Observers& others,
                         const StopRequest& stop, const remesh::Mesher& mesher, const RunFiles& files) {
  ResultWriter results(directory, files.fields);
  SolidWriter solid(directory, files.fields);
  CheckpointWriter checkpoints(results, solid, files);
  return run(scene, with_others(results, checkpoints, solid, others), stop, mesher);
}

RunOutcome resume_in_folder(const Scene& scene, const std::string& directory, const Observers& others,
                            const StopRequest& stop, const remesh::Mesher& mesher, const RunFiles& files) {
  require_own_checkpoints(directory);
  const std::string path = find_checkpoint(directory);
  Checkpoint from = read_checkpoint(path, scene);
  const bool case_changed = read_origin(path).fingerprint != scene.fingerprint;
  SolidWriter solid(directory, files.fields, from.files);
  ResultWriter results(directory, std::move(from.files), files.fields);
  CheckpointWriter checkpoints(results, solid, files, from.outcome.state.totals.steps, case_changed);
  return resume(scene, std::move(from.outcome), with_others(results, checkpoints, solid, others), stop, mesher);
}

}  // namespace parison::forming
