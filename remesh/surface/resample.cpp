// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/resample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "remesh/surface/curve.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

/// Whether an old edge starts at the end of a boundary or at a corner.
bool is_fixed(const Mesh& old, const std::vector<Link>& links, Index i) {
  return old.boundary_edges()[i].boundary_id != old.boundary_edges()[links[i].previous].boundary_id ||
         std::abs(links[i].kink) > corner_angle;
}

/// The parameter at which an old edge passes a tool corner, and the position of the vertex placed there, m.
struct Kept {
  double s;
  Point vertex;
};

/// The tool corners at which the surface gets a vertex, by old edge: those that the surface passes at less than half
/// the edge length there. Where the surface penetrates the tool, half the surface size is enough, because the
/// projection out of the tool leads around the corner.
std::map<Index, Kept> kept_places(const Mesh& old, const Criteria& criteria, const SizeField& size) {
  const std::vector<Link> links = boundary_links(old);
  std::vector<Point> fixed;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (is_fixed(old, links, static_cast<Index>(i))) fixed.push_back(old.nodes[old.boundary_edges()[i].nodes[0]]);
  std::map<Index, Kept> kept;
  for (const Point& corner : criteria.keep) {
    const double target_size = std::min(criteria.surface_size, size(corner));
    double best = 0.5 * criteria.surface_size;
    Place found{-1, 0};
    for (std::size_t i = 0; i < old.boundary_edges().size(); ++i) {
      const auto& edge = old.boundary_edges()[i].nodes;
      const Point &a = old.nodes[edge[0]], &b = old.nodes[edge[1]];
      if (criteria.straight_boundaries[old.boundary_edges()[i].boundary_id] ||
          (corner - 0.5 * (a + b)).norm() > (b - a).norm() + best)
        continue;
      const double s = closest_on(old, edge, corner);
      const double gap = (point_on(old, edge, s) - corner).norm();
      const Place here{static_cast<Index>(i), s};
      if (gap < best && (gap < 0.5 * target_size || penetrates(old, criteria.project_out, here)))
        best = gap, found = here;
    }
    if (found.edge < 0) continue;
    const Point at = penetrates(old, criteria.project_out, found) ? corner : exterior_point(old, {}, found);
    const bool crowded =
        std::any_of(fixed.begin(), fixed.end(), [&](const Point& x) { return (x - at).norm() < 0.3 * target_size; });
    if (crowded || kept.count(found.edge)) continue;
    kept[found.edge] = {found.s, at};
    fixed.push_back(at);
  }
  return kept;
}

class Resampler {
 public:
  Resampler(const Mesh& old, const Criteria& criteria, const SizeField& size)
      : old_(old),
        criteria_(criteria),
        size_(size),
        links_(boundary_links(old)),
        kept_(kept_places(old, criteria, size)) {}

  Surface run() {
    const auto count = static_cast<Index>(links_.size());
    for (Index start = 0; start < count;) {
      Index last = start;
      while (links_[last].next != start) ++last;
      loop(start, last);
      surface_.outline.loop_start.push_back(surface_.outline.edge_count());
      start = last + 1;
    }
    surface_.contact.insert(surface_.contact.end(), mid_contact_.begin(), mid_contact_.end());
    surface_.fixed.insert(surface_.fixed.end(), mid_fixed_.begin(), mid_fixed_.end());
    return std::move(surface_);
  }

 private:
  bool starts_curve(Index i) const {
    const auto kept = kept_.find(i);
    return is_fixed(old_, links_, i) || (kept != kept_.end() && kept->second.s == 0);
  }

  void loop(Index first, Index last) {
    Index start = first;
    while (start <= last && !starts_curve(start)) ++start;
    if (start > last) start = first;
    std::vector<BoundaryCurve> curves;
    Index i = start;
    do {
      if (i == start || starts_curve(i))
        curves.push_back({{}, criteria_.straight_boundaries[old_.boundary_edges()[i].boundary_id]});
      const auto kept = kept_.find(i);
      if (kept != kept_.end() && kept->second.s > 0) {
        extend(old_, criteria_.project_out, {i, 0}, kept->second.s, curves.back());
        curves.push_back({{}, curves.back().straight});
        extend(old_, criteria_.project_out, {i, kept->second.s}, 1, curves.back());
      } else {
        extend(old_, criteria_.project_out, {i, 0}, 1, curves.back());
      }
      i = links_[i].next;
    } while (i != start);
    for (std::size_t k = 0; k < curves.size(); ++k)
      add(curves[k], curves[(k + 1) % curves.size()], curves.size() > 2 ? 1 : 3);
  }

  /// Whether the two old nodes next to a place touch a tool.
  bool touches(const Place& place) const {
    if (criteria_.contact.empty()) return false;
    const auto& nodes = old_.boundary_edges()[place.edge].nodes;
    return criteria_.contact[nodes[2]] && criteria_.contact[nodes[place.s < 0.5 ? 0 : 1]];
  }

  /// The symmetry edge that starts or ends at a place, -1 where there is none.
  Index symmetry_edge_at(const Place& place) const {
    if (place.s > 0) return -1;
    for (const Index edge : {place.edge, links_[place.edge].previous})
      if (criteria_.straight_boundaries[old_.boundary_edges()[edge].boundary_id]) return edge;
    return -1;
  }

  /// The first vertex of a curve. On a symmetry line it leaves a tool along the line.
  Point start_of(const BoundaryCurve& curve) const {
    const Place& place = curve.parts.front().from;
    if (const Index line = symmetry_edge_at(place); line >= 0) {
      const auto& nodes = old_.boundary_edges()[line].nodes;
      const Point along = (old_.nodes[nodes[1]] - old_.nodes[nodes[0]]).normalized();
      return project_along(criteria_.project_out, exterior_point(old_, {}, place), along);
    }
    const auto kept = kept_.find(place.edge);
    if (kept != kept_.end() && kept->second.s == place.s) return kept->second.vertex;
    return exterior_point(old_, criteria_.project_out, place);
  }

  void add(const BoundaryCurve& curve, const BoundaryCurve& next, Index at_least) {
    const Point start = start_of(curve), end = start_of(next);
    const auto on_curve = [&](double s) -> Point {
      return exterior_point(old_, criteria_.project_out, place_at(old_, curve, s));
    };
    const auto point = [&](double s) -> Point {
      return curve.straight ? Point(start + s / curve.length() * (end - start)) : on_curve(s);
    };
    const std::vector<double> at = divide(
        curve.length(),
        [&](double s) {
          return curve.straight ? size_(point(s))
                                : std::min(size_.coarsening_factor() * criteria_.surface_size, size_(point(s)));
        },
        curve.straight ? 1 : at_least);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      const double middle = 0.5 * (at[i] + at[i + 1]);
      surface_.outline.vertices.push_back(i == 0 ? start : point(at[i]));
      surface_.outline.mids.push_back(point(middle));
      surface_.outline.boundary_ids.push_back(old_.boundary_edges()[curve.parts.front().from.edge].boundary_id);
      surface_.contact.push_back(touches(i == 0 ? curve.parts.front().from : place_at(old_, curve, at[i])));
      surface_.fixed.push_back(curve.straight || i == 0);
      mid_contact_.push_back(touches(place_at(old_, curve, middle)));
      mid_fixed_.push_back(curve.straight);
    }
  }

  const Mesh& old_;
  const Criteria& criteria_;
  const SizeField& size_;
  std::vector<Link> links_;
  std::map<Index, Kept> kept_;
  Surface surface_;
  std::vector<bool> mid_contact_, mid_fixed_;
};

}  // namespace

Surface resample(const Mesh& old, const Criteria& criteria, const SizeField& size) {
  return Resampler(old, criteria, size).run();
}

}  // namespace parison::remesh
