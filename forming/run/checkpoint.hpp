#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string>

#include "forming/report/files/result_files.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/resume/checkpoint_files.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// A restart point of a run: the state determines everything that follows, the rest records the past.
struct Checkpoint {
  RunOutcome outcome;
  WrittenFiles files;
};

/// Writes the checkpoint of a result folder and keeps the one before, or the one before that where the last is damaged.
/// Each file is complete or does not exist.
void write_checkpoint(const std::string& directory, const Scene& scene, const Checkpoint& checkpoint);

/// Reads a checkpoint bit for bit; tools that the run has not used yet are as the case has them now. Throws
/// core::CaseError where it belongs to another version or to a case that has changed in what the run has used,
/// core::RunError where it is damaged.
Checkpoint read_checkpoint(const std::string& path, const Scene& scene);

/// The case that a checkpoint was made of.
struct CaseOrigin {
  std::string file, accuracy;
  std::vector<std::string> overrides;
  std::uint64_t fingerprint;
};
CaseOrigin read_origin(const std::string& path);

/// Refuses (core::CaseError) a result folder whose copy of the case is that of none of its checkpoints, where the run
/// is not taken up with the copy itself: whoever has changed it expects the run to go on with it.
void require_unchanged_copy(const std::string& directory, const Scene& scene);

}  // namespace parison::forming
