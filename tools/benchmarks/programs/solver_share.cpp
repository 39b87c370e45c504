// SPDX-License-Identifier: GPL-3.0-or-later
// solver_share CASE ACCURACY FOLDER THREADS: runs a case and prints seconds on the wall clock of the whole run, of
// numeric factorisation and of back-substitution, and CPU seconds of all threads and of the first; THREADS are those of
// OpenBLAS, of which `parison` itself takes one.
#include <cstdio>
#include <cstdlib>

#include "core/process/clock.hpp"
#include "core/process/work_times.hpp"
#include "forming/run/folder_run.hpp"
#include "tools/benchmarks/programs/bare_flow.hpp"

/// OpenBLAS; absent where another BLAS is installed.
extern "C" __attribute__((weak)) void openblas_set_num_threads(int count);

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
  const double start = parison::core::wall_seconds();
  const auto outcome = parison::forming::run_in_folder(parison::forming::read_scene(argv[1], argv[2]), argv[3]);
  if (!outcome.facts.completed) {
    std::fprintf(stderr, "solver_share: %s\n", outcome.facts.reason.c_str());
    return 1;
  }
  const auto solvers = parison::core::work_times();
  std::printf("\nwhole %.4f factorising %.4f solving %.4f cpu %.4f first %.4f\n", parison::core::wall_seconds() - start,
              solvers.factorisation, solvers.solution, parison::bench::cpu_seconds(),
              parison::core::thread_cpu_seconds());
  return 0;
}
