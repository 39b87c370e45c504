// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/interpolate.hpp"

#include <cassert>

namespace parison::forming {

State interpolate(const State& before, const State& after, double time) {
  const double fraction = (time - before.time) / (after.time - before.time);
  const auto mixed = [&](const auto& first, const auto& last) { return first + fraction * (last - first); };
  State state = after;
  state.time = time;
  state.stage_time = mixed(before.stage_time, after.stage_time);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const BodyState& first = before.bodies[b];
    BodyState& body = state.bodies[b];
    assert(first.mesh.nodes.size() == body.mesh.nodes.size());
    body.offset = mixed(first.offset, body.offset);
    body.temperature = mixed(first.temperature, body.temperature).eval();
    for (std::size_t n = 0; n < body.mesh.nodes.size(); ++n)
      body.mesh.nodes[n] = mixed(first.mesh.nodes[n], body.mesh.nodes[n]);
  }
  for (std::size_t p = 0; p < state.probes.size(); ++p) state.probes[p] = mixed(before.probes[p], after.probes[p]);
  return state;
}

}  // namespace parison::forming
