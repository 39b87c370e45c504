// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/blas_threads.hpp"

#include <cblas.h>

#include <mutex>

namespace parison::tools {

void use_one_blas_thread() {
  openblas_set_num_threads(1);
}

namespace {
std::mutex guard;
int living = 0;
int threads_before = 1;
}  // namespace

OneBlasThread::OneBlasThread() {
  const std::lock_guard lock(guard);
  if (living++ == 0) threads_before = openblas_get_num_threads();
  openblas_set_num_threads(1);
}

OneBlasThread::~OneBlasThread() {
  const std::lock_guard lock(guard);
  if (--living == 0) openblas_set_num_threads(threads_before);
}

}  // namespace parison::tools
