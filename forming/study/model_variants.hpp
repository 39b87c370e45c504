#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/study/convergence_study.hpp"

namespace parison::forming {

/// A variant for each part of the model that a scene has, which leaves that part out.
std::vector<Variant> model_variants(const Scene& scene);

}  // namespace parison::forming
