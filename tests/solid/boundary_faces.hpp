#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <vector>

#include "core/solid/quad_face.hpp"

namespace parison::core::test {

/// The faces of cells that no other cell shares, in the order of the cells.
inline std::vector<HexFace> boundary_faces(const HexMesh& mesh) {
  std::map<Index, int> uses;  // of the node in the middle of each face
  const auto middle = [&](const HexFace& face) { return quad_face(mesh, face).nodes[4]; };
  const auto for_each_face = [&](const auto& visit) {
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) visit(HexFace{cell, axis, end});
  };
  for_each_face([&](const HexFace& face) { ++uses[middle(face)]; });
  std::vector<HexFace> faces;
  for_each_face([&](const HexFace& face) {
    if (uses[middle(face)] == 1) faces.push_back(face);
  });
  return faces;
}

}  // namespace parison::core::test
