// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetric_matrix.hpp"

#include <algorithm>

namespace parison::core {

void Cliques::add(const Index* begin, Index count) {
  unknowns.insert(unknowns.end(), begin, begin + count);
  start.push_back(static_cast<Index>(unknowns.size()));
}

Assembly make_assembly(Index size, const Cliques& cliques) {
  // Column by column: the cliques that hold an unknown give its rows.
  std::vector<Index> use_count(size + 1, 0);
  for (const Index unknown : cliques.unknowns) ++use_count[unknown + 1];
  for (Index i = 0; i < size; ++i) use_count[i + 1] += use_count[i];
  std::vector<Index> users(cliques.unknowns.size()), next(use_count.begin(), use_count.end() - 1);
  for (Index c = 0; c < cliques.count(); ++c)
    for (Index k = cliques.start[c]; k < cliques.start[c + 1]; ++k) users[next[cliques.unknowns[k]]++] = c;

  Assembly result;
  SymmetricMatrix& matrix = result.matrix;
  matrix.size = size;
  matrix.column_start.assign(size + 1, 0);
  std::vector<Index> seen(size, -1), rows;
  for (Index column = 0; column < size; ++column) {
    rows.assign(1, column);
    seen[column] = column;
    for (Index u = use_count[column]; u < use_count[column + 1]; ++u)
      for (Index k = cliques.start[users[u]]; k < cliques.start[users[u] + 1]; ++k) {
        const Index row = cliques.unknowns[k];
        if (row > column && seen[row] != column) {
          seen[row] = column;
          rows.push_back(row);
        }
      }
    std::sort(rows.begin(), rows.end());
    matrix.row.insert(matrix.row.end(), rows.begin(), rows.end());
    matrix.column_start[column + 1] = static_cast<Index>(matrix.row.size());
  }
  matrix.value.assign(matrix.row.size(), 0.0);

  Scatter& scatter = result.scatter;
  scatter.offset.push_back(0);
  for (Index c = 0; c < cliques.count(); ++c) {
    const Index* u = cliques.unknowns.data() + cliques.start[c];
    const Index count = cliques.start[c + 1] - cliques.start[c];
    for (Index i = 0; i < count; ++i)
      for (Index j = 0; j <= i; ++j) {
        const auto [column, row] = std::minmax(u[i], u[j]);
        const auto begin = matrix.row.begin() + matrix.column_start[column];
        const auto end = matrix.row.begin() + matrix.column_start[column + 1];
        scatter.position.push_back(static_cast<Index>(std::lower_bound(begin, end, row) - matrix.row.begin()));
      }
    scatter.offset.push_back(static_cast<Index>(scatter.position.size()));
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
