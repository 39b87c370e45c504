// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/sparse_matrix.hpp"

#include <amd.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <utility>

namespace parison::core {

void Cliques::add(const Index* begin, Index count) {
  unknowns.insert(unknowns.end(), begin, begin + count);
  start.push_back(static_cast<Index>(unknowns.size()));
}

namespace {

/// Which cliques contain each unknown, and at which of their positions.
struct Uses {
  std::vector<Index> start, clique, place;
};

Uses uses_of(Index size, const Cliques& cliques) {
  Uses uses{std::vector<Index>(size + 1, 0), std::vector<Index>(cliques.unknowns.size()), {}};
  uses.place.resize(cliques.unknowns.size());
  for (const Index unknown : cliques.unknowns) ++uses.start[unknown + 1];
  for (Index i = 0; i < size; ++i) uses.start[i + 1] += uses.start[i];
  std::vector<Index> next(uses.start.begin(), uses.start.end() - 1);
  for (Index c = 0; c < cliques.count(); ++c)
    for (Index k = cliques.start[c]; k < cliques.start[c + 1]; ++k) {
      const Index use = next[cliques.unknowns[k]]++;
      uses.clique[use] = c;
      uses.place[use] = k - cliques.start[c];
    }
  return uses;
}

/// Place of an entry in a packed lower triangle.
Index packed(Index i, Index j) {
  const auto [column, row] = std::minmax(i, j);
  return row * (row + 1) / 2 + column;
}

Scatter empty_scatter(const Cliques& cliques) {
  Scatter scatter{{0}, {}};
  for (Index c = 0; c < cliques.count(); ++c) {
    const Index count = cliques.start[c + 1] - cliques.start[c];
    scatter.offset.push_back(scatter.offset.back() + count * (count + 1) / 2);
  }
  scatter.position.resize(scatter.offset.back());
  return scatter;
}

}  // namespace

namespace {

/// The unknowns that each one meets in cliques, itself included, on one side of the diagonal; in no order.
struct Neighbours {
  std::vector<Index> start{0}, other;
};

/// `after`: those of higher number, otherwise those of lower.
Neighbours neighbours_of(Index size, const Cliques& cliques, const Uses& uses, bool after) {
  Neighbours found;
  std::vector<Index> seen(size, -1);
  for (Index i = 0; i < size; ++i) {
    for (Index use = uses.start[i]; use < uses.start[i + 1]; ++use)
      for (Index k = cliques.start[uses.clique[use]]; k < cliques.start[uses.clique[use] + 1]; ++k) {
        const Index other = cliques.unknowns[k];
        if ((other > i) == after && other != i && std::exchange(seen[other], i) != i) found.other.push_back(other);
      }
    found.other.push_back(i);
    found.start.push_back(static_cast<Index>(found.other.size()));
  }
  return found;
}

}  // namespace

Assembly make_assembly(Index size, const Cliques& cliques, Triangle triangle) {
  const bool upper = triangle == Triangle::upper;
  const Uses uses = uses_of(size, cliques);
  Assembly result{{}, empty_scatter(cliques)};
  SymmetricMatrix& matrix = result.matrix;
  const Neighbours columns_of = neighbours_of(size, cliques, uses, upper);  // of each row
  matrix.size = size;
  matrix.column_start.assign(size + 1, 0);
  for (const Index column : columns_of.other) ++matrix.column_start[column + 1];
  std::partial_sum(matrix.column_start.begin(), matrix.column_start.end(), matrix.column_start.begin());
  matrix.row.resize(columns_of.other.size());
  matrix.value.assign(columns_of.other.size(), 0.0);
  std::vector<Index> next(matrix.column_start.begin(), matrix.column_start.end() - 1), position(size);
  for (Index row = 0; row < size; ++row) {  // in order: so do the rows come into the columns
    for (Index k = columns_of.start[row]; k < columns_of.start[row + 1]; ++k) {
      const Index column = columns_of.other[k];
      position[column] = next[column]++;
      matrix.row[position[column]] = row;
    }
    for (Index use = uses.start[row]; use < uses.start[row + 1]; ++use) {
      const Index clique = uses.clique[use], first = cliques.start[clique];
      for (Index k = first; k < cliques.start[clique + 1]; ++k)
        if (const Index column = cliques.unknowns[k]; column == row || (column > row) == upper)
          result.scatter.position[result.scatter.offset[clique] + packed(uses.place[use], k - first)] =
              position[column];
    }
  }
  return result;
}

void add_clique(SymmetricMatrix& matrix, const Scatter& scatter, Index clique, Index count, const double* local) {
  const Index* position = scatter.position.data() + scatter.offset[clique];
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j <= i; ++j) matrix.value[*position++] += local[i * count + j];
}

Eigen::VectorXd multiply(const SymmetricMatrix& matrix, const Eigen::VectorXd& x) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(matrix.size);
  for (Index column = 0; column < matrix.size; ++column) {
    for (Index k = matrix.column_start[column]; k < matrix.column_start[column + 1]; ++k) {
      const Index row = matrix.row[k];
      result[row] += matrix.value[k] * x[column];
      if (row != column) result[column] += matrix.value[k] * x[row];
    }
  }
  return result;
}

namespace {

/// A graph in compressed rows; an edge may be in the row of either end, or in both.
struct Graph {
  std::vector<Index> start, neighbour;
};

std::vector<Index> order_graph(const Graph& graph, double* info) {
  const auto size = static_cast<Index>(graph.start.size()) - 1;
  std::vector<Index> order(size);
  [[maybe_unused]] const int status =
      amd_order(size, graph.start.data(), graph.neighbour.data(), order.data(), nullptr, info);  // orders A + A'
  assert(status >= AMD_OK);
  return order;
}

double operations(const double* info) {
  return 2 * info[AMD_NMULTSUBS_LDL];
}

/// A number that represents an unknown in the fingerprint of a pattern (the finaliser of splitmix64).
std::uint64_t mark(std::uint64_t unknown) {
  std::uint64_t z = (unknown + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Unknowns in groups of equal pattern, these by their first unknown.
struct Groups {
  std::vector<Index> of_unknown, start, member;
  Index count() const { return static_cast<Index>(start.size()) - 1; }
};

Groups equal_patterns(const SymmetricMatrix& matrix) {
  std::vector<std::uint64_t> pattern(matrix.size, 0);
  for (Index c = 0; c < matrix.size; ++c)
    for (Index k = matrix.column_start[c]; k < matrix.column_start[c + 1]; ++k) {
      pattern[c] += mark(matrix.row[k]);
      if (matrix.row[k] != c) pattern[matrix.row[k]] += mark(c);
    }
  std::vector<Index> sorted(matrix.size);
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(),
            [&](Index a, Index b) { return std::pair(pattern[a], a) < std::pair(pattern[b], b); });
  std::vector<Index> first(matrix.size);  // of the unknown's group
  for (Index k = 0; k < matrix.size; ++k)
    first[sorted[k]] = k > 0 && pattern[sorted[k]] == pattern[sorted[k - 1]] ? first[sorted[k - 1]] : sorted[k];
  Groups groups{std::vector<Index>(matrix.size), {0}, std::vector<Index>(matrix.size)};
  for (Index i = 0; i < matrix.size; ++i) {
    if (first[i] == i) {
      groups.of_unknown[i] = groups.count();
      groups.start.push_back(0);
    } else {
      groups.of_unknown[i] = groups.of_unknown[first[i]];
    }
    ++groups.start[groups.of_unknown[i] + 1];
  }
  std::partial_sum(groups.start.begin(), groups.start.end(), groups.start.begin());
  std::vector<Index> next(groups.start.begin(), groups.start.end() - 1);
  for (Index i = 0; i < matrix.size; ++i) groups.member[next[groups.of_unknown[i]]++] = i;
  return groups;
}

/// The graph of the groups, from the columns of the first member of each and, where those above it are others, of the
/// rest.
Graph quotient(const SymmetricMatrix& matrix, const Groups& groups) {
  Graph graph{{0}, {}};
  std::vector<Index> seen(groups.count(), -1);
  for (Index g = 0; g < groups.count(); ++g) {
    seen[g] = g;
    for (Index m = groups.start[g]; m < groups.start[g + 1]; ++m) {
      const Index c = groups.member[m];
      for (Index k = matrix.column_start[c]; k < matrix.column_start[c + 1]; ++k) {
        const Index other = groups.of_unknown[matrix.row[k]];
        if (seen[other] != g) graph.neighbour.push_back(other);
        seen[other] = g;
      }
    }
    graph.start.push_back(static_cast<Index>(graph.neighbour.size()));
  }
  return graph;
}

}  // namespace

EliminationOrder minimum_degree_order(Index size, const std::vector<std::array<Index, 2>>& edges) {
  Graph named{std::vector<Index>(size + 1, 0), std::vector<Index>(edges.size())};
  for (const auto& edge : edges) ++named.start[std::min(edge[0], edge[1]) + 1];
  std::partial_sum(named.start.begin(), named.start.end(), named.start.begin());
  std::vector<Index> next(named.start.begin(), named.start.end() - 1);
  for (const auto& edge : edges) named.neighbour[next[std::min(edge[0], edge[1])]++] = std::max(edge[0], edge[1]);
  Graph graph{{0}, {}};  // each edge once: of edges named twice AMD makes an order with up to 60 % more operations
  for (Index i = 0; i < size; ++i) {
    const auto first = named.neighbour.begin() + named.start[i], last = named.neighbour.begin() + named.start[i + 1];
    std::sort(first, last);
    graph.neighbour.insert(graph.neighbour.end(), first, std::unique(first, last));
    graph.start.push_back(static_cast<Index>(graph.neighbour.size()));
  }
  double info[AMD_INFO];
  std::vector<Index> order = order_graph(graph, info);
  return {std::move(order), operations(info)};
}

EliminationOrder minimum_degree_order(const SymmetricMatrix& matrix) {
  const Groups groups = equal_patterns(matrix);
  double info[AMD_INFO];
  const std::vector<Index> order = order_graph(quotient(matrix, groups), info);
  EliminationOrder result;
  result.unknown.reserve(matrix.size);
  for (const Index g : order)
    result.unknown.insert(result.unknown.end(), groups.member.begin() + groups.start[g],
                          groups.member.begin() + groups.start[g + 1]);
  const double members = double(matrix.size) / groups.count();
  result.operations = operations(info) * members * members * members;
  return result;
}

}  // namespace parison::core
