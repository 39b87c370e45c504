// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/kept_memory.hpp"

#include <cstdlib>
#include <mutex>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace parison::tools {
namespace {

constexpr int MiB = 1 << 20;
std::mutex guard;
int living = 0;

/// What the settings of glibc become by themselves once a block of 32 MiB has been freed; it adapts them no more after
/// they have been set.
void give_freed_memory_back() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 * MiB);
  mallopt(M_TRIM_THRESHOLD, 64 * MiB);
  mallopt(M_TOP_PAD, MiB / 8);
  malloc_trim(0);
#endif
}

}  // namespace

KeptMemory::KeptMemory() {
  const std::lock_guard lock(guard);
  if (living++ == 0) keep_freed_memory();
}

KeptMemory::~KeptMemory() {
  const std::lock_guard lock(guard);
  if (--living == 0) give_freed_memory_back();
}

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 * MiB);  // the most that it accepts
  mallopt(M_TRIM_THRESHOLD, 1024 * MiB);
  mallopt(M_TOP_PAD, 16 * MiB);
#endif
}

}  // namespace parison::tools
