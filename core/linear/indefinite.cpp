// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/indefinite.hpp"

#include <fmt/core.h>

#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/linear/cholesky.hpp"
#include "core/linear/mumps.hpp"
#include "core/process/run_error.hpp"
#include "core/process/work_times.hpp"

namespace parison::core {

namespace {

/// Number of operations from which MUMPS factorises. Measured with one to ten right-hand sides: at 4e7 CHOLMOD is
/// faster from five on, at 1e8 MUMPS up to five, at 4e8 up to seventeen. METIS's ordering gains nothing below 1e9.
constexpr double mumps_pays = 1.5e8;

/// A MUMPS instance with the matrix scaled to unit rows.
struct Mumps {
  MumpsInstance instance;
  std::vector<int> row, column, place;  // from 1
  std::vector<Index> number;            ///< that the unknowns have in `solve`
  std::vector<double> value;
  Eigen::VectorXd scale;

  Mumps() {
    instance.control(7) = 1;    // ordered here
    instance.control(14) = 60;  // more room than estimated, %
  }
  int factorise_once() {
    const WorkTimer timer(&WorkTimes::factorisation);
    return instance.run(2);
  }
  /// `place`: position of each unknown in the order of elimination, from 1.
  void analyse(const SymmetricMatrix& matrix, std::vector<int> in_order);
  bool factorise(const SymmetricMatrix& matrix);
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs);
};

/// Throws where MUMPS reports an error, mostly for want of memory; the codes are those of its users' guide, section 8.
void require(int status) {
  constexpr int real_workspace = -5, integer_workspace = -7, memory = -13;
  if (status == real_workspace || status == integer_workspace || status == memory)
    throw RunError(fmt::format(
        "the memory does not suffice to factorise the flow's matrix (MUMPS {}); a coarser mesh needs less", status));
  if (status < 0) throw RunError(fmt::format("the flow's matrix cannot be factorised (MUMPS {})", status));
}

/// Scaling D of D A D: every positive diagonal entry becomes 1, and every row without one gets the length 1.
Eigen::VectorXd row_scale(const SymmetricMatrix& matrix) {
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(matrix.size), length = scale;
  for (Index j = 0; j < matrix.size; ++j)
    for (Index k = matrix.column_start[j]; k < matrix.column_start[j + 1]; ++k)
      if (matrix.row[k] == j && matrix.value[k] > 0) scale[j] = 1 / std::sqrt(matrix.value[k]);
  for (Index j = 0; j < matrix.size; ++j)
    for (Index k = matrix.column_start[j]; k < matrix.column_start[j + 1]; ++k) {
      const Index i = matrix.row[k];
      if (i == j) continue;
      if (scale[i] == 0) length[i] += std::pow(matrix.value[k] * scale[j], 2);
      if (scale[j] == 0) length[j] += std::pow(matrix.value[k] * scale[i], 2);
    }
  for (Index j = 0; j < matrix.size; ++j)
    if (scale[j] == 0) scale[j] = length[j] > 0 ? 1 / std::sqrt(length[j]) : 1;
  return scale;
}

void Mumps::analyse(const SymmetricMatrix& matrix, std::vector<int> in_order) {
  place = std::move(in_order);
  row.clear();
  column.clear();
  for (Index c = 0; c < matrix.size; ++c)
    for (Index k = matrix.column_start[c]; k < matrix.column_start[c + 1]; ++k) {
      row.push_back(matrix.row[k] + 1);
      column.push_back(c + 1);
    }
  value.assign(row.size(), 0.0);
  instance.data.n = matrix.size;
  instance.data.nnz = static_cast<MUMPS_INT8>(row.size());
  instance.data.irn = row.data();
  instance.data.jcn = column.data();
  instance.data.a = value.data();
  instance.data.perm_in = place.data();
  require(instance.run(1));
}

bool Mumps::factorise(const SymmetricMatrix& matrix) {
  assert(instance.data.n == matrix.size);
  scale = row_scale(matrix);
  for (std::size_t k = 0; k < value.size(); ++k) value[k] = matrix.value[k] * scale[row[k] - 1] * scale[column[k] - 1];
  int status = factorise_once();
  while ((status == -8 || status == -9) && instance.control(14) < 2000) {  // delayed pivots asked for more room
    instance.control(14) *= 2;
    status = factorise_once();
  }
  constexpr int singular = -10, too_many_delayed = -9, too_many_delayed_indices = -8;
  if (status == singular || status == too_many_delayed || status == too_many_delayed_indices) return false;
  require(status);
  return true;
}

Eigen::MatrixXd Mumps::solve(const Eigen::MatrixXd& rhs) {
  Eigen::MatrixXd solution = rhs(number, Eigen::all);
  solution = (scale.asDiagonal() * solution).eval();
  instance.data.rhs = solution.data();
  instance.data.nrhs = static_cast<int>(rhs.cols());
  instance.data.lrhs = static_cast<int>(rhs.rows());
  {
    const WorkTimer timer(&WorkTimes::solution);
    require(instance.run(3));
  }
  solution = (scale.asDiagonal() * solution).eval();
  Eigen::MatrixXd by_number(rhs.rows(), rhs.cols());
  by_number(number, Eigen::all) = solution;
  return by_number;
}

}  // namespace

struct IndefiniteSolver::Data {
  Cholesky cholmod{Cholesky::Form::quasi_definite};
  std::optional<Mumps> mumps;
};

IndefiniteSolver::IndefiniteSolver() : data_(std::make_unique<Data>()) {}
IndefiniteSolver::~IndefiniteSolver() = default;
IndefiniteSolver::IndefiniteSolver(IndefiniteSolver&&) noexcept = default;
IndefiniteSolver& IndefiniteSolver::operator=(IndefiniteSolver&&) noexcept = default;

void IndefiniteSolver::analyse_ordered(const SymmetricMatrix& matrix, const std::vector<Index>& order,
                                       Library library) {
  data_->mumps.reset();
  data_->cholmod.analyse_ordered(matrix, order);
  const bool pays = data_->cholmod.operations() > mumps_pays;
  if (library == Library::cholmod || (library == Library::automatic && !pays)) return;
  std::vector<int> place(order.size());
  std::iota(place.begin(), place.end(), 1);
  data_->mumps.emplace();
  data_->mumps->number = order;
  data_->mumps->analyse(matrix, std::move(place));
}

bool IndefiniteSolver::factorise(const SymmetricMatrix& matrix) {
  return data_->mumps ? data_->mumps->factorise(matrix) : data_->cholmod.factorise(matrix);
}

Eigen::MatrixXd IndefiniteSolver::solve(const Eigen::MatrixXd& rhs) const {
  return data_->mumps ? data_->mumps->solve(rhs) : data_->cholmod.solve_columns(rhs);
}

}  // namespace parison::core
