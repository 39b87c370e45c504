// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/mesher/triangulate.hpp"

#include "core/process/gmsh_module.hpp"
#include "remesh/mesher/gmsh_triangulation.hpp"

namespace parison::remesh {

Triangulation triangulate(const Outline& outline, const SizeField& size) {
  constexpr int frontal_delaunay = 6;
  return triangulate_by_gmsh(outline, size, frontal_delaunay);
}

Triangulation triangulate_by_gmsh(const Outline& outline, const SizeField& size, int algorithm) {
  static auto& work = core::gmsh_function<decltype(parison_triangulate)>("parison_triangulate");
  Triangulation result;
  work(
      outline, [&](const core::Point& x) { return size(x); }, algorithm, result);
  return result;
}

}  // namespace parison::remesh
