// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/interpolate.hpp"

#include <cassert>
#include <type_traits>

namespace parison::forming {

State interpolate(const State& before, const State& after, double time) {
  const double fraction = (time - before.time) / (after.time - before.time);
  const auto mixed = [&](const auto& first, const auto& last) { return first + fraction * (last - first); };
  State state = after;
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
