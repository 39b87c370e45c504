#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Which boundaries of the glass mesh carry a pressure (even one of 0) in the last stage that names a pressure: the
/// inner side of the container.
std::vector<bool> loaded_boundaries(const Scene& scene, const core::Mesh& glass);

/// A boundary edge and its position along a part of the surface.
struct ChainEdge {
  Index edge;     ///< index into Mesh::boundary
  double start;   ///< arc length from the start of the part to the first node of the edge, m
  double length;  ///< m
};

/// The boundary edges on wanted boundaries in the order of walking them, from where they begin; the arc length
/// continues over further parts.
std::vector<ChainEdge> walk_surface(const core::Mesh& mesh, const std::vector<bool>& wanted_boundaries);

/// Glass boundary edges of the outer surface: neither on a symmetry boundary nor on one that a stage loads with a
/// pressure.
std::vector<Index> outer_edges(const Scene& scene, const core::Mesh& glass);

/// A node of the outer surface and the wall behind it.
struct ThicknessRow {
  double arc;                                   ///< along the outer surface, m
  Point position;                               ///< m
  double thickness;                             ///< m
  double inner_temperature, outer_temperature;  ///< K; NaN without heat
  double area;                                  ///< of the outer surface that belongs to the node, m2
  bool is_wall;  ///< the other side faces it and some stage loads it with a pressure; true where no stage loads any
};
std::vector<ThicknessRow> thickness_profile(const Scene& scene, const State& state);

/// Over the rows that are wall; the mean is weighted by area, m.
struct ThicknessRange {
  double lowest, mean, highest;
};
ThicknessRange thickness_range(const std::vector<ThicknessRow>& rows);

/// Writes thickness.csv.
void write_thickness(const std::string& path, const std::vector<ThicknessRow>& rows);

}  // namespace parison::forming
