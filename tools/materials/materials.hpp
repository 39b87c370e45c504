#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// Which bundled materials are shown, all where none is named, and where a plot of their viscosities goes.
struct MaterialsRequest {
  std::vector<std::string> names;
  std::string picture;  ///< SVG file; empty: none
};

/// Lists the bundled materials, or shows some with their values and sources.
int materials(const MaterialsRequest& request);

}  // namespace parison::tools
