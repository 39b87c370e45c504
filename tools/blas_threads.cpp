// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/blas_threads.hpp"

/// OpenBLAS; absent where another BLAS is installed.
extern "C" __attribute__((weak)) void openblas_set_num_threads(int count);

namespace parison::tools {

void use_one_blas_thread() {
  if (openblas_set_num_threads) openblas_set_num_threads(1);
}

}  // namespace parison::tools
