#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Refuses a case whose glass becomes a body in space, for a question that looks at round glass alone; throws
/// core::CaseError.
void require_round_glass(const Scene& scene, const char* question);
/// Whether a result folder has glass in space.
bool is_in_space(const std::string& directory);

}  // namespace parison::forming
