// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/blas_threads.hpp"

#include <cblas.h>

namespace parison::tools {

void use_one_blas_thread() {
  openblas_set_num_threads(1);
}

OneBlasThread::OneBlasThread() : before_(openblas_get_num_threads()) {
  openblas_set_num_threads(1);
}

OneBlasThread::~OneBlasThread() {
  openblas_set_num_threads(before_);
}

}  // namespace parison::tools
