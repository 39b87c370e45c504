#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "remesh/surface/outline.hpp"

namespace parison::remesh {

/// What the new mesh of a deforming body should look like.
struct Criteria {
  core::Geometry geometry;
  double surface_size;                    ///< largest edge on the surface, m; inside, twice that
  double skin_size;                       ///< smallest edge a thermal skin may ask for, m
  double elements_across;                 ///< elements across a wall
  double growth;                          ///< of the edge length per metre of distance
  double smallest;                        ///< smallest edge of all, but in films, m
  std::vector<bool> straight_boundaries;  ///< symmetry boundaries: their nodes stay on their line
  std::vector<bool> contact;              ///< per old node: touches a tool
  std::vector<core::Point> keep;          ///< tool corners: a vertex where the surface passes one, m
  std::vector<double>
      target_skin_size;  ///< per old node: edge length the thermal skin asks for, m; infinite where none
  std::vector<double> target_cell_size =
      {};                         ///< per old cell: edge length its solution's error asks for, m; empty where none
  double min_film_thickness = 0;  ///< glass between tools has its elements across down to this thickness, m
  double max_cells = std::numeric_limits<double>::infinity();  ///< about; sizes that ask for more grow everywhere alike
  ExteriorProjection project_out = {};                         ///< the way out of the active tools
};

/// A resampled surface and what is known of its points (vertices first, then mid points, in the order of the outline).
struct Surface {
  Outline outline;
  std::vector<bool> contact;  ///< touches a tool
  std::vector<bool> fixed;    ///< ends of boundaries, corners and points of symmetry boundaries
};

/// Edge lengths over space from the present mesh: the surface size, the wall's thickness, curvature, thermal skin and
/// the error of the solution.
SizeField size_field(const core::Mesh& old, const Criteria& criteria);

/// New points on the old boundary's own curves at those lengths, where an edge dips into a tool on its way out of it;
/// ends of boundaries and corners are kept to the bit.
Surface resample(const core::Mesh& old, const Criteria& criteria, const SizeField& size);

}  // namespace parison::remesh
