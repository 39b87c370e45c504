#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "core/linear/sparse_matrix.hpp"

namespace parison::core {

/// LDL' factorisation of a symmetric quasi-definite matrix (a regularised saddle point); the symbolic analysis serves
/// until the pattern changes. CHOLMOD factorises where the fill is small, MUMPS (Amestoy, Duff, L'Excellent & Koster
/// 2001) with pivoting where its dense blocks pay. Throws RunError where memory does not suffice.
class IndefiniteSolver {
 public:
  IndefiniteSolver();
  ~IndefiniteSolver();
  IndefiniteSolver(IndefiniteSolver&&) noexcept;
  IndefiniteSolver& operator=(IndefiniteSolver&&) noexcept;

  enum class Library { automatic, cholmod, mumps };
  /// Symbolic analysis of the upper triangle of a matrix that is in the order of its elimination: order[k] is the
  /// number that its k-th unknown has in `solve`.
  void analyse_ordered(const SymmetricMatrix& matrix, const std::vector<Index>& order,
                       Library library = Library::automatic);
  /// Numeric factorisation; false when a pivot vanishes.
  [[nodiscard]] bool factorise(const SymmetricMatrix& matrix);
  /// Solution for each column of the right-hand side, size x columns.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace parison::core
