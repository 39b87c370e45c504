// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "remesh/surface/resample.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

/// Whether the old vertices on both sides of a place touch a tool.
bool lies_between_contacts(const Mesh& old, const Criteria& criteria, const std::vector<Link>& links,
                           const Place& place) {
  if (criteria.contact.empty()) return false;
  const auto& edges = old.boundary_edges();
  const Index before = place.s > 0 ? place.edge : links[place.edge].previous;
  return criteria.contact[edges[before].nodes[0]] && criteria.contact[edges[place.edge].nodes[1]];
}

/// The corner of the old surface nearest to a point within a distance, m; none where there is none.
std::optional<Place> nearest_kink(const Mesh& old, const std::vector<Link>& links, const Point& x, double within) {
  std::optional<Place> nearest;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const double distance = (old.nodes[old.boundary_edges()[i].nodes[0]] - x).norm();
    if (std::abs(links[i].kink) > corner_angle && distance < within)
      within = distance, nearest = {static_cast<Index>(i), 0};
  }
  return nearest;
}

/// Whether the surface from one place to another would turn outwards in a corner of the tools.
bool is_reentrant(const Point& from, const Point& corner, const Point& to) {
  constexpr double least_turn = 0.34;  // sine of the angle of a corner
  const Point in = corner - from, out = to - corner;
  return in[0] * out[1] - in[1] * out[0] > least_turn * in.norm() * out.norm();
}

/// Whether an old edge fills a re-entrant corner of the tools as far as it can: its ends touch a tool on both sides of
/// the corner, and it comes as near to the corner as the parabola that is tangent to both walls at its ends.
bool fills_corner(const Mesh& old, const Criteria& criteria, Index edge, const Point& corner) {
  constexpr double as_near = 1.05;
  constexpr int samples = 16;
  const auto& nodes = old.boundary_edges()[edge].nodes;
  if (criteria.contact.empty() || !criteria.contact[nodes[0]] || !criteria.contact[nodes[1]]) return false;
  if (!is_reentrant(old.nodes[nodes[0]], corner, old.nodes[nodes[1]])) return false;
  const Point to = corner - old.nodes[nodes[0]], from = old.nodes[nodes[1]] - corner;
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 1; k < samples; ++k) {
    const double s = double(k) / samples;
    nearest = std::min(nearest, (s * s * from - (1 - s) * (1 - s) * to).norm());
  }
  return (point_on(old, nodes, closest_on(old, nodes, corner)) - corner).norm() <= as_near * nearest;
}

/// The place nearest to a tool corner at which the surface passes it at less than half the edge length there, or where
/// an edge fills it as far as it can. Where the surface penetrates the tool, half the surface size is enough, because
/// the projection out of the tool leads around the corner.
std::optional<Place> place_beside(const Mesh& old, const Criteria& criteria, const Point& corner, double target_size) {
  double best = 0.5 * criteria.surface_size;
  std::optional<Place> found;
  for (std::size_t i = 0; i < old.boundary_edges().size(); ++i) {
    const auto& edge = old.boundary_edges()[i].nodes;
    const Point &a = old.nodes[edge[0]], &b = old.nodes[edge[1]];
    if (criteria.straight_boundaries[old.boundary_edges()[i].boundary_id] ||
        (corner - 0.5 * (a + b)).norm() > (b - a).norm() + best)
      continue;
    const double s = closest_on(old, edge, corner);
    const double gap = (point_on(old, edge, s) - corner).norm();
    const Place here{static_cast<Index>(i), s};
    if (gap < best && (gap < 0.5 * target_size || penetrates(old, criteria.project_out, here) ||
                       fills_corner(old, criteria, here.edge, corner)))
      best = gap, found = here;
  }
  return found;
}

/// Whether a corner is missed by so little that it belongs to the surface; not a re-entrant one, into which glass has
/// to flow first.
bool belongs_to_surface(const Mesh& old, const std::vector<Link>& links, const Place& place, const Point& corner,
                        double target_size) {
  if ((exterior_point(old, {}, place) - corner).norm() >= 0.1 * target_size) return false;
  // Seen from vertices that are not so near that any direction turns.
  const double apart = 0.5 * target_size;
  const auto vertex = [&](Index edge, int end) { return old.nodes[old.boundary_edges()[edge].nodes[end]]; };
  Index before = place.s > 0 ? place.edge : links[place.edge].previous, after = place.edge;
  while ((vertex(before, 0) - corner).norm() < apart && links[before].previous != place.edge)
    before = links[before].previous;
  while ((vertex(after, 1) - corner).norm() < apart && links[after].next != place.edge) after = links[after].next;
  return !is_reentrant(vertex(before, 0), corner, vertex(after, 1));
}

/// Adds the edges beside a place if they fill a tool corner: between two contacts where less than half the edge length
/// is missing, and each edge that fills it as far as it can.
bool add_filled(const Mesh& old, const Criteria& criteria, const std::vector<Link>& links, const Place& place,
                const Point& corner, double target_size, std::map<Index, FilledEdge>& filled) {
  const double gap = (exterior_point(old, {}, place) - corner).norm();
  const bool small = gap < 0.5 * target_size && lies_between_contacts(old, criteria, links, place);
  bool found = false;
  const auto add = [&](Index edge, double s) {
    if (!small && !fills_corner(old, criteria, edge, corner)) return;
    filled[edge] = {s, corner};
    found = true;
  };
  add(place.edge, place.s);
  if (place.s == 0) add(links[place.edge].previous, 1);
  return found;
}

}  // namespace

/// Whether an old edge starts at the end of a boundary or at a corner.
bool is_fixed(const Mesh& old, const std::vector<Link>& links, Index i) {
  return old.boundary_edges()[i].boundary_id != old.boundary_edges()[links[i].previous].boundary_id ||
         std::abs(links[i].kink) > corner_angle;
}

Corners find_corners(const Mesh& old, const Criteria& criteria, const SizeField& size, CornerFilling filling) {
  const std::vector<Link> links = boundary_links(old);
  std::vector<Point> fixed;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (is_fixed(old, links, static_cast<Index>(i))) fixed.push_back(old.nodes[old.boundary_edges()[i].nodes[0]]);
  Corners corners;
  for (const Point& corner : criteria.keep) {
    const double target_size = std::min(criteria.surface_size, size(corner));
    const auto beside = place_beside(old, criteria, corner, target_size);
    if (!beside) continue;
    Place found = beside->s == 1 ? Place{links[beside->edge].next, 0} : *beside;
    if (lies_between_contacts(old, criteria, links, found))
      found = nearest_kink(old, links, corner, 0.3 * target_size).value_or(found);
    const Point passed = exterior_point(old, {}, found);
    std::map<Index, FilledEdge> edges;
    const bool filled =
        filling != CornerFilling::none && (add_filled(old, criteria, links, found, corner, target_size, edges) ||
                                           belongs_to_surface(old, links, found, corner, target_size));
    const Point at = filled || penetrates(old, criteria.project_out, found) ? corner : passed;
    const bool crowded = std::any_of(fixed.begin(), fixed.end(), [&](const Point& x) {
      return (x - at).norm() < 0.3 * target_size && !(filled && x == passed);
    });
    if (crowded || corners.kept.count(found.edge)) continue;
    corners.kept[found.edge] = {found.s, at};
    corners.filled.merge(edges);
    fixed.push_back(at);
  }
  return corners;
}

}  // namespace parison::remesh
