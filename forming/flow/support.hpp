#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/flow/problem.hpp"

namespace parison::flow {

/// A rigid motion of the glass that nothing can hold, as a sentence; empty where there is none. Symmetry planes, fixed pieces
/// and every candidate count, closed or not: tools that stick or rub hold sideways as well.
std::string free_motion(const Problem& problem);

}  // namespace parison::flow
