// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/benchmarks/programs/cgal_mesher.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/lloyd_optimize_mesh_2.h>

#include <algorithm>
#include <map>

namespace parison::bench {

using core::Index;
using core::Point;

namespace {

struct Number {
  Index value = -1;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Delaunay_mesh_vertex_base_2<Kernel, CGAL::Triangulation_vertex_base_with_info_2<Number, Kernel>>;
using Face = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;
using Handle = Delaunay::Vertex_handle;

/// Longest edge over the size there, at which the refinement makes about as many triangles as gmsh's frontal one.
constexpr double longest = 1.33;
constexpr double min_sine_squared = 0.125;  ///< 20.7 degrees, up to which the refinement is sure to end

/// When a triangle is to be refined: an edge too long for the size field, or an angle too small.
struct FieldCriteria {
  const remesh::SizeField* size;

  struct Quality {
    double length = 0, sine = 1;  ///< squared: longest edge over what is allowed, sine of the smallest angle
    bool operator<(const Quality& other) const {
      const bool is_long = length > 1, other_long = other.length > 1;
      if (is_long != other_long) return is_long;
      return is_long ? length > other.length : sine < other.sine;
    }
  };

  struct Is_bad {
    const remesh::SizeField* size;

    CGAL::Mesh_2::Face_badness operator()(const Quality& quality) const {
      if (quality.length > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return quality.sine < min_sine_squared ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(const Delaunay::Face_handle& face, Quality& quality) const {
      std::array<Point, 3> x;
      for (int k = 0; k < 3; ++k) x[k] = {face->vertex(k)->point().x(), face->vertex(k)->point().y()};
      const Point u = x[1] - x[0], v = x[2] - x[0];
      std::array<double, 3> side{u.squaredNorm(), v.squaredNorm(), (x[2] - x[1]).squaredNorm()};
      std::sort(side.begin(), side.end());
      const double allowed = longest * (*size)((x[0] + x[1] + x[2]) / 3);
      const double area = u[0] * v[1] - u[1] * v[0];
      quality = {side[2] / (allowed * allowed), area * area / (side[1] * side[2])};
      return (*this)(quality);
    }
  };
  Is_bad is_bad_object() const { return {size}; }
};

/// Stands in for the level of CGAL's mesher that splits edges: drops circumcentres that are too near to one or beyond
/// it.
struct KeptEdges : CGAL::Null_mesher_level {
  void set_imperative_refinement(bool) {}

  template <class Zone>
  CGAL::Mesher_level_conflict_status test_point_conflict_from_superior(const Kernel::Point_2& at, Zone& zone) const {
    constexpr double flattest = -0.5;  // cosine of the angle under which the point may see an edge
    const Point x(at.x(), at.y());
    bool drop = std::find(zone.faces.begin(), zone.faces.end(), zone.parent_face) == zone.faces.end();
    for (const auto& [face, i] : zone.boundary_edges) {
      if (!face->is_constrained(i)) continue;
      const auto &p = face->vertex(Delaunay::cw(i))->point(), &q = face->vertex(Delaunay::ccw(i))->point();
      const Point u = Point(p.x(), p.y()) - x, v = Point(q.x(), q.y()) - x;
      drop |= CGAL::orientation(p, q, at) != CGAL::LEFT_TURN || u.dot(v) < flattest * u.norm() * v.norm();
    }
    return drop ? CGAL::CONFLICT_AND_ELEMENT_SHOULD_BE_DROPPED : CGAL::NO_CONFLICT;
  }
};

std::vector<Handle> insert_outline(const remesh::Outline& outline, Delaunay& triangles) {
  std::vector<Handle> corners;
  Delaunay::Face_handle near;
  for (const Point& x : outline.vertices) {
    corners.push_back(triangles.insert({x[0], x[1]}, near));
    near = corners.back()->face();
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    triangles.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  return corners;
}

void refine(const remesh::SizeField& size, bool keep_edges, Delaunay& triangles) {
  FieldCriteria criteria{&size};
  CGAL::Delaunay_mesher_2<Delaunay, FieldCriteria> mesher(triangles, criteria);
  if (!keep_edges) return mesher.refine_mesh();
  mesher.mark_facets();
  KeptEdges edges;
  CGAL::Mesh_2::Refine_faces<Delaunay, FieldCriteria, KeptEdges> faces(triangles, criteria, edges);
  faces.scan_triangulation();
  faces.refine(CGAL::Null_mesh_visitor());
}

/// Puts the points that belong to an edge of the outline, shares of its chord, on the edge itself.
void add_edge(const remesh::Outline& from, Index edge, Index end, const std::vector<double>& fractions,
              remesh::Outline& to) {
  const Point &a = from.vertices[edge], &b = from.vertices[end], &mid = from.mids[edge];
  const auto on_edge = [&](double s) -> Point {
    return (1 - s) * (1 - 2 * s) * a + s * (2 * s - 1) * b + 4 * s * (1 - s) * mid;
  };
  double before = 0;
  for (std::size_t k = 0; k <= fractions.size(); ++k) {
    const double after = k < fractions.size() ? fractions[k] : 1;
    to.vertices.push_back(k == 0 ? a : on_edge(before));
    to.mids.push_back(fractions.empty() ? mid : on_edge(0.5 * (before + after)));
    to.boundary_ids.push_back(from.boundary_ids[edge]);
    before = after;
  }
}

/// Walks along the meshed outline and numbers its vertices.
CgalMesh read_back_outline(const remesh::Outline& outline, const std::vector<Handle>& corners, Delaunay& triangles) {
  std::map<Handle, Handle> next;
  for (const auto face : triangles.finite_face_handles())
    for (int i = 0; i < 3; ++i)
      if (face->is_in_domain() && !face->neighbor(i)->is_in_domain())
        next[face->vertex(Delaunay::ccw(i))] = face->vertex(Delaunay::cw(i));
  CgalMesh result;
  for (Index i = 0; i < outline.edge_count(); ++i) {
    const Index end = (i + 1) % outline.edge_count();
    const Point a = outline.vertices[i], chord = outline.vertices[end] - a;
    std::vector<double> fractions;
    corners[i]->info().value = static_cast<Index>(result.outline.vertices.size());
    for (Handle at = next.at(corners[i]); at != corners[end]; at = next.at(at)) {
      fractions.push_back((Point(at->point().x(), at->point().y()) - a).dot(chord) / chord.squaredNorm());
      at->info().value = static_cast<Index>(result.outline.vertices.size() + fractions.size());
    }
    add_edge(outline, i, end, fractions, result.outline);
  }
  result.outline.loop_start.push_back(result.outline.edge_count());
  result.added = result.outline.edge_count() - outline.edge_count();
  return result;
}

}  // namespace

CgalMesh cgal_mesh(const remesh::Outline& outline, const remesh::SizeField& size, const CgalOptions& options) {
  if (outline.loop_start.size() != 2) return {{}, {{}, {}, "more than one loop"}};
  Delaunay triangles;
  const std::vector<Handle> corners = insert_outline(outline, triangles);
  refine(size, options.keep_edges, triangles);
  if (options.lloyd_passes > 0)
    CGAL::lloyd_optimize_mesh_2(triangles, CGAL::parameters::max_iteration_number = options.lloyd_passes);
  CgalMesh result = read_back_outline(outline, corners, triangles);
  result.triangles.vertices = result.outline.vertices;
  for (const auto face : triangles.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    std::array<Index, 3> cell;
    for (int k = 0; k < 3; ++k) {
      const Handle vertex = face->vertex(k);
      if (vertex->info().value < 0) {
        vertex->info().value = static_cast<Index>(result.triangles.vertices.size());
        result.triangles.vertices.emplace_back(vertex->point().x(), vertex->point().y());
      }
      cell[k] = vertex->info().value;
    }
    result.triangles.triangles.push_back(cell);
  }
  if (options.smooth_below > 0)
    remesh::smooth_poor_triangles(result.outline.vertices.size(), options.smooth_below, result.triangles);
  return result;
}

}  // namespace parison::bench
