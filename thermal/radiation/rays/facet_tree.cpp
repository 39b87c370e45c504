// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled as cells/cell_kernels.cpp is, with square roots that set no errno.
#include "thermal/radiation/rays/facet_tree.hpp"

#include <algorithm>
#include <cmath>

namespace parison::thermal {

namespace {

using core::batch_size;
using Lanes = core::VectorizedArray::Lanes;

constexpr double overlap = 1e-9;  ///< of neighbouring facets, of their length
constexpr double flat = 1e-4;     ///< radial part of the normal below which a facet counts as a plane across the axis
constexpr double far = 1e9, nowhere = 1e30;  ///< m: beyond all distances; where the boxes of empty lanes are
constexpr double steepest = 1e12;            ///< reciprocal of a direction's part along the axis

/// What all tests of a ray share.
struct RayTerms {
  double x, y, z, dx, dy, dz, inverse_dz;
  double square, half, constant, vertex;  ///< of the squared radius along the ray; where that is least, m
};

RayTerms terms_of(const Ray& ray) {
  const Eigen::Vector3d &o = ray.origin, &d = ray.direction;
  const double square = d[0] * d[0] + d[1] * d[1], half = o[0] * d[0] + o[1] * d[1];
  const double steep = std::abs(d[2]) > 1 / steepest ? 1 / d[2] : std::copysign(steepest, d[2]);
  return {o[0],
          o[1],
          o[2],
          d[0],
          d[1],
          d[2],
          steep,
          square,
          half,
          o[0] * o[0] + o[1] * o[1],
          square > 0 ? -half / square : 0};
}

[[gnu::always_inline]] inline Lanes smaller(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}
[[gnu::always_inline]] inline Lanes larger(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}
[[gnu::always_inline]] inline Lanes root(const Lanes& x) {
  Lanes result;
  for (int lane = 0; lane < batch_size; ++lane) result[lane] = __builtin_sqrt(x[lane]);
  return result;
}
[[gnu::always_inline]] inline Lanes all(double x) {
  return Lanes{x, x, x, x};
}

/// Distances at which the ray may enter the boxes of a node, `nowhere` where it does not before `nearest`: by the range
/// of z, which bounds the distance, and that of the radius over the distances that are left.
template <bool planar>
[[gnu::always_inline]] inline void enter_boxes(const FacetTree::Node& node, const RayTerms& ray, double nearest,
                                               std::array<double, batch_size>& entry) {
  const Lanes a = (node.low_z.lanes - ray.z) * ray.inverse_dz, b = (node.high_z.lanes - ray.z) * ray.inverse_dz;
  const Lanes from = larger(smaller(a, b), all(0)), to = smaller(larger(a, b), all(nearest));
  Lanes low, high;
  if constexpr (planar) {
    const Lanes first = ray.x + from * ray.dx, last = ray.x + to * ray.dx;
    low = smaller(first, last);
    high = larger(first, last);
  } else {
    const Lanes least = smaller(larger(all(ray.vertex), from), to);
    const Lanes first = ray.constant + from * (2 * ray.half + from * ray.square);
    const Lanes last = ray.constant + to * (2 * ray.half + to * ray.square);
    low = ray.constant + least * (2 * ray.half + least * ray.square);
    high = larger(first, last);
  }
  const Lanes distance = ((from <= to) & (high >= node.low_r.lanes) & (low <= node.high_r.lanes)) ? from : all(nowhere);
  for (int lane = 0; lane < batch_size; ++lane) entry[lane] = distance[lane];
}

/// Makes `nearest` the hit of the facets of a leaf at these distances that is nearer than it.
template <bool planar>
[[gnu::always_inline]] inline void check(const FacetTree::Leaf& leaf, Index first_facet, const RayTerms& ray,
                                         const Lanes& distance, const Lanes& least, double sense, bool both_sides,
                                         FacetHit& nearest) {
  const Lanes x = ray.x + distance * ray.dx, z = ray.z + distance * ray.dz;
  Lanes r, outward;
  if constexpr (planar) {
    r = x;
    outward = leaf.normal_r.lanes * ray.dx + leaf.normal_z.lanes * ray.dz;
  } else {
    const Lanes y = ray.y + distance * ray.dy;
    r = root(x * x + y * y);
    const Lanes radial = r > 0 ? (x * ray.dx + y * ray.dy) / r : all(ray.dx);
    outward = leaf.normal_r.lanes * radial + leaf.normal_z.lanes * ray.dz;
  }
  const Lanes from_r = r - leaf.r.lanes, from_z = z - leaf.z.lanes;
  const Lanes length2 = leaf.along_r.lanes * leaf.along_r.lanes + leaf.along_z.lanes * leaf.along_z.lanes;
  const Lanes along = from_r * leaf.along_r.lanes + from_z * leaf.along_z.lanes;
  const Lanes off = from_r * leaf.normal_r.lanes + from_z * leaf.normal_z.lanes;  // of the other half of the cone
  const auto behind = sense * outward <= 0;
  auto met = (distance > least) & (distance < nearest.distance) & (along >= -overlap * length2) &
             (along <= (1 + overlap) * length2) & (off <= leaf.off.lanes) & (-off <= leaf.off.lanes);
  if (!both_sides) met &= ~behind;
  for (int lane = 0; lane < batch_size; ++lane)
    if (met[lane] && distance[lane] < nearest.distance)
      nearest = {distance[lane], first_facet + lane, behind[lane] != 0};
}

/// A frustum is n_r r = g with g linear along the ray: a quadratic equation for the distance.
template <bool planar>
[[gnu::always_inline]] inline void meet(const FacetTree& tree, Index number, const RayTerms& ray, Index from_facet,
                                        double sense, FacetHit& nearest) {
  const FacetTree::Leaf& leaf = tree.leaf(number);
  const Lanes nr = leaf.normal_r.lanes, nz = leaf.normal_z.lanes;
  const Lanes g0 = nr * leaf.r.lanes - nz * (ray.z - leaf.z.lanes), g1 = -nz * ray.dz;
  const Index first_facet = batch_size * number;
  Lanes least = all(tree.tiny());
  if (from_facet >= first_facet && from_facet < first_facet + batch_size) least[from_facet - first_facet] *= 1e3;
  if constexpr (planar) {
    check<planar>(leaf, first_facet, ray, (g0 - nr * ray.x) / (nr * ray.dx - g1), least, sense, tree.both_sides(),
                  nearest);
  } else {
    const Lanes a = nr * nr * ray.square - g1 * g1, b = nr * nr * ray.half - g0 * g1,
                c = nr * nr * ray.constant - g0 * g0;
    const Lanes size = root(b * b - a * c), q = b < 0 ? size - b : -b - size;
    Lanes one = q / a, other = c / q;
    const auto is_flat = (nr < flat) & (nr > -flat);
    if (is_flat[0] | is_flat[1] | is_flat[2] | is_flat[3]) {
      Lanes plane = -g0 / g1;
      for (int i = 0; i < 2; ++i) {
        const Lanes x = ray.x + plane * ray.dx, y = ray.y + plane * ray.dy;
        plane = (nr * root(x * x + y * y) - g0) / g1;
      }
      one = is_flat ? plane : one;
      other = is_flat ? all(-1) : other;
    }
    check<planar>(leaf, first_facet, ray, one, least, sense, tree.both_sides(), nearest);
    check<planar>(leaf, first_facet, ray, other, least, sense, tree.both_sides(), nearest);
  }
}

struct Pending {
  Index child;
  double entry;
};

/// Goes down the tree, the nearer boxes first.
template <bool planar>
[[gnu::always_inline]] inline void search(const FacetTree& tree, Index root_node, const RayTerms& ray, Index from_facet,
                                          double sense, FacetHit& nearest) {
  std::array<Pending, 64> stack;
  int depth = 0;
  stack[depth++] = {root_node, 0};
  while (depth > 0) {
    const Pending next = stack[--depth];
    if (next.entry >= nearest.distance) continue;
    if (next.child < 0) {
      meet<planar>(tree, -1 - next.child, ray, from_facet, sense, nearest);
      continue;
    }
    const FacetTree::Node& node = tree.node(next.child);
    std::array<double, batch_size> entry;
    enter_boxes<planar>(node, ray, nearest.distance, entry);
    const int below = depth;
    for (int lane = 0; lane < batch_size; ++lane) {
      if (entry[lane] >= nowhere) continue;
      int at = depth++;
      for (; at > below && stack[at - 1].entry < entry[lane]; --at) stack[at] = stack[at - 1];
      stack[at] = {node.child[lane], entry[lane]};
    }
  }
}

[[gnu::target_clones("avx2", "default")]] void search_round(const FacetTree& tree, Index root_node, const RayTerms& ray,
                                                            Index from_facet, double sense, FacetHit& nearest) {
  search<false>(tree, root_node, ray, from_facet, sense, nearest);
}
[[gnu::target_clones("avx2", "default")]] void search_planar(const FacetTree& tree, Index root_node,
                                                             const RayTerms& ray, Index from_facet, double sense,
                                                             FacetHit& nearest) {
  search<true>(tree, root_node, ray, from_facet, sense, nearest);
}

}  // namespace

FacetTree::FacetTree(const std::vector<Facet>& facets, Geometry geometry, double tiny, bool both_sides)
    : geometry_(geometry), tiny_(tiny), both_sides_(both_sides) {
  std::vector<Box> boxes;
  const auto count = static_cast<Index>(facets.size());
  for (Index first = 0; first < count; first += batch_size) {
    Box box{facets[first].from, facets[first].from};
    Leaf leaf;
    for (int lane = 0; lane < batch_size; ++lane) {
      const Facet& facet = facets[std::min(first + lane, count - 1)];
      for (const Point& x : {facet.from, Point(facet.from + facet.along)}) {
        box.low = box.low.cwiseMin(x);
        box.high = box.high.cwiseMax(x);
      }
      leaf.r[lane] = facet.from[0], leaf.z[lane] = facet.from[1];
      leaf.along_r[lane] = facet.along[0], leaf.along_z[lane] = facet.along[1];
      leaf.normal_r[lane] = facet.normal[0], leaf.normal_z[lane] = facet.normal[1];
      leaf.off[lane] = 1e-6 * facet.along.norm() + tiny;
    }
    box.low.array() -= tiny;
    box.high.array() += tiny;
    boxes.push_back(box);
    leaves_.push_back(leaf);
  }
  if (!boxes.empty()) add_node(boxes, 0, static_cast<Index>(boxes.size()));
}

/// Adds the node of a range of leaves and returns its number.
Index FacetTree::add_node(const std::vector<Box>& boxes, Index first, Index last) {
  Node node;
  const auto squared = [&](double r) { return geometry_ == Geometry::planar ? r : r * std::abs(r); };
  for (int lane = 0; lane < batch_size; ++lane) {
    const Index begin = first + (last - first) * lane / batch_size,
                end = first + (last - first) * (lane + 1) / batch_size;
    node.low_z[lane] = node.high_z[lane] = node.low_r[lane] = node.high_r[lane] = nowhere;
    node.child[lane] = 0;
    if (begin == end) continue;
    Box box = boxes[begin];
    for (Index i = begin; i < end; ++i) box = {box.low.cwiseMin(boxes[i].low), box.high.cwiseMax(boxes[i].high)};
    node.low_z[lane] = box.low[1], node.high_z[lane] = box.high[1];
    node.low_r[lane] = squared(box.low[0]), node.high_r[lane] = squared(box.high[0]);
    node.child[lane] = end - begin == 1 ? -1 - begin : add_node(boxes, begin, end);
  }
  nodes_.push_back(node);
  return static_cast<Index>(nodes_.size()) - 1;
}

FacetHit FacetTree::first_hit(const Ray& ray, Index from_facet, double sense) const {
  FacetHit nearest{far, -1, false};
  if (nodes_.empty()) return nearest;
  const auto start = static_cast<Index>(nodes_.size()) - 1;
  (geometry_ == Geometry::planar ? search_planar : search_round)(*this, start, terms_of(ray), from_facet, sense,
                                                                 nearest);
  return nearest;
}

}  // namespace parison::thermal
