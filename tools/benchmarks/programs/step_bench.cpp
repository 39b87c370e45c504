// SPDX-License-Identifier: GPL-3.0-or-later
// step_bench CASE ACCURACY FOLDER EVERY: runs a case and writes FOLDER.steps.csv, CPU seconds of each step and its
// parts. At every EVERY-th step also a bare factorisation, the heat of the step with its interface and with copies of
// it, and what the step's control reads from the interface.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

#include "core/process/clock.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "forming/step/heat/surface_temperature.hpp"
#include "tools/benchmarks/programs/bare_flow.hpp"
#include "tools/program/blas_threads.hpp"

namespace {

using namespace parison;

/// Interfaces, each with its share of the area, that replace the step's own to see what one costs.
constexpr int copies = 5;
/// Times that the heat is measured with the one and with the copies, in turn; the least counts, for what else runs
/// here.
constexpr int repeats = 5;

std::vector<core::InterfacePoint> copied(std::vector<core::InterfacePoint> points) {
  for (core::InterfacePoint& point : points) point.area /= copies;
  std::vector<core::InterfacePoint> result;
  for (int i = 0; i < copies; ++i) result.insert(result.end(), points.begin(), points.end());
  return result;
}

/// CPU time of the step's heat once more, from the temperatures before it, s.
double heat_seconds(const forming::Scene& scene, const forming::State& before, const forming::StepResult& result,
                    const std::vector<core::InterfacePoint>& interface, forming::Workspace& workspace) {
  forming::State state = result.state;
  for (core::Index b = 0; b < forming::body_count(state); ++b)
    forming::temperature_of(state, b) = forming::temperature_of(before, b);
  state.heat_substep = before.heat_substep;
  state.heat_couplings = before.heat_couplings;
  state.light = before.light;
  workspace.heat.factored_step = 0;  // as at the start of a step
  const double start = bench::cpu_seconds();
  forming::advance_heat(scene, state, interface, {}, result.report.dt, workspace);
  return bench::cpu_seconds() - start;
}

/// Writes a row for each step that is tried.
class StepBench : public forming::RunObserver {
 public:
  StepBench(const std::string& path, int every) : table_(path), every_(every) {
    table_ << "time,converged,triangles,iterations,step,flow,heat,contact,bare,heat_again,interface_in_heat,watched\n";
  }
  void step_begins(const forming::RunView&) override {
    wall_start_ = core::wall_seconds();
    cpu_start_ = core::thread_cpu_seconds();
  }
  void step_tried(const forming::RunView& run, const forming::StepResult& result) override {
    const double cpu = core::thread_cpu_seconds() - cpu_start_, wall = core::wall_seconds() - wall_start_;
    table_ << run.state.time << ',' << result.converged << ',' << run.state.glass.mesh.cell_count() << ','
           << result.report.flow_solves << ',' << cpu;
    // The report's seconds are those of the wall clock: each part has its share of the CPU time.
    for (const char* part : {"flow", "heat", "contact"}) {
      const auto found = result.report.seconds.find(part);
      table_ << ',' << (found == result.report.seconds.end() ? 0 : found->second) * cpu / wall;
    }
    if (result.converged && seen_++ % every_ == 0)
      measure(run.scene, run.state, result);
    else
      table_ << ",nan,nan,nan,nan";
    table_ << std::endl;
  }

 private:
  void measure(const forming::Scene& scene, const forming::State& before, const forming::StepResult& result) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    double bare = none, once = none, split = none;
    if (scene.has_flow()) bare = bare_.seconds(scene, result.state);
    if (scene.has_flow() && scene.has_heat()) {
      const auto& interface = result.report.interface;
      const auto split_interface = copied(interface);
      once = split = std::numeric_limits<double>::infinity();
      for (int i = 0; i < repeats; ++i) {
        once = std::min(once, heat_seconds(scene, before, result, interface, once_[i]));
        split = std::min(split, heat_seconds(scene, before, result, split_interface, split_[i]));
      }
    }
    const double start = bench::cpu_seconds();
    if (scene.has_heat()) forming::surface_temperature_change(scene, before, result.state, result.report.interface);
    const double watched = bench::cpu_seconds() - start;
    table_ << ',' << bare << ',' << once << ',' << (split - once) / (copies - 1) << ',' << watched;
  }

  std::ofstream table_;
  int every_, seen_ = 0;
  double wall_start_ = 0, cpu_start_ = 0;
  bench::BareFlow bare_;
  std::array<forming::Workspace, repeats> once_, split_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "step_bench: CASE ACCURACY FOLDER EVERY\n");
    return 2;
  }
  tools::use_one_blas_thread();
  StepBench bench(std::string(argv[3]) + ".steps.csv", std::atoi(argv[4]));
  const auto scene = forming::read_scene(argv[1], argv[2]);
  const auto outcome = forming::run_in_folder(scene, argv[3], {&bench});
  if (!outcome.facts.completed) std::fprintf(stderr, "step_bench: %s\n", outcome.facts.reason.c_str());
  return outcome.facts.completed ? 0 : 1;
}
