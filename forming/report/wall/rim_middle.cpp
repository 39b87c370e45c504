// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"
#include "forming/report/wall/wall_marks.hpp"
#include "remesh/wall/surface_chain.hpp"

namespace parison::forming {
namespace {

constexpr double turned = 0.5;  ///< cosine of the 60 degrees by which the middle stretch of a rim is off the wall
constexpr int samples = 4;      ///< along an edge

/// Where the cosine between the walk and the wall has fallen below a level for the last time.
class Passage {
 public:
  explicit Passage(double level) : level_(level) {}
  void visit(double arc, double cosine) {
    if (cosine >= level_)
      at_ = core::none;
    else if (std::isnan(at_))
      at_ = std::isnan(arc_) ? arc : arc_ + (cosine_ - level_) / (cosine_ - cosine) * (arc - arc_);
    arc_ = arc, cosine_ = cosine;
  }
  double at() const { return at_; }

 private:
  double level_, arc_ = core::none, cosine_ = core::none, at_ = core::none;
};

/// First and last edge of the loop that an edge lies on, the latter past the end.
std::pair<Index, Index> loop_of(const core::Mesh& mesh, Index edge) {
  Index begin = 0, end = remesh::loop_end(mesh, begin);
  while (end <= edge) begin = end, end = remesh::loop_end(mesh, begin);
  return {begin, end};
}

/// The arcs between which a walk passes along a fixed boundary that is a rim: it begins near, and is not long.
class FixedRim {
 public:
  explicit FixedRim(double near) : near_(near) {}
  /// One edge of the walk, whose begin is so far from that of the walk.
  void visit(bool fixed, double from, double to, double distance) {
    if (is_on_ = fixed && !is_side_ && (is_known() || distance <= near_); is_on_) {
      if (!is_known()) begin_ = from;
      end_ = to;
      is_side_ = std::abs(end_ - begin_) > near_;
      if (is_side_) begin_ = core::none, is_on_ = false;
    }
  }
  bool is_on() const { return is_on_; }
  bool is_passed() const { return !is_on_ && is_known(); }
  bool is_known() const { return !std::isnan(begin_); }
  double middle() const { return 0.5 * (begin_ + end_); }

 private:
  double near_, begin_ = core::none, end_ = core::none;
  bool is_on_ = false, is_side_ = false;
};

}  // namespace

double rim_middle(const core::Mesh& mesh, const RimApproach& approach) {
  const auto [begin, end] = loop_of(mesh, approach.edge);
  const Index count = end - begin, step = approach.forwards ? 1 : -1;
  constexpr double near = 10;  // of the length over which the surface keeps its direction
  Passage leaves(turned), returns(-turned);
  FixedRim fixed(near * approach.steady);
  double arc = approach.arc;
  Index edge = approach.edge;
  for (Index walked = 0; walked < count; ++walked) {
    const core::BoundaryEdge& now = mesh.boundary_edges()[edge];
    if (mesh.kind_of(now) == core::BoundaryKind::symmetry) break;
    Point before = mesh.nodes[now.nodes[approach.forwards ? 0 : 1]];
    const double edge_arc = arc;
    for (int k = 0; k <= samples; ++k) {
      const double along = double(k) / samples, s = approach.forwards ? along : 1 - along;
      const auto at = core::map_edge_point(mesh, now.nodes, core::Geometry::planar, {s, 1});
      arc += step * (at.position - before).norm();
      before = at.position;
      const double cosine = step * at.tangent.dot(approach.direction);
      leaves.visit(arc, cosine);
      returns.visit(arc, cosine);
    }
    fixed.visit(mesh.kind_of(now) == core::BoundaryKind::fixed, edge_arc, arc, std::abs(edge_arc - approach.arc));
    if (fixed.is_passed() || (!fixed.is_on() && std::abs(arc - returns.at()) > approach.steady)) break;
    edge = begin + (edge - begin + step + count) % count;
  }
  return fixed.is_known() ? fixed.middle() : 0.5 * (leaves.at() + returns.at());
}

}  // namespace parison::forming
