#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "remesh/wall/wall_sides.hpp"

namespace parison::forming {

/// A boundary edge with its place along a stretch of the surface.
struct ChainEdge {
  Index edge;     ///< index into Mesh::boundary
  double start;   ///< arc length from the start of the part to the first node of the edge, m
  double length;  ///< m
};

/// The wanted boundary edges, flagged one by one, in the order of walking them, from where they begin; further parts go
/// on counting.
std::vector<ChainEdge> walk_edges(const core::Mesh& mesh, const std::vector<bool>& wanted_edges);

/// The same for all edges on wanted boundaries.
std::vector<ChainEdge> walk_surface(const core::Mesh& mesh, const std::vector<bool>& wanted_boundaries);

/// What a place of the outer surface is: on the wall, with the inner side opposite; on the rim, where the wall ends; on
/// a foot, a heel or a bead, where the ray inwards finds no inner side; or on glass that is no wall.
enum class WallMark { wall, rim, foot, none };
inline constexpr std::array wall_mark_names{"wall", "rim", "foot", "none"};

/// A node of the outer surface and the wall behind it.
struct ThicknessRow {
  double arc;        ///< along the outer surface, m
  Point position;    ///< m
  double thickness;  ///< the ray through the glass along the inward normal, m; NaN off the wall
  double inner_temperature, outer_temperature;  ///< K; NaN without heat, the inner one off the wall too
  double area;                                  ///< of the outer surface that belongs to the node, m2
  WallMark mark;
  Point inner_position;  ///< where the ray ends, m; NaN off the wall

  bool is_wall() const { return mark == WallMark::wall; }
};

/// The wall along its outer side and its rims; along the whole surface where the glass is no wall.
struct ThicknessProfile {
  std::vector<ThicknessRow> rows;
  std::vector<Index> nodes;        ///< of the rows
  std::vector<Index> outer_edges;  ///< boundary edges that the rows lie on
  std::string no_wall;             ///< why there is none, a sentence; empty with a wall
  std::vector<remesh::Ray> rays;   ///< through the glass, by node of the mesh
  remesh::WallSides sides;         ///< all `none` without a wall
  /// Arcs, m, from which and to which shares of the arc are counted: the ends of the rows, or the middles of the rims.
  double first_arc, last_arc;
};
/// The sides are those of wall_sides. A fixed boundary is where glass is held, a rim; it counts as a side only where
/// there is no wall otherwise. Glass is no wall where less than a quarter of its surface has the other side
/// opposite, or where it is less than one and a half times as long as thick.
ThicknessProfile thickness_profile(const core::Mesh& mesh, core::Geometry geometry);

/// The same for the glass of a state, with temperatures where the scene has heat.
ThicknessProfile thickness_profile(const Scene& scene, const State& state);

/// Over the rows that are wall, which are all nodes of the outer side; the mean is weighted by area, m. Not a number
/// where none is.
struct ThicknessRange {
  double lowest, mean, highest;
  Point lowest_at, highest_at;                                   ///< on the outer side, m
  double lowest_arc = std::numeric_limits<double>::quiet_NaN();  ///< where the lowest is along the outer surface, m
};
ThicknessRange thickness_range(const std::vector<ThicknessRow>& rows);

/// The same without the finish: the rows at heights between which the outer side touches tools that grip it, as a neck
/// ring. All not a number where no such tool is touched.
ThicknessRange thickness_beside_finish(const Scene& scene, const State& state, const ThicknessProfile& profile);

/// Writes thickness.csv.
void write_thickness(const std::string& path, const std::vector<ThicknessRow>& rows);

}  // namespace parison::forming
