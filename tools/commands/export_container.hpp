#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

/// What `parison export` was asked for; a path that is empty is not written.
struct ExportRequest {
  std::string results, step, stl, shell;
};

/// Writes the container of a result folder for other programs and prints volumes beside that of the glass; returns the
/// exit code.
int export_container(const ExportRequest& request);

}  // namespace parison::tools
