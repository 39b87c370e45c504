// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/cholesky.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cassert>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "core/process/work_times.hpp"

extern "C" __attribute__((weak)) int omp_get_max_active_levels();
extern "C" __attribute__((weak)) void omp_set_max_active_levels(int levels);

namespace parison::core {

namespace {

/// Keeps a supernodal factorisation on the calling thread: CHOLMOD asks OpenMP for four whatever the environment says,
/// and on two cores they wait for each other twice as long as they compute.
class OneThread {
 public:
  OneThread() : levels_(omp_get_max_active_levels ? omp_get_max_active_levels() : 0) {
    if (omp_set_max_active_levels) omp_set_max_active_levels(0);
  }
  ~OneThread() {
    if (omp_set_max_active_levels) omp_set_max_active_levels(levels_);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_;
};

/// A triangle of the matrix in the order of elimination, and where each of the matrix's entries goes in it.
struct Permuted {
  std::vector<Index> column_start, row, place;
  std::vector<double> value;
};

/// Places of items by ascending key, those of equal key in their order.
std::vector<Index> by_key(const std::vector<Index>& items, const std::vector<Index>& key, Index keys,
                          std::vector<Index>& start) {
  start.assign(keys + 1, 0);
  for (const Index item : items) ++start[key[item] + 1];
  for (Index k = 0; k < keys; ++k) start[k + 1] += start[k];
  std::vector<Index> sorted(items.size()), next(start.begin(), start.end() - 1);
  for (const Index item : items) sorted[next[key[item]]++] = item;
  return sorted;
}

Permuted permute(const SymmetricMatrix& matrix, const Index* order, bool upper) {
  Permuted result;
  std::vector<Index> rank(matrix.size), row(matrix.row.size()), column(matrix.row.size()), items(matrix.row.size());
  for (Index k = 0; k < matrix.size; ++k) rank[order[k]] = k;
  for (Index c = 0; c < matrix.size; ++c)
    for (Index k = matrix.column_start[c]; k < matrix.column_start[c + 1]; ++k) {
      const auto [first, last] = std::minmax(rank[c], rank[matrix.row[k]]);
      row[k] = upper ? first : last;
      column[k] = upper ? last : first;
      items[k] = k;
    }
  std::vector<Index> unused;
  items = by_key(by_key(items, row, matrix.size, unused), column, matrix.size, result.column_start);
  result.row.resize(items.size());
  result.place.resize(items.size());
  for (Index k = 0; k < static_cast<Index>(items.size()); ++k) {
    result.row[k] = row[items[k]];
    result.place[items[k]] = k;
  }
  result.value.assign(items.size(), 0.0);
  return result;
}

}  // namespace

/// The matrix is handed over in the order of elimination: CHOLMOD would order it anew at each factorisation. Its factor
/// has the order for the solves.
struct Cholesky::Data {
  mutable cholmod_common common;
  std::optional<Permuted> permuted;  ///< unless the matrix is in that order itself
  bool upper = false;
  cholmod_factor* factor = nullptr;
  mutable cholmod_dense *solution = nullptr, *work_y = nullptr, *work_e = nullptr;

  explicit Data(Form form) {
    cholmod_start(&common);
    common.nmethods = 1;
    common.supernodal = form == Form::positive_definite ? CHOLMOD_AUTO : CHOLMOD_SIMPLICIAL;
    common.final_ll = form == Form::positive_definite;  // an LDL' lets negative pivots pass
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
  }
  /// Of a triangle in the order of its elimination, order[k] the unknown that is eliminated as the k-th.
  void analyse(cholmod_sparse sparse, const std::vector<Index>& order) {
    upper = sparse.stype > 0;
    cholmod_free_factor(&factor, &common);
    common.method[0].ordering = CHOLMOD_NATURAL;
    common.postorder = 0;
    const int chosen = std::exchange(common.supernodal, upper ? CHOLMOD_SIMPLICIAL : CHOLMOD_SUPERNODAL);
    factor = cholmod_analyze(&sparse, &common);
    common.supernodal = chosen;
    if (!factor) throw std::bad_alloc();
    std::copy(order.begin(), order.end(), static_cast<Index*>(factor->Perm));
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

/// `type`: 1 for an upper triangle, -1 for a lower one.
template <class Matrix>
cholmod_sparse view(const Matrix& matrix, int type) {
  cholmod_sparse sparse{};
  sparse.nrow = sparse.ncol = matrix.column_start.size() - 1;
  sparse.nzmax = matrix.row.size();
  sparse.p = const_cast<Index*>(matrix.column_start.data());
  sparse.i = const_cast<Index*>(matrix.row.data());
  sparse.x = const_cast<double*>(matrix.value.data());
  sparse.stype = type;
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

bool Cholesky::analyse_by(int ordering, const SymmetricMatrix& matrix, std::vector<Index> given) {
  auto& common = data_->common;
  cholmod_free_factor(&data_->factor, &common);
  common.method[0].ordering = ordering;
  common.postorder = 1;
  cholmod_sparse sparse = view(matrix, -1);
  data_->factor = cholmod_analyze_p(&sparse, given.empty() ? nullptr : given.data(), nullptr, 0, &common);
  if (!data_->factor) return false;
  const auto* found = static_cast<const Index*>(data_->factor->Perm);
  const std::vector<Index> order(found, found + matrix.size);
  // The triangle of which a factorisation needs no transpose.
  const bool upper = !data_->factor->is_super;
  data_->permuted = permute(matrix, order.data(), upper);
  data_->analyse(view(*data_->permuted, upper ? 1 : -1), order);
  return true;
}

void Cholesky::analyse(const SymmetricMatrix& matrix) {
  if (!analyse_by(CHOLMOD_AMD, matrix, {})) throw std::bad_alloc();
}

void Cholesky::analyse_ordered(const SymmetricMatrix& matrix, const std::vector<Index>& order, Triangle triangle) {
  data_->permuted.reset();
  data_->analyse(view(matrix, triangle == Triangle::upper ? 1 : -1), order);
}

double Cholesky::operations() const {
  return data_->common.fl;
}

void Cholesky::analyse_dissected(const SymmetricMatrix& matrix) {
  if (!analyse_by(CHOLMOD_METIS, matrix, {})) analyse(matrix);
}

void Cholesky::analyse_in_same_order(const SymmetricMatrix& matrix) {
  assert(data_->factor && static_cast<Index>(data_->factor->n) == matrix.size);
  const auto* order = static_cast<const Index*>(data_->factor->Perm);
  if (!analyse_by(CHOLMOD_GIVEN, matrix, std::vector<Index>(order, order + matrix.size))) throw std::bad_alloc();
}

bool Cholesky::factorise(const SymmetricMatrix& matrix) {
  assert(data_->factor);
  if (auto& permuted = data_->permuted)
    for (std::size_t k = 0; k < matrix.value.size(); ++k) permuted->value[permuted->place[k]] = matrix.value[k];
  const int type = data_->upper ? 1 : -1;
  cholmod_sparse sparse = data_->permuted ? view(*data_->permuted, type) : view(matrix, type);
  data_->factor->ordering = CHOLMOD_NATURAL;
  {
    const WorkTimer timer(&WorkTimes::factorisation);
    const OneThread thread;
    cholmod_factorize(&sparse, data_->factor, &data_->common);
  }
  data_->factor->ordering = CHOLMOD_GIVEN;
  return data_->common.status == CHOLMOD_OK;
}

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& rhs) const {
  return solve_columns(rhs);
}

Eigen::MatrixXd Cholesky::solve_columns(const Eigen::MatrixXd& rhs) const {
  cholmod_dense b{};
  b.nrow = b.d = static_cast<std::size_t>(rhs.rows());
  b.ncol = static_cast<std::size_t>(rhs.cols());
  b.nzmax = b.nrow * b.ncol;
  b.x = const_cast<double*>(rhs.data());
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  const WorkTimer timer(&WorkTimes::solution);
  const OneThread thread;
  cholmod_solve2(CHOLMOD_A, data_->factor, &b, nullptr, &data_->solution, nullptr, &data_->work_y, &data_->work_e,
                 &data_->common);
  return Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(data_->solution->x), rhs.rows(), rhs.cols());
}

}  // namespace parison::core
