// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/wall/surface_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "remesh/wall/wall_sides.hpp"

namespace parison::remesh {
namespace {

/// Room around the middle of a ray over its length, from surface to surface.
constexpr double least_room = 0.8;

/// A position on a chain, as a count from its start that goes round on a closed one; -1 past the ends of an open one.
Index wrapped(const SurfaceChain& chain, Index position) {
  const Index count = chain.position_count();
  if (chain.closed) return (position % count + count) % count;
  return position >= 0 && position < count ? position : -1;
}

bool runs_alongside(const Ray& ray, const Ray& next) {
  return next.ends() && (next.straight_end() - ray.straight_end()).dot(next.start - ray.start) > 0;
}

/// Whether the ray from a position crosses those from the positions beside it.
bool crosses_neighbours(const core::Mesh& mesh, const SurfaceChain& chain, Index position,
                        const std::vector<Ray>& rays) {
  const Ray& ray = rays[chain.node(mesh, position)];
  for (const Index beside : {position - 1, position + 1})
    if (const Index other = wrapped(chain, beside); other >= 0)
      if (runs_alongside(ray, rays[chain.node(mesh, other)])) return false;
  return true;
}

}  // namespace

Index loop_end(const core::Mesh& mesh, Index begin) {
  Index end = begin + 1;
  while (end < static_cast<Index>(mesh.boundary_edges().size()) &&
         mesh.boundary_edges()[end].nodes[0] == mesh.boundary_edges()[end - 1].nodes[1])
    ++end;
  return end;
}

Index SurfaceChain::node(const core::Mesh& mesh, Index position) const {
  if (position == 2 * edge_count()) return mesh.boundary_edges()[edges.back()].nodes[1];
  return mesh.boundary_edges()[edges[position / 2]].nodes[position % 2 == 0 ? 0 : 2];
}

std::vector<SurfaceChain> surface_chains(const core::Mesh& mesh, const std::vector<bool>& symmetry_boundaries) {
  const auto symmetric = [&](Index edge) { return symmetry_boundaries[mesh.boundary_edges()[edge].boundary_id]; };
  std::vector<SurfaceChain> chains;
  for (Index begin = 0; begin < static_cast<Index>(mesh.boundary_edges().size());) {
    const Index end = loop_end(mesh, begin), count = end - begin;
    Index first = begin;
    while (first < end && !symmetric(first)) ++first;
    const bool closed = first == end;
    bool chained = false;
    for (Index k = 0; k < count; ++k) {
      const Index edge = begin + (first - begin + k) % count;
      if (!symmetric(edge)) {
        if (!chained) chains.push_back({{}, closed});
        chains.back().edges.push_back(edge);
      }
      chained = !symmetric(edge);
    }
    begin = end;
  }
  return chains;
}

std::vector<SurfacePair> surface_pairs(const core::Mesh& mesh, const std::vector<SurfaceChain>& chains,
                                       const std::vector<Ray>& rays) {
  std::vector<bool> surface(mesh.boundary_edges().size(), false);
  std::vector<std::array<Index, 2>> chain_and_number(mesh.boundary_edges().size(), {-1, -1});
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (std::size_t k = 0; k < chains[c].edges.size(); ++k) {
      surface[chains[c].edges[k]] = true;
      chain_and_number[chains[c].edges[k]] = {static_cast<Index>(c), static_cast<Index>(k)};
    }
  std::vector<SurfacePair> pairs;
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (Index position = 0; position < chains[c].position_count(); ++position) {
      const Ray& ray = rays[chains[c].node(mesh, position)];
      if (!ray.ends() || ray.facing < facing_sides || crosses_neighbours(mesh, chains[c], position, rays)) continue;
      if (2 * distance_to_edges(mesh, surface, ray.middle) < least_room * ray.length) continue;
      const auto [far_chain, number] = chain_and_number[ray.edge];
      const Index far_position =
          wrapped(chains[far_chain], 2 * number + static_cast<Index>(std::lround(2 * ray.position)));
      const auto& nodes =
          mesh.boundary_edges()[chains[c].edges[std::min(position / 2, chains[c].edge_count() - 1)]].nodes;
      pairs.push_back({static_cast<Index>(c), position, far_chain, far_position,
                       0.5 * (mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]]).norm(),
                       (ray.end - ray.start).norm() < 0.5 * ray.length});
    }
  return pairs;
}

namespace {

/// For each position of a chain the positions paired with it, and the lengths of the pairs.
std::vector<std::vector<std::pair<Index, double>>> partners_of(const SurfaceChain& chain,
                                                               const std::vector<SurfacePair>& pairs) {
  std::vector<std::vector<std::pair<Index, double>>> partners(chain.position_count());
  for (const SurfacePair& pair : pairs)
    if (pair.position != pair.far_position) {
      partners[pair.position].emplace_back(pair.far_position, pair.length);
      partners[pair.far_position].emplace_back(pair.position, pair.length);
    }
  return partners;
}

}  // namespace

ChainCut best_cut(const SurfaceChain& chain, const std::vector<SurfacePair>& pairs, bool& found) {
  const auto partners = partners_of(chain, pairs);
  const Index count = chain.position_count();
  const auto at = [&](Index start, Index k) { return (start + k) % count; };
  double best = 0;
  Index start = 0, parted = 0;  // between the positions `parted` - 1 and `parted` from `start`
  for (Index from = 0; from < (chain.closed ? count : 1); from += 2) {
    double length = 0;
    for (Index k = 0; k < count; ++k) {
      for (const auto& [other, own] : partners[at(from, k)]) length += (other - from + count) % count < k ? -own : own;
      if (length > best * (1 + 1e-9)) best = length, start = from, parted = k + 1;
    }
  }
  found = best > 0;
  ChainCut cut{start, {count, count}, {-1, -1}};
  for (Index k = 0; k < count; ++k)
    for (const auto& [other, own] : partners[at(start, k)]) {
      const int side = k < parted ? 0 : 1, far_side = (other - start + count) % count < parted ? 0 : 1;
      if (side == far_side) continue;
      cut.first[side] = std::min(cut.first[side], k);
      cut.last[side] = std::max(cut.last[side], k);
    }
  return cut;
}

}  // namespace parison::remesh
