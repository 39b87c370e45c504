// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/wall/surface_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "forming/report/wall/wall_sides.hpp"

namespace parison::forming {
namespace {

/// Room around the middle of a way over its length, from surface to surface.
constexpr double least_room = 0.8;

/// A place on a chain, as a count from its start that goes round on a closed one; -1 past the ends of an open one.
Index wrapped(const SurfaceChain& chain, Index place) {
  const Index count = chain.place_count();
  if (chain.closed) return (place % count + count) % count;
  return place >= 0 && place < count ? place : -1;
}

bool runs_alongside(const Way& way, const Way& next) {
  return next.ends() && (next.straight_end() - way.straight_end()).dot(next.start - way.start) > 0;
}

/// Whether the way from a place crosses those from the places beside it.
bool crosses_neighbours(const core::Mesh& mesh, const SurfaceChain& chain, Index place, const std::vector<Way>& ways) {
  const Way& way = ways[chain.node(mesh, place)];
  for (const Index beside : {place - 1, place + 1})
    if (const Index other = wrapped(chain, beside); other >= 0)
      if (runs_alongside(way, ways[chain.node(mesh, other)])) return false;
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

Index SurfaceChain::node(const core::Mesh& mesh, Index place) const {
  if (place == 2 * edge_count()) return mesh.boundary_edges()[edges.back()].nodes[1];
  return mesh.boundary_edges()[edges[place / 2]].nodes[place % 2 == 0 ? 0 : 2];
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
                                       const std::vector<Way>& ways) {
  std::vector<bool> surface(mesh.boundary_edges().size(), false);
  std::vector<std::array<Index, 2>> chain_and_number(mesh.boundary_edges().size(), {-1, -1});
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (std::size_t k = 0; k < chains[c].edges.size(); ++k) {
      surface[chains[c].edges[k]] = true;
      chain_and_number[chains[c].edges[k]] = {static_cast<Index>(c), static_cast<Index>(k)};
    }
  std::vector<SurfacePair> pairs;
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (Index place = 0; place < chains[c].place_count(); ++place) {
      const Way& way = ways[chains[c].node(mesh, place)];
      if (!way.ends() || way.facing < facing_sides || crosses_neighbours(mesh, chains[c], place, ways)) continue;
      if (2 * distance_to_edges(mesh, surface, way.middle) < least_room * way.length) continue;
      const auto [far_chain, number] = chain_and_number[way.edge];
      const Index far_place = wrapped(chains[far_chain], 2 * number + static_cast<Index>(std::lround(2 * way.place)));
      const auto& nodes = mesh.boundary_edges()[chains[c].edges[std::min(place / 2, chains[c].edge_count() - 1)]].nodes;
      pairs.push_back({static_cast<Index>(c), place, far_chain, far_place,
                       0.5 * (mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]]).norm(),
                       (way.end - way.start).norm() < 0.5 * way.length});
    }
  return pairs;
}

namespace {

/// For each place of a chain the places paired with it, and the lengths of the pairs.
std::vector<std::vector<std::pair<Index, double>>> partners_of(const SurfaceChain& chain,
                                                               const std::vector<SurfacePair>& pairs) {
  std::vector<std::vector<std::pair<Index, double>>> partners(chain.place_count());
  for (const SurfacePair& pair : pairs)
    if (pair.place != pair.far_place) {
      partners[pair.place].emplace_back(pair.far_place, pair.length);
      partners[pair.far_place].emplace_back(pair.place, pair.length);
    }
  return partners;
}

}  // namespace

ChainCut best_cut(const SurfaceChain& chain, const std::vector<SurfacePair>& pairs, bool& found) {
  const auto partners = partners_of(chain, pairs);
  const Index count = chain.place_count();
  const auto at = [&](Index start, Index k) { return (start + k) % count; };
  double best = 0;
  Index start = 0, parted = 0;  // between the places `parted` - 1 and `parted` from `start`
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

}  // namespace parison::forming
