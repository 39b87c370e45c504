// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/kept_memory.hpp"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace parison::tools {

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int MiB = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * MiB);  // the most that it accepts
  mallopt(M_TRIM_THRESHOLD, 1024 * MiB);
  mallopt(M_TOP_PAD, 16 * MiB);
#endif
}

}  // namespace parison::tools
