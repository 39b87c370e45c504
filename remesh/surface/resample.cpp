// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/resample.hpp"

#include <algorithm>
#include <cmath>

#include "remesh/surface/curve.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

class Resampler {
 public:
  Resampler(const Mesh& old, const Criteria& criteria, const SizeField& size, CornerFilling filling)
      : old_(old),
        criteria_(criteria),
        size_(size),
        links_(boundary_links(old)),
        corners_(find_corners(old, criteria, size, filling)),
        left_out_(links_.size(), false),
        walked_(links_.size(), {0, 1}) {
    for (std::size_t i = 0; i < links_.size(); ++i)
      if (!cut_barb(static_cast<Index>(i))) leave_out_beside(static_cast<Index>(i));
  }

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
    const auto kept = corners_.kept.find(i);
    return (is_fixed(old_, links_, i) && !left_out_[i]) || (kept != corners_.kept.end() && kept->second.s == 0);
  }

  /// Whether the surface has a corner at the first vertex of an edge for no other reason than its own shape.
  bool is_kink(Index i) const {
    const Index before = old_.boundary_edges()[links_[i].previous].boundary_id;
    return starts_curve(i) && old_.boundary_edges()[i].boundary_id == before && !corners_.kept.count(i);
  }

  Point corner_at(Index i) const { return old_.nodes[old_.boundary_edges()[i].nodes[0]]; }

  /// Leaves out the blunter of two corners that are next to nothing apart, as where a fold has closed: an edge between
  /// them would be a splinter in this mesh and all that follow.
  void leave_out_beside(Index i) {
    constexpr double next_to_nothing = 0.02;  // of the largest edge
    const Index next = links_[i].next;
    if (next == i || !starts_curve(i) || !starts_curve(next)) return;
    if ((corner_at(next) - corner_at(i)).norm() > next_to_nothing * criteria_.surface_size) return;
    const bool first = is_kink(i), second = is_kink(next);
    if (first && (!second || std::abs(links_[i].kink) < std::abs(links_[next].kink)))
      left_out_[i] = true;
    else if (second)
      left_out_[next] = true;
  }

  /// Cuts off a barb, a tip of glass that lies on a tool with a crevice behind it: the edge between the two and the
  /// other side of the tip are not walked. True where there is one.
  bool cut_barb(Index i) {
    constexpr double longest = 0.2;  // of the largest edge
    constexpr double sharp = 150 * M_PI / 180;
    const Index before = links_[i].previous, next = links_[i].next;
    const double kink = links_[i].kink, next_kink = links_[next].kink;
    if (next == before || !is_kink(i) || !is_kink(next) || kink * next_kink > 0 ||
        std::min(std::abs(kink), std::abs(next_kink)) < sharp ||
        (corner_at(next) - corner_at(i)).norm() > longest * criteria_.surface_size)
      return false;
    for (const Index edge : {before, i, next})
      if (corners_.kept.count(edge) || corners_.filled.count(edge)) return false;
    const auto nearest = [&](Index edge, Index corner) {
      return closest_on(old_, old_.boundary_edges()[edge].nodes, corner_at(corner));
    };
    walked_[i] = {1, 1};
    if (kink > 0)  // the tip comes before the crevice
      walked_[before].to = nearest(before, next);
    else
      walked_[next].from = nearest(next, i);
    left_out_[i] = left_out_[next] = true;
    return true;
  }

  /// The point at a place of the surface that is resampled, m.
  Point point_at(const Place& place) const {
    const auto filled = corners_.filled.find(place.edge);
    if (filled == corners_.filled.end()) return exterior_point(old_, criteria_.project_out, place);
    const auto& nodes = old_.boundary_edges()[place.edge].nodes;
    const auto& [s, corner] = filled->second;
    const bool before = place.s < s;
    const Point& end = old_.nodes[nodes[before ? 0 : 1]];
    const double share = before ? place.s / s : s < 1 ? (1 - place.s) / (1 - s) : 0;
    const Point x = end + share * (corner - end);
    return criteria_.project_out ? criteria_.project_out(x) : x;
  }

  /// Appends the part of an edge between two values of s.
  void extend_to(const Place& from, double to, BoundaryCurve& curve) const {
    if (!corners_.filled.count(from.edge)) return extend(old_, criteria_.project_out, from, to, curve);
    const double length = (point_at({from.edge, to}) - point_at(from)).norm();
    curve.parts.push_back({from, 0, curve.length() + length, to - from.s});
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
      const auto kept = corners_.kept.find(i);
      const auto [from, to] = walked_[i];
      if (kept != corners_.kept.end() && kept->second.s > 0) {
        extend_to({i, 0}, kept->second.s, curves.back());
        curves.push_back({{}, curves.back().straight});
        extend_to({i, kept->second.s}, 1, curves.back());
      } else if (from < to) {
        extend_to({i, from}, to, curves.back());
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
    const auto kept = corners_.kept.find(place.edge);
    if (kept != corners_.kept.end() && kept->second.s == place.s) return kept->second.vertex;
    return point_at(place);
  }

  void add(const BoundaryCurve& curve, const BoundaryCurve& next, Index at_least) {
    const Point start = start_of(curve), end = start_of(next);
    const auto point = [&](double s) -> Point {
      return curve.straight ? Point(start + s / curve.length() * (end - start)) : point_at(place_at(old_, curve, s));
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
  Corners corners_;
  std::vector<bool> left_out_;
  struct Range {
    double from, to;
  };
  std::vector<Range> walked_;  ///< of each old edge, from 0 to 1 where it is walked whole
  Surface surface_;
  std::vector<bool> mid_contact_, mid_fixed_;
};

}  // namespace

Surface resample(const Mesh& old, const Criteria& criteria, const SizeField& size, CornerFilling filling) {
  return Resampler(old, criteria, size, filling).run();
}

}  // namespace parison::remesh
