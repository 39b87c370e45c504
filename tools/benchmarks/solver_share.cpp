// SPDX-License-Identifier: GPL-3.0-or-later
// solver_share CASE ACCURACY FOLDER THREADS: runs a case and prints CPU seconds of the whole run, of numeric
// factorisation, of back-substitution and of the first thread; THREADS are those of OpenBLAS, of which `parison` itself
// takes one. The calls of CHOLMOD and MUMPS go through this file (see CMakeLists.txt).
#include <cholmod.h>
#include <dmumps_c.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "forming/run/run.hpp"
#include "tools/benchmarks/bare_flow.hpp"

/// OpenBLAS; absent where another BLAS is installed.
extern "C" __attribute__((weak)) void openblas_set_num_threads(int count);

namespace {

using parison::bench::cpu_seconds;

struct SolverTimes {
  double factorising = 0, solving = 0;
} solver_times;

/// Runs a call and accumulates its CPU time.
template <typename Call>
auto timed(double& seconds, Call call) {
  struct Clock {
    double& seconds;
    double start = cpu_seconds();
    ~Clock() { seconds += cpu_seconds() - start; }
  } clock{seconds};
  return call();
}

}  // namespace

extern "C" {

int __real_cholmod_factorize(cholmod_sparse*, cholmod_factor*, cholmod_common*);
int __wrap_cholmod_factorize(cholmod_sparse* matrix, cholmod_factor* factor, cholmod_common* common) {
  return timed(solver_times.factorising, [&] { return __real_cholmod_factorize(matrix, factor, common); });
}

int __real_cholmod_solve2(int, cholmod_factor*, cholmod_dense*, cholmod_sparse*, cholmod_dense**, cholmod_sparse**,
                          cholmod_dense**, cholmod_dense**, cholmod_common*);
int __wrap_cholmod_solve2(int system, cholmod_factor* factor, cholmod_dense* b, cholmod_sparse* b_set,
                          cholmod_dense** x, cholmod_sparse** x_set, cholmod_dense** y, cholmod_dense** e,
                          cholmod_common* common) {
  return timed(solver_times.solving,
               [&] { return __real_cholmod_solve2(system, factor, b, b_set, x, x_set, y, e, common); });
}

void __real_dmumps_c(DMUMPS_STRUC_C*);
void __wrap_dmumps_c(DMUMPS_STRUC_C* instance) {
  constexpr int factorise = 2, solve = 3;
  double other_seconds = 0;  // analysis, set-up
  double& seconds = instance->job == factorise ? solver_times.factorising
                    : instance->job == solve   ? solver_times.solving
                                               : other_seconds;
  timed(seconds, [&] { __real_dmumps_c(instance); });
}

}  // extern "C"

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "solver_share: CASE ACCURACY FOLDER THREADS\n");
    return 2;
  }
  const int threads = std::atoi(argv[4]);
  if (openblas_set_num_threads)
    openblas_set_num_threads(threads);
  else if (threads > 1)
    return std::fprintf(stderr, "solver_share: the BLAS is not OpenBLAS\n"), 1;
  const auto outcome = parison::forming::run(parison::forming::read_scene(argv[1], argv[2]), argv[3]);
  if (!outcome.facts.completed) {
    std::fprintf(stderr, "solver_share: %s\n", outcome.facts.reason.c_str());
    return 1;
  }
  timespec first{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &first);
  std::printf("\nwhole %.4f factorising %.4f solving %.4f first %.4f\n", cpu_seconds(), solver_times.factorising,
              solver_times.solving, double(first.tv_sec) + 1e-9 * double(first.tv_nsec));
  return 0;
}
