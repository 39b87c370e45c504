// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/blas_threads.hpp"

#include <cblas.h>

namespace parison::tools {

void use_one_blas_thread() {
  openblas_set_num_threads(1);
}

}  // namespace parison::tools
