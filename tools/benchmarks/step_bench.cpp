// SPDX-License-Identifier: GPL-3.0-or-later
// step_bench CASE ACCURACY FOLDER EVERY: runs a case and writes FOLDER.steps.csv, CPU seconds of each step and its
// parts. At every EVERY-th step also a bare factorisation, the heat of the step with its interface and with copies of
// it, and what the step's control reads from the interface.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "core/linear/blas_threads.hpp"
#include "forming/run/run.hpp"
#include "forming/step/heat_step.hpp"
#include "forming/step/step.hpp"
#include "forming/step/surface_temperature.hpp"
#include "tools/benchmarks/bare_flow.hpp"

namespace parison::forming {

#define COUPLED_STEP "_ZN7parison7forming12coupled_stepERKNS0_5SceneERKNS0_5StateEdRNS0_9WorkspaceE"
StepResult real_step(const Scene&, const State&, double, Workspace&) __asm__("__real_" COUPLED_STEP);
StepResult timed_step(const Scene&, const State&, double, Workspace&) __asm__("__wrap_" COUPLED_STEP);

}  // namespace parison::forming

namespace {

using namespace parison;

/// Interfaces, each with its share of the area, that replace the step's own to see what one costs.
constexpr int copies = 5;
/// Times that the heat is measured with the one and with the copies, in turn; the least counts, for what else runs
/// here.
constexpr int repeats = 5;

struct Bench {
  std::ofstream table;
  int every = 1, seen = 0;
  bench::BareFlow bare;
  std::array<forming::Workspace, repeats> once, split;
} record;

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
  for (std::size_t b = 0; b < state.bodies.size(); ++b) state.bodies[b].temperature = before.bodies[b].temperature;
  state.heat_substep = before.heat_substep;
  state.heat_couplings = before.heat_couplings;
  workspace.heat.factored_step = 0;  // as at the start of a step
  const double start = bench::cpu_seconds();
  forming::advance_heat(scene, state, interface, {}, result.report.dt, workspace);
  return bench::cpu_seconds() - start;
}

void measure(const forming::Scene& scene, const forming::State& before, const forming::StepResult& result) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  double bare = none, once = none, split = none;
  if (scene.has_flow()) bare = record.bare.seconds(scene, result.state);
  if (scene.has_flow() && scene.has_heat()) {
    const auto& interface = result.report.interface;
    const auto split_interface = copied(interface);
    once = split = std::numeric_limits<double>::infinity();
    for (int i = 0; i < repeats; ++i) {
      once = std::min(once, heat_seconds(scene, before, result, interface, record.once[i]));
      split = std::min(split, heat_seconds(scene, before, result, split_interface, record.split[i]));
    }
  }
  const double start = bench::cpu_seconds();
  if (scene.has_heat()) forming::surface_temperature_change(scene, before, result.state, result.report.interface);
  const double watched = bench::cpu_seconds() - start;
  record.table << ',' << bare << ',' << once << ',' << (split - once) / (copies - 1) << ',' << watched;
}

}  // namespace

forming::StepResult forming::timed_step(const Scene& scene, const State& state, double dt, Workspace& workspace) {
  using Clock = std::chrono::steady_clock;
  const auto wall_start = Clock::now();
  const double start = bench::cpu_seconds();
  StepResult result = real_step(scene, state, dt, workspace);
  const double cpu = bench::cpu_seconds() - start;
  const double wall = std::chrono::duration<double>(Clock::now() - wall_start).count();
  record.table << state.time << ',' << result.converged << ',' << state.glass.mesh.cell_count() << ','
               << result.report.flow_solves << ',' << cpu;
  // The report's seconds are those of the wall clock: each part has its share of the CPU time.
  for (const char* part : {"flow", "heat", "contact"}) record.table << ',' << result.report.seconds[part] * cpu / wall;
  if (result.converged && record.seen++ % record.every == 0)
    measure(scene, state, result);
  else
    record.table << ",nan,nan,nan,nan";
  record.table << std::endl;
  return result;
}

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "step_bench: CASE ACCURACY FOLDER EVERY\n");
    return 2;
  }
  core::use_one_blas_thread();
  record.every = std::atoi(argv[4]);
  record.table.open(std::string(argv[3]) + ".steps.csv");
  record.table
      << "time,converged,triangles,iterations,step,flow,heat,contact,bare,heat_again,interface_in_heat,watched\n";
  const auto scene = forming::read_scene(argv[1], argv[2]);
  const auto outcome = forming::run(scene, argv[3]);
  if (!outcome.facts.completed) std::fprintf(stderr, "step_bench: %s\n", outcome.facts.reason.c_str());
  return outcome.facts.completed ? 0 : 1;
}
