// SPDX-License-Identifier: GPL-3.0-or-later
// classical_contact CASE OUTPUT: runs a case of standing bodies as `parison run --accuracy standard` does, the
// interface element replaced by the classical coupling. For comparison only.
#include <fmt/core.h>

#include "classical/classical_interface.hpp"
#include "core/case/case_error.hpp"
#include "core/process/run_error.hpp"
#include "forming/report/files/history.hpp"
#include "forming/report/files/interface_rows.hpp"
#include "forming/report/files/result_files.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "forming/step/step_control.hpp"
#include "tools/program/blas_threads.hpp"

namespace {

using namespace parison;
using namespace parison::forming;

std::vector<core::InterfacePoint> couple(const Scene& scene, const State& state) {
  const auto surface = [&](Index body) {
    const auto& mesh = mesh_of(state, body);
    return contact::make_surface(body, mesh, core::boundaries_of_kind(mesh, BoundaryKind::contact),
                                 core::Point::Zero());
  };
  return classical::classical_interface(surface(0), surface(1), scene.geometry);
}

/// Steps through the first stage; false where the heat solver gave up.
bool run_stage(const Scene& scene, const std::string& directory) {
  ResultFiles files(scene, directory);
  State state = initial_state(scene);
  const std::vector<ToolSurface> surfaces = tool_surfaces(scene, state);
  Workspace workspace;
  StepReport report;
  report.interface = couple(scene, state);
  state.next_step = scene.accuracy.initial_step;
  files.fields(state, report.interface);
  while (stage_end(scene, state) == StageEnd::none) {
    report.dt = clip_step_to_event(scene, state, state.next_step);
    const auto heat = advance_heat(scene, state, report.interface, {}, report.dt, workspace);
    if (!heat.converged) return false;
    const double before = state.time;
    state.time += report.dt;
    state.stage_time += report.dt;
    state.next_step = propose_step(scene, state, report, state.next_step).dt;
    files.row(history_row(scene, state, report), tool_line(scene, state, surfaces));
    if (!outputs_due(scene, state.stage, before, state.time).empty()) files.fields(state, report.interface);
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: classical_contact CASE OUTPUT\n");
    return 2;
  }
  tools::use_one_blas_thread();
  try {
    const Scene scene = read_scene(argv[1], "standard");
    if (scene.has_flow() || scene.tools.size() != 1 || scene.stages.size() != 1 || !scene.has_heat())
      throw core::CaseError(fmt::format("{}: allowed is a case of two standing bodies and one stage", argv[1]));
    return run_stage(scene, argv[2]) ? 0 : 1;
  } catch (const core::CaseError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  } catch (const core::RunError& error) {
    fmt::print(stderr, "classical_contact: {}\n", error.what());
    return 1;
  }
}
