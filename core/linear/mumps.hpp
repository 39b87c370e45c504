#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <dmumps_c.h>

namespace parison::core {

/// An instance of MUMPS (Amestoy, Duff, L'Excellent & Koster 2001) for symmetric matrices, silent and without anything
/// that looks at values before the factorisation.
struct MumpsInstance {
  DMUMPS_STRUC_C data{};

  MumpsInstance();
  ~MumpsInstance();
  MumpsInstance(const MumpsInstance&) = delete;
  MumpsInstance& operator=(const MumpsInstance&) = delete;

  /// ICNTL by the numbers of the users' guide.
  int& control(int entry) { return data.icntl[entry - 1]; }
  /// Does job 1, 2 or 3 and returns INFOG(1), negative for an error. Threads take turns.
  int run(int job);
};

}  // namespace parison::core
