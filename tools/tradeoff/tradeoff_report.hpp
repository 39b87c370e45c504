#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/describe/model_sensitivity.hpp"
#include "forming/study/convergence_study.hpp"

namespace parison::tools {

/// Reads the results of a study's variants and writes tradeoff.csv, tradeoff.json, tradeoff.md and, where Python can,
/// the plot into the folder; prints the table, with the estimates of what no run can measure. False when the reference
/// or the base has not completed.
bool report_tradeoff(const std::string& folder, const std::vector<forming::Variant>& variants, const std::string& base,
                     const std::vector<forming::PartSensitivity>& estimates);

}  // namespace parison::tools
