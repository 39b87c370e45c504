// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/elimination.hpp"

#include <algorithm>
#include <numeric>

#include "core/ordering.hpp"

namespace parison::thermal {

namespace {

/// The vertices among the unknowns, numbered on.
struct Vertices {
  std::vector<Index> unknown;
  std::vector<Index> number;  ///< by unknown, -1 for a mid-side node
};

Vertices list_vertices(const HeatSystem& system) {
  Vertices vertices{{}, std::vector<Index>(system.size(), -1)};
  for (std::size_t b = 0; b < system.problem->bodies.size(); ++b)
    for (Index v = 0; v < system.problem->bodies[b].mesh->vertex_count; ++v) {
      vertices.number[system.first_unknown[b] + v] = static_cast<Index>(vertices.unknown.size());
      vertices.unknown.push_back(system.first_unknown[b] + v);
    }
  return vertices;
}

/// Position in the order by vertex.
std::vector<Index> rank_vertices(const HeatSystem& system, const Vertices& vertices,
                                 const std::vector<Coupling>& couplings) {
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(3 * system.cells.size() + 4 * couplings.size());
  const auto add = [&](Index a, Index b) { edges.push_back({vertices.number[a], vertices.number[b]}); };
  for (const auto& cell : system.cells)
    for (int i = 0; i < 3; ++i) add(cell[i], cell[(i + 1) % 3]);
  for (const Coupling& coupling : couplings)
    for (const int slave : {0, 1})
      for (const int master : {2, 3}) add(coupling[slave], coupling[master]);
  const Index count = static_cast<Index>(vertices.unknown.size());
  const std::vector<Index> order = core::minimum_degree_order(count, edges).unknown;
  std::vector<Index> rank(count);
  for (Index k = 0; k < count; ++k) rank[order[k]] = k;
  return rank;
}

}  // namespace

std::vector<Index> elimination_order(const HeatSystem& system, const std::vector<Coupling>& couplings) {
  const Vertices vertices = list_vertices(system);
  const std::vector<Index> rank = rank_vertices(system, vertices, couplings);
  const Index count = static_cast<Index>(rank.size());
  // With each unknown goes the vertex that is eliminated right after it or with it.
  std::vector<Index> with(system.size(), count);
  for (Index v = 0; v < count; ++v) with[vertices.unknown[v]] = rank[v];
  if (system.problem->order == 2)
    for (const auto& cell : system.cells)
      for (int i = 0; i < 3; ++i)
        with[cell[3 + i]] = std::min(with[cell[i]], with[cell[(i + 1) % 3]]);
  std::vector<Index> end(count + 1, 0), order(system.size());
  for (const Index w : with) ++end[w + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Index> next(end.begin(), end.end() - 1);
  for (Index u = 0; u < system.size(); ++u)
    order[vertices.number[u] < 0 ? next[with[u]]++ : end[with[u] + 1] - 1] = u;
  return order;
}

}  // namespace parison::thermal
