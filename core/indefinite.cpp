// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/indefinite.hpp"

#include <dmumps_c.h>

#include <cassert>

namespace parison::core {

struct IndefiniteSolver::Data {
  DMUMPS_STRUC_C mumps{};
  std::vector<int> row, column;  // from 1

  Data() {
    mumps.job = -1;
    mumps.par = 1;
    mumps.sym = 2;
    mumps.comm_fortran = -987654;
    dmumps_c(&mumps);
    for (const int stream : {1, 2, 3}) control(stream) = -1;
    control(4) = 0;
    control(7) = 0;    // ordering: AMD (this package would take Scotch without saying so)
    control(14) = 60;  // more room than estimated, %
    control(28) = 1;
  }
  ~Data() {
    mumps.job = -2;
    dmumps_c(&mumps);
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;

  int& control(int number) { return mumps.icntl[number - 1]; }
  int run(int job) {
    mumps.job = job;
    dmumps_c(&mumps);
    return mumps.infog[0];
  }
};

IndefiniteSolver::IndefiniteSolver() : data_(std::make_unique<Data>()) {}
IndefiniteSolver::~IndefiniteSolver() = default;
IndefiniteSolver::IndefiniteSolver(IndefiniteSolver&&) noexcept = default;
IndefiniteSolver& IndefiniteSolver::operator=(IndefiniteSolver&&) noexcept = default;

void IndefiniteSolver::analyse(const SymmetricMatrix& matrix) {
  auto& data = *data_;
  data.row.clear();
  data.column.clear();
  for (Index column = 0; column < matrix.size; ++column)
    for (Index k = matrix.column_start[column]; k < matrix.column_start[column + 1]; ++k) {
      data.row.push_back(matrix.row[k] + 1);
      data.column.push_back(column + 1);
    }
  data.mumps.n = matrix.size;
  data.mumps.nnz = static_cast<MUMPS_INT8>(data.row.size());
  data.mumps.irn = data.row.data();
  data.mumps.jcn = data.column.data();
  data.mumps.a = const_cast<double*>(matrix.value.data());
  [[maybe_unused]] const int status = data.run(1);
  assert(status >= 0);
}

bool IndefiniteSolver::factorise(const SymmetricMatrix& matrix) {
  auto& data = *data_;
  assert(data.mumps.n == matrix.size);
  data.mumps.a = const_cast<double*>(matrix.value.data());
  int status = data.run(2);
  while ((status == -8 || status == -9) && data.control(14) < 2000) {  // delayed pivots asked for more room
    data.control(14) *= 2;
    status = data.run(2);
  }
  return status >= 0;
}

Eigen::MatrixXd IndefiniteSolver::solve(const Eigen::MatrixXd& rhs) const {
  auto& data = *data_;
  Eigen::MatrixXd solution = rhs;
  data.mumps.rhs = solution.data();
  data.mumps.nrhs = static_cast<int>(rhs.cols());
  data.mumps.lrhs = static_cast<int>(rhs.rows());
  [[maybe_unused]] const int status = data.run(3);
  assert(status >= 0);
  return solution;
}

}  // namespace parison::core
