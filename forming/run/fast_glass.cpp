// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/fast_glass.hpp"

#include <fmt/format.h>

namespace parison::forming {

namespace {

/// `dim` velocities of each node.
template <int dim, typename Nodes>
std::optional<FastGlass> fastest_of(const Nodes& nodes, const Eigen::VectorXd& velocity) {
  constexpr double fastest_forming = 20;  // m/s
  Index fastest = -1;
  double speed = fastest_forming;
  for (Index n = 0; n < velocity.size() / dim; ++n)
    if (const double own = velocity.segment<dim>(dim * n).norm(); own >= speed) fastest = n, speed = own;
  if (fastest < 0) return {};
  std::vector<std::string> at;
  for (int d = 0; d < dim; ++d) at.push_back(fmt::format("{:.1f}", 1e3 * nodes[fastest][d]));
  return FastGlass{fmt::format("({})", fmt::join(at, ", ")), speed};
}

}  // namespace

std::optional<FastGlass> fast_glass(const State& state) {
  return fastest_of<2>(state.glass.mesh.nodes, state.glass.velocity);
}
std::optional<FastGlass> fast_glass(const SolidState& solid) {
  return fastest_of<3>(solid.glass.mesh.nodes, solid.glass.velocity);
}

std::string falls(const FastGlass& glass) {
  return fmt::format(
      "the glass stretches under its weight alone until it falls, near {} mm at {:.0f} m/s, where no pressure acts: a "
      "shorter time before something holds or shapes it, colder glass, or a tool that carries it keeps it together",
      glass.at, glass.speed);
}

std::string bursts(const FastGlass& glass) {
  return fmt::format(
      "a film of glass bursts near {} mm, where it moves at {:.0f} m/s: less pressure, or glass that is thicker or "
      "colder there, may keep it whole",
      glass.at, glass.speed);
}

}  // namespace parison::forming
