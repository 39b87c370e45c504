#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Whether symmetry planes or fixed boundaries keep the glass from moving along the axis.
bool constrained_along_axis(const Glass& glass);

/// A line on what carries the glass at the start; empty where its weight does not act, or where it is held otherwise.
std::string describe_support(const Scene& scene);

/// That the glass touches no tool at the start, how far it falls and what it meets; empty where that is not so.
std::string falling_note(const Scene& scene);

}  // namespace parison::forming
