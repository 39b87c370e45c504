// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/couplings.hpp"

#include <algorithm>
#include <utility>

namespace parison::thermal {

namespace {

constexpr int max_shift = 1;  ///< edges along a boundary by which a coupling is widened
constexpr int max_slide = 1;  ///< edges by which one body is expected to slide along the other

void sort_unique(std::vector<Coupling>& couplings) {
  std::sort(couplings.begin(), couplings.end());
  couplings.erase(std::unique(couplings.begin(), couplings.end()), couplings.end());
}

}  // namespace

std::vector<Coupling> present_couplings(const HeatSystem& system) {
  std::vector<Coupling> couplings;
  couplings.reserve(system.interface.segments.size());
  for (const HeatSegment& segment : system.interface.segments) couplings.push_back(coupling_of(segment));
  sort_unique(couplings);
  return couplings;
}

EdgeChain::EdgeChain(const HeatSystem& system) : starting_at_(system.size(), -1) {
  Index first_boundary = 0;
  for (std::size_t b = 0; b < system.problem->bodies.size(); ++b) {
    const core::Mesh& mesh = *system.problem->bodies[b].mesh;
    for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
      edges_.push_back(edge_unknowns(system, static_cast<Index>(b), edge.nodes));
      boundary_id_.push_back(first_boundary + edge.boundary_id);
      starting_at_[edges_.back()[0]] = static_cast<Index>(edges_.size()) - 1;
    }
    first_boundary += static_cast<Index>(mesh.boundaries().size());
  }
}

Index EdgeChain::edge_between(Index first, Index last) const {
  const auto count = static_cast<Index>(starting_at_.size());
  if (std::min(first, last) < 0 || std::max(first, last) >= count) return -1;
  for (const auto& [from, to] : {std::pair(first, last), std::pair(last, first)})
    if (const Index edge = starting_at_[from]; edge >= 0 && edges_[edge][1] == to) return edge;
  return -1;
}

bool EdgeChain::holds(const std::vector<Coupling>& couplings) const {
  return std::all_of(couplings.begin(), couplings.end(), [&](const Coupling& coupling) {
    return edge_between(coupling[0], coupling[1]) >= 0 && edge_between(coupling[2], coupling[3]) >= 0;
  });
}

std::array<Index, 6> EdgeChain::unknowns(const Coupling& coupling) const {
  const auto& slave = edges_[edge_between(coupling[0], coupling[1])];
  const auto& master = edges_[edge_between(coupling[2], coupling[3])];
  const auto mid = [](const std::array<Index, 3>& edge, Index first) { return edge[2] == edge[0] ? first : edge[2]; };
  return {coupling[0], coupling[1], mid(slave, coupling[0]), coupling[2], coupling[3], mid(master, coupling[2])};
}

/// The edge some steps further along the same boundary; -1 where there is none.
Index EdgeChain::neighbour(Index edge, int steps) const {
  for (int step = 0; step != steps; step += steps > 0 ? 1 : -1) {
    const Index next = steps > 0 ? edge + 1 : edge - 1;
    if (next < 0 || next >= static_cast<Index>(edges_.size()) || boundary_id_[next] != boundary_id_[edge]) return -1;
    if (steps > 0 ? edges_[next][0] != edges_[edge][1] : edges_[next][1] != edges_[edge][0]) return -1;
    edge = next;
  }
  return edge;
}

std::vector<Coupling> EdgeChain::widen(const std::vector<Coupling>& couplings) const {
  std::vector<Coupling> wide = couplings;
  for (const Coupling& coupling : couplings) {
    const Index slave = edge_between(coupling[0], coupling[1]), master = edge_between(coupling[2], coupling[3]);
    for (int i = -max_shift; i <= max_shift; ++i)
      for (int j = std::max(-max_shift, -max_slide - i); j <= std::min(max_shift, max_slide - i); ++j) {
        const Index s = neighbour(slave, i), m = neighbour(master, j);
        if (s >= 0 && m >= 0) wide.push_back({edges_[s][0], edges_[s][1], edges_[m][0], edges_[m][1]});
      }
  }
  sort_unique(wide);
  return wide;
}

}  // namespace parison::thermal
