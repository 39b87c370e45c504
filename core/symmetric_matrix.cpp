// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetric_matrix.hpp"

#include <algorithm>

namespace parison::core {

void Cliques::add(const Index* begin, Index count) {
  unknowns.insert(unknowns.end(), begin, begin + count);
  start.push_back(static_cast<Index>(unknowns.size()));
}

namespace {

/// Which cliques hold each unknown, and at which of their places.
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

Assembly make_assembly(Index size, const Cliques& cliques, Triangle triangle) {
  const bool upper = triangle == Triangle::upper;
  const Uses uses = uses_of(size, cliques);
  Assembly result{{}, empty_scatter(cliques)};
  SymmetricMatrix& matrix = result.matrix;
  matrix.size = size;
  matrix.column_start.assign(size + 1, 0);
  std::vector<Index> seen(size, -1), position(size), rows;
  for (Index column = 0; column < size; ++column) {  // the cliques that hold the column's unknown give its rows
    rows.assign(1, column);
    seen[column] = column;
    for (Index use = uses.start[column]; use < uses.start[column + 1]; ++use)
      for (Index k = cliques.start[uses.clique[use]]; k < cliques.start[uses.clique[use] + 1]; ++k) {
        const Index row = cliques.unknowns[k];
        if ((row < column) == upper && seen[row] != column) {
          seen[row] = column;
          rows.push_back(row);
        }
      }
    std::sort(rows.begin(), rows.end());
    for (const Index row : rows) {
      position[row] = static_cast<Index>(matrix.row.size());
      matrix.row.push_back(row);
    }
    matrix.column_start[column + 1] = static_cast<Index>(matrix.row.size());
    for (Index use = uses.start[column]; use < uses.start[column + 1]; ++use) {
      const Index clique = uses.clique[use], first = cliques.start[clique];
      for (Index k = first; k < cliques.start[clique + 1]; ++k)
        if (const Index row = cliques.unknowns[k]; row == column || (row < column) == upper)
          result.scatter.position[result.scatter.offset[clique] + packed(uses.place[use], k - first)] = position[row];
    }
  }
  matrix.value.assign(matrix.row.size(), 0.0);
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
