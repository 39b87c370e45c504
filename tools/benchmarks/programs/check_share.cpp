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
#include "forming/step/balance/volume_conservation.hpp"
#include "forming/step/balance/work.hpp"
#include "forming/step/contact/penetration.hpp"
#include "forming/step/heat/bounds/temperature_bounds.hpp"
#include "forming/step/heat/contact_skin.hpp"
#include "remesh/sizing/recovery.hpp"
#include "tools/benchmarks/programs/bare_flow.hpp"
#include "tools/program/blas_threads.hpp"

namespace {

using namespace parison;

constexpr int every = 8;        ///< steps from one that is measured to the next
constexpr int flow_every = 15;  ///< steps from one of which the run compares the rate of deformation to the next

class CheckShare : public forming::RunObserver {
 public:
  void step_tried(const forming::RunView& run, const forming::StepResult& result) override {
    if (!result.converged || seen_++ % every != 0) return;
    const double start = core::thread_cpu_seconds();
    if (run.scene.has_heat()) heat_checks(run, result);
    if (run.scene.has_flow()) flow_checks(run, result);
    own_ += core::thread_cpu_seconds() - start;
  }
  void run_ends(const forming::RunView& run) override {
    timed("verdict", 1, [&] { forming::checks(run.scene, run.state, run.facts); });
  }

  /// CPU seconds that these measurements took themselves.
  double own() const { return own_; }
  const std::map<std::string, double>& seconds() const { return seconds_; }

 private:
  template <typename Work>
  void timed(const char* what, double weight, const Work& work) {
    const double start = core::thread_cpu_seconds();
    work();
    seconds_[what] += weight * (core::thread_cpu_seconds() - start);
  }

  void heat_checks(const forming::RunView& run, const forming::StepResult& result) {
    forming::State after = result.state;
    const double dt = result.report.dt;
    std::vector<double> received;
    received.reserve(run.state.tools.size());
    for (const auto& tool : run.state.tools) received.push_back(tool.heat_received);
    timed("bounds", every, [&] { forming::update_temperature_bounds(run.scene, result.dissipation, dt, after); });
    timed("skins", every,
          [&] { forming::update_contact_skins(run.scene, result.report.interface, dt, received, after); });
    if (!run.scene.has_flow()) return;
    const forming::GlassState &first = run.state.glass, &last = result.state.glass;
    timed("coupling", every, [&] {
      forming::unforeseen_work(run.scene.glass.flow->viscosity, first.mesh, result.dissipation, first.temperature,
                               first.temperature, last.temperature, dt);
    });
  }

  void flow_checks(const forming::RunView& run, const forming::StepResult& result) {
    const forming::Scene& scene = run.scene;
    timed("penetration", every, [&] {
      const forming::Totals& known = run.state.totals;
      forming::max_penetration(scene, result.state, known.max_penetration);
      forming::max_edge_penetration(scene, result.state, known.max_edge_penetration);
    });
    timed("volume", every, [&] { forming::volume_drift(scene, result.state); });
    timed("resolution", double(every) / flow_every,
          [&] { remesh::rate_error(run.state.glass.mesh, scene.geometry, result.state.glass.velocity); });
    flow::Solution solution;
    solution.dissipation = result.dissipation;
    timed("cap", every, [&] { forming::capped_work(scene, run.state, solution, result.report.dt); });
  }

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
