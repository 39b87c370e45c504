#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "core/symmetric_matrix.hpp"

namespace parison::core {

/// MUMPS LDL' of a symmetric indefinite matrix (saddle points), AMD ordering; the analysis serves until the pattern changes.
class IndefiniteSolver {
 public:
  IndefiniteSolver();
  ~IndefiniteSolver();
  IndefiniteSolver(IndefiniteSolver&&) noexcept;
  IndefiniteSolver& operator=(IndefiniteSolver&&) noexcept;

  void analyse(const SymmetricMatrix& matrix);
  /// Numeric factorisation; false when a pivot vanishes.
  [[nodiscard]] bool factorise(const SymmetricMatrix& matrix);
  /// Solves for each column of rhs.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace parison::core
