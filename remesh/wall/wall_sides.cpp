// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/wall/wall_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/mesh/element.hpp"
#include "remesh/wall/surface_chain.hpp"

namespace parison::remesh {
namespace {

/// A side ends at a corner that turns by more than 30 degrees, and where it has turned by more than 75 degrees since
/// the last pair, both as cosines.
constexpr double corner = 0.866, bend = 0.259;

Point tangent(const core::Mesh& mesh, Index edge, double s) {
  return core::map_edge_point(mesh, mesh.boundary_edges()[edge].nodes, core::Geometry::planar, {s, 1}).tangent;
}

bool is_fixed(const core::Mesh& mesh, Index edge) {
  return mesh.boundaries()[mesh.boundary_edges()[edge].boundary_id].kind == core::BoundaryKind::fixed;
}

/// The number, on a chain, of the edge to which a side goes on from edge `number`, forwards or backwards (`step` 1 or
/// -1), at most to `limit`: to a corner, a bend, or the start of a fixed boundary.
Index extended(const core::Mesh& mesh, const SurfaceChain& chain, Index number, int step, Index limit) {
  const Point along = tangent(mesh, chain.edges[number], 0.5);
  const double near_end = step > 0 ? 0 : 1, far_end = 1 - near_end;
  while (number != limit) {
    const Index edge = chain.edges[number], next = chain.edges[number + step];
    if (tangent(mesh, edge, far_end).dot(tangent(mesh, next, near_end)) < corner) break;
    if (tangent(mesh, next, 0.5).dot(along) < bend) break;
    if (is_fixed(mesh, next) && !is_fixed(mesh, edge)) break;
    number += step;
  }
  return number;
}

using Edges = std::vector<Index>;

/// From the first to the last edge, by their numbers on a chain.
Edges edges_between(const SurfaceChain& chain, Index first, Index last) {
  return {chain.edges.begin() + first, chain.edges.begin() + last + 1};
}

/// The chain with its first position at another one; only for closed chains.
SurfaceChain rotated(SurfaceChain chain, Index start) {
  std::rotate(chain.edges.begin(), chain.edges.begin() + start / 2, chain.edges.end());
  return chain;
}

/// The edges of the two sides on one chain.
std::array<Edges, 2> cut_sides(const core::Mesh& mesh, SurfaceChain chain, ChainCut cut) {
  const Index count = chain.position_count();
  if (chain.closed) {  // from the middle of the rim on
    const Index rim = count - cut.last[1] + cut.first[0], forwards = 2 * ((cut.first[0] + count - rim / 2) / 2) - count;
    chain = rotated(chain, (cut.start + forwards + count) % count);
    for (int side : {0, 1}) cut.first[side] -= forwards, cut.last[side] -= forwards;
  }
  const Index end = chain.edge_count() - 1;
  std::array<Index, 2> first, last;
  for (int side : {0, 1}) {
    first[side] = std::min(cut.first[side] / 2, end);
    last[side] = std::max(first[side], (cut.last[side] - 1) / 2);
  }
  const Index middle = (last[0] + first[1]) / 2;
  last[0] = extended(mesh, chain, last[0], 1, middle);
  first[1] = extended(mesh, chain, first[1], -1, std::min(middle + 1, first[1]));
  first[0] = chain.closed ? extended(mesh, chain, first[0], -1, 0) : 0;
  last[1] = chain.closed ? extended(mesh, chain, last[1], 1, end) : end;
  return {edges_between(chain, first[0], last[0]), edges_between(chain, first[1], last[1])};
}

/// The edges of the one side of a wall that is half of itself.
Edges mirrored_side(const core::Mesh& mesh, const SurfaceChain& chain, const std::vector<SurfacePair>& pairs) {
  const Index end = chain.edge_count() - 1;
  Index first = end, last = 0;
  for (const SurfacePair& pair : pairs) {
    first = std::min(first, std::min(pair.position / 2, end));
    last = std::max(last, std::max(pair.position - 1, 0) / 2);
  }
  return edges_between(chain, extended(mesh, chain, first, -1, 0),
                       extended(mesh, chain, std::max(first, last), 1, end));
}

/// How a side lies.
struct SideMoments {
  double area = 0;                  ///< m2
  Point position = Point::Zero();   ///< integral of the position over the area, m3
  Point direction = Point::Zero();  ///< of the outward normal, m2
  double flux = 0;                  ///< of the position along the normal, m3
};
SideMoments moments(const core::Mesh& mesh, core::Geometry geometry, const Edges& edges) {
  SideMoments sum;
  for (const Index edge : edges)
    for (const core::EdgeRulePoint& at : core::edge_rule(3)) {
      const auto point = core::map_edge_point(mesh, mesh.boundary_edges()[edge].nodes, geometry, at);
      sum.area += point.area;
      sum.position += point.area * point.position;
      sum.direction += point.area * point.normal;
      sum.flux += point.area * point.position.dot(point.normal);
    }
  return sum;
}

/// Which of two sides looks into the cavity: its normals point towards the middle of both; of a flat wall the upper
/// one, of a flat and upright one that nearer to the axis.
int inner_of(const core::Mesh& mesh, core::Geometry geometry, const std::array<Edges, 2>& sides) {
  constexpr double curved = 0.02, flat = 1e-3;  // shares of the size
  const std::array<SideMoments, 2> side{moments(mesh, geometry, sides[0]), moments(mesh, geometry, sides[1])};
  Point middle = (side[0].position + side[1].position) / (side[0].area + side[1].area);
  if (geometry == core::Geometry::axisymmetric) middle[0] = 0;
  double size = 0;
  for (const Edges& edges : sides)
    for (const Index edge : edges)
      size = std::max(size, (mesh.nodes[mesh.boundary_edges()[edge].nodes[0]] - middle).norm());
  const auto outward = [&](const SideMoments& of) { return (of.flux - middle.dot(of.direction)) / of.area; };
  const double out = outward(side[0]) - outward(side[1]);
  if (std::abs(out) > curved * size) return out > 0 ? 1 : 0;
  const Point apart = side[1].position / side[1].area - side[0].position / side[0].area;
  if (std::abs(apart[1]) > flat * size) return apart[1] > 0 ? 1 : 0;
  return apart[0] < 0 ? 1 : 0;
}

/// What most pairs join: two chains, or a chain with itself or with its own mirror image.
struct Joined {
  Index chain, far_chain;
  bool to_itself;
  bool operator<(const Joined& other) const {
    return std::tie(chain, far_chain, to_itself) < std::tie(other.chain, other.far_chain, other.to_itself);
  }
};
Joined joined(const SurfacePair& pair) {
  return {std::min(pair.chain, pair.far_chain), std::max(pair.chain, pair.far_chain), pair.to_itself};
}

/// The pairs that join what most of them do, by length.
std::vector<SurfacePair> main_pairs(const std::vector<SurfacePair>& pairs) {
  std::map<Joined, double> length;
  for (const SurfacePair& pair : pairs) length[joined(pair)] += pair.length;
  const auto most =
      std::max_element(length.begin(), length.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<SurfacePair> kept;
  for (const SurfacePair& pair : pairs)
    if (!(joined(pair) < most->first) && !(most->first < joined(pair))) kept.push_back(pair);
  return kept;
}

/// The nodes at both ends of the pairs.
std::vector<bool> paired_nodes(const core::Mesh& mesh, const std::vector<SurfaceChain>& chains,
                               const std::vector<SurfacePair>& pairs) {
  std::vector<bool> paired(mesh.nodes.size(), false);
  for (const SurfacePair& pair : pairs) {
    paired[chains[pair.chain].node(mesh, pair.position)] = true;
    paired[chains[pair.far_chain].node(mesh, pair.far_position)] = true;
  }
  return paired;
}

}  // namespace

WallSides wall_sides(const core::Mesh& mesh, core::Geometry geometry, const std::vector<Ray>& rays) {
  WallSides found;
  found.part.assign(mesh.boundary_edges().size(), SurfacePart::none);
  const auto chains = surface_chains(mesh, core::boundaries_of_kind(mesh, core::BoundaryKind::symmetry));
  const std::vector<SurfacePair> pairs = main_pairs(surface_pairs(mesh, chains, rays));
  const auto fill = [&](const Edges& edges, SurfacePart part) {
    for (const Index edge : edges) found.part[edge] = part;
  };
  found.paired = paired_nodes(mesh, chains, pairs);
  bool has_sides = !pairs.empty();
  std::array<Edges, 2> sides;
  if (has_sides) {
    const Joined main = joined(pairs.front());
    const SurfaceChain &chain = chains[main.chain], &far_chain = chains[main.far_chain];
    fill(chain.edges, SurfacePart::rim);
    if ((found.is_mirrored = main.to_itself))
      sides[0] = mirrored_side(mesh, chain, pairs);
    else if (main.chain != main.far_chain)
      sides = {chain.edges, far_chain.edges};
    else if (const ChainCut cut = best_cut(chain, pairs, has_sides); has_sides)
      sides = cut_sides(mesh, chain, cut);
  }
  if (!has_sides) {
    found.part.assign(mesh.boundary_edges().size(), SurfacePart::none);
    found.no_wall = "the glass is no wall: nowhere do two sides of it face each other";
    return found;
  }
  const int inner = found.is_mirrored ? 1 : inner_of(mesh, geometry, sides);
  fill(sides[1 - inner], SurfacePart::outer);
  fill(sides[inner], SurfacePart::inner);
  return found;
}

}  // namespace parison::remesh
