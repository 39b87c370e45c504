// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/stretch.hpp"

#include <algorithm>

#include "remesh/curve.hpp"

namespace parison::remesh {

using core::Mesh;
using core::Point;

namespace {

constexpr double deep = 1e-5;  ///< m; less is lifted out of the finished mesh
constexpr int looks = 8;       ///< along an edge for whether it dips
constexpr int dip_parts = 32;  ///< of an edge that does

bool dips_between(const Mesh& mesh, const Clear& clear, const Place& from, double to) {
  for (int k = 0; clear && k <= looks; ++k)
    if (dips(mesh, clear, {from.edge, from.s + (to - from.s) * k / looks})) return true;
  return false;
}

}  // namespace

Point clear_point(const Mesh& mesh, const Clear& clear, const Place& place) {
  const auto& nodes = mesh.boundary[place.edge].nodes;
  const Point x = place.s == 0 ? mesh.nodes[nodes[0]] : point_on(mesh, nodes, place.s);
  if (!clear) return x;
  const Point out = clear(x);
  return (out - x).norm() > deep ? out : x;
}

bool dips(const Mesh& mesh, const Clear& clear, const Place& place) {
  return clear_point(mesh, clear, place) != clear_point(mesh, {}, place);
}

void extend(const Mesh& mesh, const Clear& clear, const Place& from, double to, Stretch& stretch) {
  if (stretch.straight || !dips_between(mesh, clear, from, to)) {
    const auto& nodes = mesh.boundary[from.edge].nodes;
    const double before = from.s > 0 ? arc_length(mesh, nodes, from.s) : 0;
    stretch.parts.push_back({from, before, stretch.length() + arc_length(mesh, nodes, to) - before, 0});
    return;
  }
  const double span = (to - from.s) / dip_parts;
  Place place = from;
  Point start = clear_point(mesh, clear, place);
  for (int k = 1; k <= dip_parts; ++k) {
    const Place next{from.edge, from.s + k * span};
    const Point end = clear_point(mesh, clear, next);
    stretch.parts.push_back({place, 0, stretch.length() + (end - start).norm(), span});
    place = next, start = end;
  }
}

Place place_at(const Mesh& mesh, const Stretch& stretch, double length) {
  const auto until = [](const StretchPart& part, double value) { return part.until < value; };
  const auto found = std::lower_bound(stretch.parts.begin(), stretch.parts.end() - 1, length, until);
  const double start = found == stretch.parts.begin() ? 0 : (found - 1)->until, ahead = length - start;
  const auto [edge, s] = found->from;
  if (found->span > 0) return {edge, s + (ahead > 0 ? ahead / (found->until - start) * found->span : 0)};
  return {edge, at_arc_length(mesh, mesh.boundary[edge].nodes, ahead + found->before)};
}

}  // namespace parison::remesh
