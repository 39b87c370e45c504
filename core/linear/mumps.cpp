// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/mumps.hpp"

#include <mutex>

namespace parison::core {

namespace {

/// The sequential library keeps its instances in one table for the whole process: one call at a time.
void call_mumps(DMUMPS_STRUC_C& data) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  dmumps_c(&data);
}

}  // namespace

MumpsInstance::MumpsInstance() {
  data.job = -1;
  data.par = 1;
  data.sym = 2;
  data.comm_fortran = -987654;
  call_mumps(data);
  for (const int stream : {1, 2, 3}) control(stream) = -1;
  control(4) = 0;
  control(6) = 0;   // no permutation for large diagonal entries: the analysis sees the pattern alone
  control(8) = 0;   // no scaling
  control(12) = 1;  // ordering of the pattern as it is
  control(28) = 1;
}

MumpsInstance::~MumpsInstance() {
  data.job = -2;
  call_mumps(data);
}

int MumpsInstance::run(int job) {
  data.job = job;
  call_mumps(data);
  return data.infog[0];
}

}  // namespace parison::core
