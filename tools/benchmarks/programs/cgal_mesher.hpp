#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/mesher/triangulate.hpp"

namespace parison::bench {

/// Delaunay refinement of CGAL.
struct CgalOptions {
  bool keep_edges;      ///< of the outline: a circumcentre that would split one is left out
  int lloyd_passes;     ///< 0: none
  double smooth_below;  ///< quality below which the corners of triangles are moved; 0: as gmsh's
};

/// Triangles in an outline of one loop, whose edges contain the points that the mesher put on them.
struct CgalMesh {
  remesh::Outline outline;
  remesh::Triangulation triangles;
  core::Index added = 0;  ///< points on the outline
};
CgalMesh cgal_mesh(const remesh::Outline& outline, const remesh::SizeField& size, const CgalOptions& options);

}  // namespace parison::bench
