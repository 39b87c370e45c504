#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "remesh/surface/curve.hpp"
#include "remesh/surface/outline.hpp"

namespace parison::remesh {

/// Largest angle by which the surface turns within one edge of a new mesh.
inline constexpr double max_turn = 20 * M_PI / 180;

/// Requirements on the new mesh of a deforming body.
struct Criteria {
  core::Geometry geometry;
  double surface_size;                    ///< largest edge on the surface, m; twice as long inside
  double skin_size;                       ///< smallest edge that a thermal skin can require, m
  double elements_across;                 ///< number of elements across a wall
  double growth;                          ///< increase of the edge length per metre of distance
  double min_size;                        ///< smallest edge outside films, m
  std::vector<bool> straight_boundaries;  ///< symmetry boundaries, whose nodes stay on their line
  std::vector<bool> contact;              ///< for each old node, whether it touches a tool
  std::vector<core::Point> keep;          ///< tool corners, m; the surface gets a vertex where it passes one
  /// For each old node the edge length that the thermal skin requires, m; infinite where there is none.
  std::vector<double> target_skin_size;
  /// For each old cell the edge length that a start temperature which varies requires, m; may be empty.
  std::vector<double> target_cell_size = {};
  double min_film_thickness = 0;  ///< films of at least this thickness have all their elements across, m
  /// Approximate limit of the number of cells; where it is exceeded, all edge lengths grow by the same factor.
  double max_cells = std::numeric_limits<double>::infinity();
  ExteriorProjection project_out = {};  ///< projection out of the active tools
  bool has_skin = false;                ///< a thermal skin under the surface, in which the first cells are thinner
};

/// A resampled surface with flags for its points: all vertices, then all mid points, in the order of the outline.
struct Surface {
  Outline outline;
  std::vector<bool> contact;  ///< touches a tool
  std::vector<bool> fixed;    ///< end of a boundary, corner or point of a symmetry boundary
};

/// Size field of the new mesh from the largest surface edge, the wall thickness, the curvature, the thermal skin and
/// the sizes of cells.
SizeField size_field(const core::Mesh& old, const Criteria& criteria);

/// Whether a surface that passes a corner of a tool closely is led into it.
enum class CornerFilling { where_little_is_missing, none };

/// Divides the old boundary's quadratic curves according to the size field. Edges that penetrate a tool are divided on
/// their projection out of it. Ends of boundaries and corners keep their exact positions.
Surface resample(const core::Mesh& old, const Criteria& criteria, const SizeField& size,
                 CornerFilling filling = CornerFilling::where_little_is_missing);

/// The parameter at which an old edge passes a tool corner, and the position of the vertex placed there, m.
struct Kept {
  double s;
  core::Point vertex;
};

/// An old edge that counts as filling a tool corner: the surface follows both walls, which it meets there at s.
struct FilledEdge {
  double s;
  core::Point corner;
};

/// What the surface does at the tool corners: where it gets a vertex, by old edge, and the edges that fill a corner.
struct Corners {
  std::map<core::Index, Kept> kept;
  std::map<core::Index, FilledEdge> filled;
};

/// Whether the first vertex of an old edge keeps its exact position: an end of a boundary or a corner of the body.
bool is_fixed(const core::Mesh& old, const std::vector<Link>& links, core::Index edge);

/// What the new surface does at the tool corners `criteria.keep`. Where the old one counts as filling a corner the
/// vertex lies in it: how much of it a mesh fills would be chance, and with it where all glass beside the corner lies.
Corners find_corners(const core::Mesh& old, const Criteria& criteria, const SizeField& size, CornerFilling filling);

}  // namespace parison::remesh
