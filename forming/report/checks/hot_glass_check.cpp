// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "forming/diagnostics/temperature_bounds.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/step/balance/work.hpp"

namespace parison::forming {

std::string hot_glass_text(const Scene& scene, const HotGlass& hottest) {
  if (!(hottest.above > told_excess)) return "";
  return fmt::format(
      "{:.0f} K above all that heats it, in {} at {:.4g} s, (r, z) = ({:.1f}, {:.1f}) mm; {:.2g} % of it more than "
      "{:g} K",
      hottest.above, scene.stages[hottest.stage].name, hottest.time, 1e3 * hottest.r, 1e3 * hottest.z,
      100 * hottest.volume_share, told_excess);
}

void add_hot_glass_check(const Scene& scene, const State& state, const HotGlass& hot, Checks& checks) {
  const double work = std::max(state.totals.work.dissipation, least_loss(scene, state));
  const std::string where = hot_glass_text(scene, hot);
  checks.push_back(
      {"hot_glass", hot.work != 0 ? hot.work / work : 0, 0.01, 0.1, "%",
       fmt::format("glass beside a chilled skin thinner than its cells was hotter than all that can heat it, and "
                   "forces are too low by about this{}; a smaller numerics.skin_size helps",
                   where.empty() ? "" : ": up to " + where),
       CheckKind::error});
}

}  // namespace parison::forming
