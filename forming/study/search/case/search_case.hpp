#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/profile.hpp"
#include "forming/scene/scene.hpp"
#include "forming/study/search/case/search_variable.hpp"
#include "forming/study/sweep/sweep_plan.hpp"

namespace parison::forming {

/// A case and what a search changes of it.
struct SearchCase {
  std::string file;  ///< that says so
  std::string case_path, accuracy;
  std::vector<std::string> overrides;  ///< of all runs
  std::vector<SearchVariable> variables;
  Keep keep = Keep::summary;  ///< of each run
};

/// The assignments of a place of the search, after those of all runs.
std::vector<std::string> settings_at(const std::vector<SearchVariable>& variables, const Eigen::VectorXd& at);

/// Why the case does not take values of the variables; empty where it does. `base` is the case as it stands.
std::string refusal_of(const SearchCase& search, const Scene& base, const Eigen::VectorXd& at);

/// Reads the case at the start and at the corners of the bounds, of which there are up to 1024; throws core::CaseError
/// with the values and reasons of all that are refused or whose tools overlap, eight of them at most.
void check_corners(const SearchCase& search);

/// The last stage up to whose end no variable changes anything; none where the first stage depends on them already.
std::optional<std::string> shared_stage(const SearchCase& search);

/// The runs of some places, which are asked for together.
SweepPlan plan_runs(const SearchCase& search, const std::vector<Eigen::VectorXd>& places, const std::string& output);

/// The outline as a DXF file (R12) in mm, r to the right and z up, its lines and arcs on a layer.
std::string dxf_text(const core::Profile& outline, const std::string& layer);

/// Writes the case with the values of a place into the folder `case` of `output`, complete with the files that it
/// names, and a drawing TOOL.dxf of each tool whose outline is not that of the case without them. Returns the names.
std::vector<std::string> write_case(const SearchCase& search, const Eigen::VectorXd& at, const std::string& output);

}  // namespace parison::forming
