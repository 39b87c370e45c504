#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene.hpp"
#include "forming/state.hpp"

namespace parison::forming {

/// Writes the whole state to an HDF5 file that appears complete or not at all.
void write_checkpoint(const std::string& path, const Scene& scene, const State& state);

/// Reads it back bit for bit; throws core::CaseError where it belongs to another case or version.
State read_checkpoint(const std::string& path, const Scene& scene);

}  // namespace parison::forming
