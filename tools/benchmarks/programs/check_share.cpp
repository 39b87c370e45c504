// SPDX-License-Identifier: GPL-3.0-or-later
// check_share CASE ACCURACY FOLDER: runs a case and prints CPU seconds of the run and of what it computes for its
// checks alone: done again beside every eighth step and counted eightfold. The work balance is not among them, as it
// steers the steps.
#include <cstdio>
#include <map>
#include <string>

#include "core/process/clock.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/run/folder_run.hpp"
#include "tools/benchmarks/programs/bare_flow.hpp"
#include "tools/program/blas_threads.hpp"

namespace {

using namespace parison;

constexpr int every = 8;  ///< steps from one that is measured to the next

class CheckShare : public forming::RunObserver {
 public:
  void step_tried(const forming::RunView& run, const forming::StepResult& result) override {
    if (!result.converged || seen_++ % every != 0) return;
    forming::Diagnostics copy = run.facts.diagnostics;
    const double start = core::thread_cpu_seconds();
    forming::follow(run.scene, run.state, result, copy);
    const double taken = core::thread_cpu_seconds() - start;
    seconds_["diagnostics"] += every * taken;
    own_ += taken;
  }
  void run_ends(const forming::RunView& run) override {
    const double start = core::thread_cpu_seconds();
    forming::checks(run.scene, run.state, run.facts);
    seconds_["verdict"] += core::thread_cpu_seconds() - start;
  }

  /// CPU seconds that these measurements took themselves.
  double own() const { return own_; }
  const std::map<std::string, double>& seconds() const { return seconds_; }

 private:
  std::map<std::string, double> seconds_;
  double own_ = 0;
  int seen_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "check_share: CASE ACCURACY FOLDER\n");
    return 2;
  }
  tools::use_one_blas_thread();
  CheckShare checks;
  const auto outcome = forming::run_in_folder(forming::read_scene(argv[1], argv[2]), argv[3], {&checks});
  if (!outcome.facts.completed) {
    std::fprintf(stderr, "check_share: %s\n", outcome.facts.reason.c_str());
    return 1;
  }
  std::printf("\nwhole %.4f", bench::cpu_seconds() - checks.own());
  for (const auto& [what, seconds] : checks.seconds()) std::printf(" %s %.4f", what.c_str(), seconds);
  std::printf("\n");
  return 0;
}
