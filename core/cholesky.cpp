// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cholesky.hpp"

#include <cholmod.h>

#include <cassert>
#include <new>

namespace parison::core {

struct Cholesky::Data {
  mutable cholmod_common common;
  cholmod_factor* factor = nullptr;
  mutable cholmod_dense *solution = nullptr, *work_y = nullptr, *work_e = nullptr;

  explicit Data(Form form) {
    cholmod_start(&common);
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.supernodal = form == Form::positive_definite ? CHOLMOD_AUTO : CHOLMOD_SIMPLICIAL;
    common.final_ll = form == Form::positive_definite;  // an LDL' lets negative pivots pass
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
  }
  ~Data() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work_y, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
};

namespace {

cholmod_sparse view(const SymmetricMatrix& matrix) {
  cholmod_sparse sparse{};
  sparse.nrow = sparse.ncol = static_cast<std::size_t>(matrix.size);
  sparse.nzmax = matrix.row.size();
  sparse.p = const_cast<Index*>(matrix.column_start.data());
  sparse.i = const_cast<Index*>(matrix.row.data());
  sparse.x = const_cast<double*>(matrix.value.data());
  sparse.stype = -1;
  sparse.itype = CHOLMOD_INT;
  sparse.xtype = CHOLMOD_REAL;
  sparse.dtype = CHOLMOD_DOUBLE;
  sparse.sorted = sparse.packed = 1;
  return sparse;
}

}  // namespace

Cholesky::Cholesky() : Cholesky(Form::positive_definite) {}
Cholesky::Cholesky(Form form) : data_(std::make_unique<Data>(form)) {}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

void Cholesky::analyse(const SymmetricMatrix& matrix) {
  cholmod_sparse sparse = view(matrix);
  cholmod_free_factor(&data_->factor, &data_->common);
  data_->factor = cholmod_analyze(&sparse, &data_->common);
  if (!data_->factor) throw std::bad_alloc();
}

bool Cholesky::factorise(const SymmetricMatrix& matrix) {
  assert(data_->factor);
  cholmod_sparse sparse = view(matrix);
  cholmod_factorize(&sparse, data_->factor, &data_->common);
  return data_->common.status == CHOLMOD_OK;
}

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& rhs) const { return solve_columns(rhs); }

Eigen::MatrixXd Cholesky::solve_columns(const Eigen::MatrixXd& rhs) const {
  cholmod_dense b{};
  b.nrow = b.d = static_cast<std::size_t>(rhs.rows());
  b.ncol = static_cast<std::size_t>(rhs.cols());
  b.nzmax = b.nrow * b.ncol;
  b.x = const_cast<double*>(rhs.data());
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_solve2(CHOLMOD_A, data_->factor, &b, nullptr, &data_->solution, nullptr, &data_->work_y, &data_->work_e,
                 &data_->common);
  return Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(data_->solution->x), rhs.rows(), rhs.cols());
}

double Cholesky::operations() const { return data_->common.fl; }

}  // namespace parison::core
