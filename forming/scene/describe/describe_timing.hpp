#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// The stages in degrees and seconds and how long each tool is in use, for the terminal; empty without a timing.
std::string describe_timing(const Scene& scene);

}  // namespace parison::forming
