#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <optional>
#include <string>

#include "core/mesh/mesh.hpp"

namespace parison::tools {

/// The glass at an output of a run.
struct HotSection {
  double time;  ///< s
  core::Mesh mesh;
  Eigen::VectorXd temperature;  ///< K
};

/// Reads the output of a result folder that is nearest to a time, s, the last one without a time. Throws
/// core::CaseError where there is none, or where the glass carries no heat.
HotSection read_hot_section(const std::string& folder, std::optional<double> time);

}  // namespace parison::tools
