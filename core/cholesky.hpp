#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "core/symmetric_matrix.hpp"

namespace parison::core {

/// CHOLMOD supernodal Cholesky of a symmetric positive definite matrix; the analysis serves until the pattern changes.
class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Symbolic analysis (AMD).
  void analyse(const SymmetricMatrix& matrix);
  /// Numeric factorisation; false when the matrix is not positive definite.
  [[nodiscard]] bool factorise(const SymmetricMatrix& matrix);
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace parison::core
