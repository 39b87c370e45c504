#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/run/resume/case_differences.hpp"
#include "forming/scene/scene.hpp"
#include "forming/study/comparison/finished_run.hpp"

namespace parison::forming {

/// By what two scenes are of different cases: case (its name), geometry, tools or stages, as each has it.
struct OtherCase {
  std::string what, base, other;
};
/// The first of them in which two scenes differ; nothing where they are of one case up to settings.
std::optional<OtherCase> other_case(const Scene& base, const Scene& other);

/// The settings in which the cases of two result folders differ, by the copies of the cases in the folders. Throws
/// core::CaseError where they are not the same case up to settings: another name, geometry, or other bodies or stages;
/// or where a folder has no copy of its case.
std::vector<CaseDifference> settings_that_differ(const FinishedRun& base, const FinishedRun& other);

/// After how many stages of the base the settings of the other may first have changed something; all of them where the
/// settings are the same.
std::size_t stages_without_influence(const FinishedRun& base, const FinishedRun& other);

/// Settings in a line: "tool.blank.temperature: 460 degC -> 440 degC".
std::string settings_line(const std::vector<CaseDifference>& settings);

}  // namespace parison::forming
