#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Refuses a case whose glass becomes a body in space, for a question that looks at round glass alone; throws
/// core::CaseError.
void require_round_glass(const Scene& scene, const char* question);
/// The same of a result folder.
void require_round_results(const std::string& directory, const char* question);

}  // namespace parison::forming
