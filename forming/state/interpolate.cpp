// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/interpolate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>

namespace parison::forming {

double carried_on(double then, double now, double share) {
  constexpr double jump = 1;  // change between both, of the smaller one
  if (then == 0 || std::abs(now - then) >= jump * std::min(std::abs(now), std::abs(then))) return now;
  return now * std::pow(now / then, share);
}

namespace {

/// Sets the fields of the glass that are known in the middle of steps to their values at `time`.
void carry_fields(const State& before, const State& after, double time, State& state) {
  if (!known_at_both(before, after)) return;
  const double dt = after.time - before.time;
  const double share = (time - after.time + 0.5 * dt) / (0.5 * (dt + before.last_step));
  for_each_glass_field([&](const auto& field) {
    if constexpr (std::is_same_v<typename std::decay_t<decltype(field)>::Values, Eigen::VectorXd>)
      if (field.within_step == WithinStep::of_middle)
        state.glass.*field.values =
            (before.glass.*field.values).binaryExpr(after.glass.*field.values, [&](double then, double now) {
              return carried_on(then, now, share);
            });
  });
}

}  // namespace

State interpolate(const State& before, const State& after, double time) {
  State state = after;
  carry_fields(before, after, time, state);
  if (time == after.time) return state;
  const double fraction = (time - before.time) / (after.time - before.time);
  const auto mixed = [&](const auto& first, const auto& last) { return first + fraction * (last - first); };
  state.time = time;
  state.stage_time = mixed(before.stage_time, after.stage_time);
  assert(before.glass.mesh.shares_topology(after.glass.mesh));
  for (std::size_t n = 0; n < state.glass.mesh.nodes.size(); ++n)
    state.glass.mesh.nodes[n] = mixed(before.glass.mesh.nodes[n], after.glass.mesh.nodes[n]);
  for_each_glass_field([&](const auto& field) {
    if constexpr (std::is_same_v<typename std::decay_t<decltype(field)>::Values, Eigen::VectorXd>)
      if (field.within_step == WithinStep::linear)
        state.glass.*field.values = mixed(before.glass.*field.values, after.glass.*field.values).eval();
  });
  for (std::size_t t = 0; t < state.tools.size(); ++t) {
    state.tools[t].offset = mixed(before.tools[t].offset, after.tools[t].offset);
    state.tools[t].temperature = mixed(before.tools[t].temperature, after.tools[t].temperature).eval();
  }
  for (std::size_t p = 0; p < state.probes.size(); ++p) state.probes[p] = mixed(before.probes[p], after.probes[p]);
  return state;
}

}  // namespace parison::forming
