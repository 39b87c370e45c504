#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::core {

/// What a unit of cross-section area stands for: a ring of circumference 2 pi r, or a slab 1 m deep.
enum class Geometry { planar, axisymmetric };

/// Boundary edge of a cell, the body on its left: nodes first, last, mid-side.
struct BoundaryEdge {
  std::array<Index, 3> nodes;
  Index cell;
  Index boundary_id;  ///< index into Mesh::boundaries
};

/// Quadratic isoparametric triangles. The vertices are numbered before the mid-side nodes.
struct Mesh {
  std::vector<Point> nodes;                 ///< m
  Index vertex_count = 0;                   ///< nodes [0, vertex_count) are vertices
  std::vector<std::array<Index, 6>> cells;  ///< vertices 0 1 2 counterclockwise, then mid-sides of 01, 12, 20
  std::vector<BoundaryEdge> boundary;       ///< chained: edge i+1 starts where edge i ends, loop by loop
  std::vector<std::string> boundary_names;  ///< names of the boundaries

  Index node_count() const { return static_cast<Index>(nodes.size()); }
  Index cell_count() const { return static_cast<Index>(cells.size()); }
};

/// Index of a boundary by name, -1 when the mesh has none of that name.
Index find_boundary(const Mesh& mesh, const std::string& name);

/// A quadratic mesh from straight-sided triangles: adds mid-side nodes and the chained boundary (boundary 0,
/// "boundary"). Triangles must be counterclockwise.
Mesh make_quadratic_mesh(const std::vector<Point>& vertices, const std::vector<std::array<Index, 3>>& triangles);

/// Nodal field from values at the vertices: the value of a mid-side node is the mean of its ends.
Eigen::VectorXd from_vertices(const Mesh& mesh, const Eigen::VectorXd& vertex_values);
/// The transposed map: what acts on the nodes, collected on the vertices.
Eigen::VectorXd to_vertices(const Mesh& mesh, const Eigen::VectorXd& nodal_load);

/// Volume of the body, m3 (of the full revolution, or per metre of depth times 1 m).
double volume(const Mesh& mesh, Geometry geometry);
/// Integral of a function of a P2 field over the volume by triangle_rule(4), the function's unit times m3.
double integral(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& nodal,
                const std::function<double(double)>& function);
/// Volume mean of a nodal field.
double volume_mean(const Mesh& mesh, Geometry geometry, const Eigen::VectorXd& nodal);

}  // namespace parison::core
