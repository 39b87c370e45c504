#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::forming {

/// The name of a checkpoint that is being written.
std::string new_checkpoint(const std::string& directory);

/// Makes it the last checkpoint of its folder and keeps the one before, or the one before that where the last is
/// damaged.
void put_in_place(const std::string& directory);

/// Keeps the last checkpoint of a folder, which is of the end of a stage, under the name of the stage.
void keep_checkpoint(const std::string& directory, const std::string& stage);

/// The checkpoint of the end of a stage; throws core::CaseError where there is none, with the stages that have one.
std::string find_stage_end(const std::string& directory, const std::string& stage);

/// Throws core::CaseError that names a file of the user under the name of a checkpoint; a damaged checkpoint is none.
void require_own_checkpoints(const std::string& directory);

/// Makes that checkpoint the last one of its folder; those of later stages are removed.
void return_to_stage_end(const std::string& directory, const std::string& stage);

/// Whether a folder contains a checkpoint whose digest fits.
bool has_checkpoint(const std::string& directory);

/// The last checkpoint of a result folder whose digest fits; throws core::CaseError where there is none.
std::string find_checkpoint(const std::string& directory);

/// Why the last checkpoint of a folder is passed over, as a sentence: some byte has changed; else empty.
std::string damage_of_last_checkpoint(const std::string& directory);

}  // namespace parison::forming
