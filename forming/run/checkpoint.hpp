#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string>

#include "forming/report/files/result_files.hpp"
#include "forming/report/summary.hpp"
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

/// Keeps the last checkpoint of a folder, which is of the end of a stage, under the name of the stage.
void keep_checkpoint(const std::string& directory, const std::string& stage);

/// The checkpoint of the end of a stage; throws core::CaseError where there is none, with the stages that have one.
std::string find_stage_end(const std::string& directory, const std::string& stage);

/// Makes that checkpoint the last one of its folder; those of later stages are removed.
void return_to_stage_end(const std::string& directory, const std::string& stage);

/// Whether a folder contains a checkpoint whose digest fits.
bool has_checkpoint(const std::string& directory);

/// The last checkpoint of a result folder whose digest fits; throws core::CaseError where there is none.
std::string find_checkpoint(const std::string& directory);

/// Why the last checkpoint of a folder is passed over, as a sentence: some byte has changed; else empty.
std::string damage_of_last_checkpoint(const std::string& directory);

/// Reads a checkpoint bit for bit; throws core::CaseError where it belongs to another version or to a case that has
/// changed in what the run has used, core::RunError where it is damaged.
Checkpoint read_checkpoint(const std::string& path, const Scene& scene);

/// The case that a checkpoint was made of.
struct CaseOrigin {
  std::string file, accuracy;
  std::vector<std::string> overrides;
  std::uint64_t fingerprint;
};
CaseOrigin read_origin(const std::string& path);

}  // namespace parison::forming
