// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/idle/idle_tools.hpp"

#include "forming/step/heat/heat_step.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::forming {

namespace {

/// Adds the heat that left the tools through their boundaries.
void accumulate(const thermal::HeatBalance& balance, State& state) {
  for (std::size_t t = 0; t < state.tools.size(); ++t) {
    auto& through = state.tools[t].heat_through;
    const auto first = static_cast<std::size_t>(balance.first_boundary[t]);
    for (std::size_t i = 0; i < through.size(); ++i) through[i] += balance.through_boundary[first + i];
  }
}

}  // namespace

std::string idle_tools(const Scene& scene, State& state, double dt) {
  if (dt <= 0 || state.tools.empty()) return "";
  thermal::Problem problem{scene.geometry, {}, {}, {}};
  std::vector<Eigen::VectorXd> temperature;
  for (std::size_t t = 0; t < state.tools.size(); ++t) {
    problem.bodies.push_back(body_view(scene, state, body_of_tool(static_cast<Index>(t)), state.tools[t].mesh));
    temperature.push_back(state.tools[t].temperature);
  }
  thermal::StepMatrix matrix;
  auto outcome = thermal::advance(problem, state.time, temperature, dt, heat_options(scene), matrix);
  if (!outcome.converged) return outcome.reason;
  for (std::size_t t = 0; t < state.tools.size(); ++t)
    if (!is_waiting(scene, state.stage, static_cast<Index>(t)))
      state.tools[t].temperature = std::move(outcome.temperature[t]);
  accumulate(outcome.balance, state);
  state.time += dt;
  return "";
}

}  // namespace parison::forming
