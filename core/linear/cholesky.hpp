#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "core/linear/sparse_matrix.hpp"

namespace parison::core {

/// Factorisation of a symmetric sparse matrix by CHOLMOD (Chen, Davis, Hager & Rajamanickam 2008); the symbolic
/// analysis serves until the pattern changes. Positive definite: LL', supernodal unless the order is given.
/// Quasi-definite (a saddle point whose second block is negative definite, Vanderbei 1995): simplicial LDL' without
/// pivoting.
class Cholesky {
 public:
  enum class Form { positive_definite, quasi_definite };
  Cholesky();
  explicit Cholesky(Form form);
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Symbolic analysis with approximate minimum degree (AMD, Amestoy, Davis & Duff 1996).
  void analyse(const SymmetricMatrix& matrix);
  /// The same for the upper triangle of a matrix that is in the order of its elimination itself: order[k] is the number
  /// that its k-th unknown has in `solve`. The factor is simplicial; of a lower triangle it is supernodal.
  void analyse_ordered(const SymmetricMatrix& matrix, const std::vector<Index>& order,
                       Triangle triangle = Triangle::upper);
  /// Floating-point operations of a factorisation, known from the analysis.
  double operations() const;
  /// Symbolic analysis with nested dissection (METIS, Karypis & Kumar 1998), for bodies in space: a third of the
  /// operations of approximate minimum degree, which is taken where the library was built without it.
  void analyse_dissected(const SymmetricMatrix& matrix);
  /// Symbolic analysis of a matrix of the same size with the order of elimination of the last one.
  void analyse_in_same_order(const SymmetricMatrix& matrix);
  /// Numeric factorisation; false when the matrix is not positive definite, or a pivot vanishes.
  [[nodiscard]] bool factorise(const SymmetricMatrix& matrix);
  /// Solution for one right-hand side of `size` entries, or for each column of several.
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& rhs) const;

 private:
  struct Data;
  /// `given`: the order of elimination where `ordering` asks for one.
  bool analyse_by(int ordering, const SymmetricMatrix& matrix, std::vector<Index> given);

  std::unique_ptr<Data> data_;
};

}  // namespace parison::core
