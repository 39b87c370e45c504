#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Writes a mesh as text (nodes, then cells) into the folder named by PARISON_SHOW, where that is set.
inline void show(const core::Mesh& mesh, const std::string& name) {
  const char* folder = std::getenv("PARISON_SHOW");
  if (!folder) return;
  std::ofstream file(std::string(folder) + "/" + name + ".txt");
  file.precision(12);
  file << mesh.node_count() << ' ' << mesh.cell_count() << '\n';
  for (const core::Point& x : mesh.nodes) file << x.transpose() << '\n';
  for (const auto& cell : mesh.cells()) {
    for (const core::Index node : cell) file << node << ' ';
    file << '\n';
  }
}

}  // namespace parison::remesh
