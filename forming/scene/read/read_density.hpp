#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "core/case/case_file.hpp"
#include "core/case/table.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Density of a material.
struct Density {
  double value;               ///< kg/m3; of a table, that of its first entry
  core::Table relative = {};  ///< over `value`, by temperature, K; empty: the same at all
};

/// Reads `density`, one value or a table over temperature, or, where that is missing or names it, `expansion`: the
/// density at 20 degC and the linear expansion coefficients of solid and liquid glass.
Density read_density(const core::CaseTable& material);

/// Makes a mean of the density that which all are relative to; `mean` is of the table of `relative_density`.
void relate_density(const std::function<double(const core::Table&)>& mean, Glass& glass);

/// Refuses a density over temperature that does not cover the temperatures of the glass at its start, of all that it
/// meets, and 20 degC, at which the container is measured. `glass` is the table of the case, for the place.
void check_density(const Scene& scene, const core::CaseNode& glass);

}  // namespace parison::forming
