// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/sparse_matrix.hpp"

#include <algorithm>
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

}  // namespace parison::core
