#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// What `parison audit` is asked for.
struct AuditRequest {
  std::string case_path, accuracy = "draft coarser 2";
  std::vector<std::string> overrides;
};

/// Runs a case with each part of its model in and out, at a coarse accuracy, and prints what each part changes. Returns
/// the exit code.
int audit(const AuditRequest& request);

}  // namespace parison::tools
