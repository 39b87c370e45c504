// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/mesher/gmsh_triangulation.hpp"

#include <gmsh.h>

#include <cmath>
#include <unordered_map>

#include "core/process/gmsh_session.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

constexpr int linear_line = 1, linear_triangle = 2;

/// Options of gmsh beyond those of every session.
void set_options(int algorithm, core::GmshSession& gmsh) {
  for (const char* off : {"Mesh.Renumber", "Mesh.MeshSizeExtendFromBoundary", "Mesh.MeshSizeFromPoints"})
    gmsh.set_option(off, 0);
  for (const char* threads : {"Mesh.MaxNumThreads1D", "Mesh.MaxNumThreads2D"}) gmsh.set_option(threads, 1);
  gmsh.set_option("Mesh.MeshOnlyEmpty", 1);
  gmsh.set_option("Mesh.Algorithm", algorithm);
  gmsh.set_option("Mesh.Smoothing", 0);  // smooth_poor_triangles does that cheaper
}

/// Factor that makes the larger extent of the body 100 units: far from gmsh's absolute tolerances, and the same numbers
/// whatever the size of the body is.
double unit_scale(const Outline& outline) {
  Point low = outline.vertices[0], high = low;
  for (const Point& x : outline.vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return 100 / (high - low).maxCoeff();
}

std::size_t tag_of(Index vertex) {
  return static_cast<std::size_t>(vertex) + 1;
}

/// A point in units of gmsh, to 6e-8 of them: round-off in the outline, as of a scaled copy of the body, does not
/// change the triangulation. The vertices of the outline keep their own coordinates.
std::array<double, 3> scaled(const Point& x, double scale) {
  constexpr double resolution = 1.0 / (1 << 24);
  const auto rounded = [&](double value) { return resolution * std::round(scale * value / resolution); };
  return {rounded(x[0]), rounded(x[1]), 0};
}

/// Hands gmsh the loop from vertex `first` to `last` as one curve that is meshed already.
int add_curve(const Outline& outline, double scale, Index first, Index last) {
  const int curve =
      gmsh::model::addDiscreteEntity(1, -1, {static_cast<int>(tag_of(first)), static_cast<int>(tag_of(last))});
  std::vector<std::size_t> nodes, edges, corners;
  std::vector<double> coordinates;
  for (Index i = first; i < last; ++i) {
    edges.push_back(tag_of(i));
    corners.insert(corners.end(), {tag_of(i), tag_of(i + 1)});
    if (i == first) continue;
    const auto x = scaled(outline.vertices[i], scale);
    nodes.push_back(tag_of(i));
    coordinates.insert(coordinates.end(), x.begin(), x.end());
  }
  gmsh::model::mesh::addNodes(1, curve, nodes, coordinates);
  gmsh::model::mesh::addElementsByType(curve, linear_line, edges, corners);
  return curve;
}

/// Each loop as a curve that is meshed already, which costs less than one for each edge, closed by its last edge: a
/// straight line, from which gmsh knows which way is up. Node i + 1 is vertex i.
void add_outline(const Outline& outline, double scale) {
  for (std::size_t k = 0; k + 1 < outline.loop_start.size(); ++k)
    for (const Index end : {outline.loop_start[k], outline.loop_start[k + 1] - 1}) {
      const auto x = scaled(outline.vertices[end], scale);
      gmsh::model::geo::addPoint(x[0], x[1], 0, 0, static_cast<int>(tag_of(end)));
    }
  gmsh::model::geo::synchronize();
  std::vector<int> loops;
  for (std::size_t k = 0; k + 1 < outline.loop_start.size(); ++k) {
    const Index first = outline.loop_start[k], last = outline.loop_start[k + 1] - 1;
    for (const Index end : {first, last}) {
      const auto x = scaled(outline.vertices[end], scale);
      gmsh::model::mesh::addNodes(0, static_cast<int>(tag_of(end)), {tag_of(end)}, {x.begin(), x.end()});
    }
    const int curve = add_curve(outline, scale, first, last);
    const int closing = gmsh::model::geo::addLine(static_cast<int>(tag_of(last)), static_cast<int>(tag_of(first)));
    gmsh::model::geo::synchronize();
    gmsh::model::mesh::addElementsByType(closing, linear_line, {tag_of(last)}, {tag_of(last), tag_of(first)});
    loops.push_back(gmsh::model::geo::addCurveLoop({curve, closing}));
  }
  gmsh::model::geo::addPlaneSurface(loops, 1);
  gmsh::model::geo::synchronize();
}

/// Meshes a triangle that is always the same: what gmsh remembers of the last body would change the bits of the next.
void forget_last_body(core::GmshSession& gmsh) {
  Outline triangle;
  triangle.vertices = {Point(0, 0), Point(1, 0), Point(0, 1)};
  triangle.loop_start = {0, 3};
  add_outline(triangle, 1);
  gmsh::model::mesh::generate(2);
  gmsh.renew_model();
  gmsh.restart_random_numbers();  // gmsh perturbs points by them
}

/// Reads the triangles back.
Triangulation read_triangles(const Outline& outline, double scale) {
  Triangulation result;
  result.vertices = outline.vertices;
  std::vector<std::size_t> tags, elements, corners;
  std::vector<double> coordinates, unused;
  std::unordered_map<std::size_t, Index> number;
  gmsh::model::mesh::getNodes(tags, coordinates, unused, 2, -1, false, false);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    number[tags[i]] = static_cast<Index>(result.vertices.size());
    result.vertices.emplace_back(coordinates[3 * i] / scale, coordinates[3 * i + 1] / scale);
  }
  gmsh::model::mesh::getElementsByType(linear_triangle, elements, corners);
  for (std::size_t t = 0; t < elements.size(); ++t) {
    std::array<Index, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      const std::size_t tag = corners[3 * t + k];
      const auto found = number.find(tag);
      if (tag > outline.vertices.size() && found == number.end())
        return {{}, {}, "the mesher split edges of the outline"};
      triangle[k] = found == number.end() ? static_cast<Index>(tag) - 1 : found->second;
    }
    const Point u = result.vertices[triangle[1]] - result.vertices[triangle[0]];
    const Point v = result.vertices[triangle[2]] - result.vertices[triangle[0]];
    if (u[0] * v[1] < u[1] * v[0]) std::swap(triangle[1], triangle[2]);
    result.triangles.push_back(triangle);
  }
  return result;
}

}  // namespace

extern "C" void parison_triangulate(const Outline& outline, const SizeAt& size, int algorithm, Triangulation& result) {
  core::GmshSession session;
  set_options(algorithm, session);
  forget_last_body(session);
  const double scale = unit_scale(outline);
  add_outline(outline, scale);
  // In single precision, for the same reason as the rounded coordinates.
  gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double) {
    return static_cast<float>(scale * size(Point(x / scale, y / scale)));
  });
  gmsh::logger::start();
  gmsh::model::mesh::generate(2);
  std::vector<std::string> log;
  gmsh::logger::get(log);
  gmsh::logger::stop();
  result = read_triangles(outline, scale);
  for (const std::string& line : log)
    if (line.rfind("Error", 0) == 0 && result.reason.empty()) result.reason = "the mesher reports: " + line;
  if (result.triangles.empty() && result.reason.empty()) result.reason = "the mesher made no triangles";
  gmsh::model::mesh::removeSizeCallback();
}

}  // namespace parison::remesh
