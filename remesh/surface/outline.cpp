// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/outline.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/mesh/element.hpp"
#include "core/mesh/profile.hpp"
#include "remesh/surface/curve.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

/// Two chords an edge: to the mid-side point and on to the end.
std::vector<core::Chord> half_chords(const Outline& outline) {
  const std::vector<Index> ends = edge_ends(outline);
  const Index count = outline.edge_count();
  std::vector<core::Chord> result;
  for (Index i = 0; i < count; ++i) {
    result.push_back({outline.vertices[i], outline.mids[i], i, count + i});
    result.push_back({outline.mids[i], outline.vertices[ends[i]], count + i, ends[i]});
  }
  return result;
}

/// One chord an edge, as it is meshed.
std::vector<core::Chord> whole_chords(const Outline& outline) {
  const std::vector<Index> ends = edge_ends(outline);
  std::vector<core::Chord> result;
  for (Index i = 0; i < outline.edge_count(); ++i)
    result.push_back({outline.vertices[i], outline.vertices[ends[i]], i, ends[i]});
  return result;
}

}  // namespace

std::vector<Index> edge_ends(const Outline& outline) {
  std::vector<Index> ends(outline.vertices.size());
  std::iota(ends.begin(), ends.end(), 1);
  for (std::size_t k = 0; k + 1 < outline.loop_start.size(); ++k)
    ends[outline.loop_start[k + 1] - 1] = outline.loop_start[k];
  return ends;
}

std::pair<Index, Index> find_crossing(const Outline& outline) {
  const auto [first, second] = core::find_crossing(half_chords(outline));
  return first < 0 ? core::find_crossing(whole_chords(outline)) : std::pair<Index, Index>{first / 2, second / 2};
}

bool crosses_itself(const Mesh& mesh) {
  std::vector<core::Chord> chords;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) == core::BoundaryKind::symmetry) continue;
    const auto [first, last, middle] = edge.nodes;
    chords.push_back({mesh.nodes[first], mesh.nodes[middle], first, middle});
    chords.push_back({mesh.nodes[middle], mesh.nodes[last], middle, last});
  }
  return core::find_crossing(chords).first >= 0;
}

double overlap_volume(core::Geometry geometry, const Mesh& mesh) {
  constexpr int lines = 1024, inside_once = 1;
  std::vector<std::pair<Point, Point>> chords;
  double bottom = std::numeric_limits<double>::infinity(), top = -bottom;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    const auto [first, last, middle] = edge.nodes;
    chords.emplace_back(mesh.nodes[first], mesh.nodes[middle]);
    chords.emplace_back(mesh.nodes[middle], mesh.nodes[last]);
    bottom = std::min(bottom, mesh.nodes[first][1]);
    top = std::max(top, mesh.nodes[first][1]);
  }
  const double height = (top - bottom) / lines;
  double volume = 0;
  for (int line = 0; line < lines; ++line) {
    const double z = bottom + (line + 0.5) * height;
    std::vector<std::pair<double, int>> crossings;  // place, 1 where the body begins beyond it, -1 where it ends
    for (const auto& [from, to] : chords)
      if ((from[1] < z) != (to[1] < z))
        crossings.emplace_back(from[0] + (z - from[1]) / (to[1] - from[1]) * (to[0] - from[0]),
                               to[1] < from[1] ? 1 : -1);
    std::sort(crossings.begin(), crossings.end());
    int times = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      times += crossings[i].second;
      const double left = crossings[i].first, right = crossings[i + 1].first;
      if (times > inside_once)
        volume += (times - 1) * (right - left) * height * core::depth(geometry, Point(0.5 * (left + right), z));
    }
  }
  return volume;
}

namespace {

constexpr int samples = 8;             ///< points along an edge at which penetration is tested
constexpr int penetrating_parts = 32;  ///< parts of an edge that penetrates a tool

bool penetrates_between(const Mesh& mesh, const ExteriorProjection& project_out, const Place& from, double to) {
  for (int k = 0; project_out && k <= samples; ++k)
    if (penetrates(mesh, project_out, {from.edge, from.s + (to - from.s) * k / samples})) return true;
  return false;
}

}  // namespace

Point exterior_point(const Mesh& mesh, const ExteriorProjection& project_out, const Place& place) {
  const auto& nodes = mesh.boundary_edges()[place.edge].nodes;
  const Point x = place.s == 0 ? mesh.nodes[nodes[0]] : point_on(mesh, nodes, place.s);
  if (!project_out) return x;
  return project_out(x);
}

Point project_along(const ExteriorProjection& project_out, const Point& x, const Point& along) {
  constexpr int max_projections = 200;  // a pointed tip is left in steps that are shares of the rest
  Point out = x;
  for (int k = 0; project_out && k < max_projections; ++k) {
    const double step = along.dot(project_out(out) - out);
    if (step == 0) break;
    out += step * along;
  }
  return out;
}

bool penetrates(const Mesh& mesh, const ExteriorProjection& project_out, const Place& place) {
  return exterior_point(mesh, project_out, place) != exterior_point(mesh, {}, place);
}

void extend(const Mesh& mesh, const ExteriorProjection& project_out, const Place& from, double to,
            BoundaryCurve& curve) {
  if (curve.straight || !penetrates_between(mesh, project_out, from, to)) {
    const auto& nodes = mesh.boundary_edges()[from.edge].nodes;
    const double before = from.s > 0 ? arc_length(mesh, nodes, from.s) : 0;
    curve.parts.push_back({from, before, curve.length() + arc_length(mesh, nodes, to) - before, 0});
    return;
  }
  const double span = (to - from.s) / penetrating_parts;
  Place place = from;
  Point start = exterior_point(mesh, project_out, place);
  for (int k = 1; k <= penetrating_parts; ++k) {
    const Place next{from.edge, from.s + k * span};
    const Point end = exterior_point(mesh, project_out, next);
    curve.parts.push_back({place, 0, curve.length() + (end - start).norm(), span});
    place = next, start = end;
  }
}

Place place_at(const Mesh& mesh, const BoundaryCurve& curve, double length) {
  const auto until = [](const CurvePart& part, double value) { return part.until < value; };
  const auto found = std::lower_bound(curve.parts.begin(), curve.parts.end() - 1, length, until);
  const double start = found == curve.parts.begin() ? 0 : (found - 1)->until, ahead = length - start;
  const auto [edge, s] = found->from;
  if (found->span > 0) return {edge, s + (ahead > 0 ? ahead / (found->until - start) * found->span : 0)};
  return {edge, at_arc_length(mesh, mesh.boundary_edges()[edge].nodes, ahead + found->before)};
}

}  // namespace parison::remesh
