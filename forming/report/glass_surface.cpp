// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/glass_surface.hpp"

#include <algorithm>

#include "core/element.hpp"

namespace parison::forming {
namespace {

/// Past the last edge of the loop that begins at `begin`.
Index loop_end(const core::Mesh& mesh, Index begin) {
  Index end = begin + 1;
  while (end < static_cast<Index>(mesh.boundary.size()) &&
         mesh.boundary[end].nodes[0] == mesh.boundary[end - 1].nodes[1])
    ++end;
  return end;
}

double arc_length(const core::Mesh& mesh, const core::BoundaryEdge& edge) {
  double length = 0;
  for (const core::EdgeRulePoint& at : core::edge_rule(3))
    length += core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, at).area;
  return length;
}

}  // namespace

std::vector<bool> loaded_pieces(const Scene& scene, const core::Mesh& glass) {
  std::vector<bool> loaded(glass.pieces.size(), false);
  const auto last = std::find_if(scene.stages.rbegin(), scene.stages.rend(), [](const Stage& stage) { return !stage.pressure.empty(); });
  if (last == scene.stages.rend()) return loaded;
  for (const auto& entry : last->pressure)
    if (const Index index = core::find_piece(glass, entry.first); index >= 0) loaded[index] = true;
  return loaded;
}

std::vector<ChainEdge> walk_surface(const core::Mesh& mesh, const std::vector<bool>& wanted_pieces) {
  const auto wanted = [&](Index edge) { return wanted_pieces.at(mesh.boundary[edge].piece); };
  std::vector<ChainEdge> chain;
  double arc = 0;
  for (Index begin = 0; begin < static_cast<Index>(mesh.boundary.size());) {
    const Index end = loop_end(mesh, begin), count = end - begin;
    Index first = begin;
    for (Index edge = begin; edge < end; ++edge)
      if (wanted(edge) && !wanted(edge > begin ? edge - 1 : end - 1)) {
        first = edge;
        break;
      }
    for (Index k = 0; k < count; ++k) {
      const Index edge = begin + (first - begin + k) % count;
      if (!wanted(edge)) continue;
      chain.push_back({edge, arc, arc_length(mesh, mesh.boundary[edge])});
      arc += chain.back().length;
    }
    begin = end;
  }
  return chain;
}

}  // namespace parison::forming
