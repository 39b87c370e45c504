// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/swabbing.hpp"

#include <algorithm>
#include <cmath>

#include "forming/step/idle/swabbed_tool.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {
namespace {

/// Cycles from one swab to the next; 0 for a tool without.
int period(const SwabImprint& imprint, Eigen::Index node) {
  return imprint.share[node] > 0 ? static_cast<int>(std::lround(1 / imprint.share[node])) : 0;
}

int longest_period(const SwabImprint& imprint) {
  int longest = 0;
  for (Eigen::Index node = 0; node < imprint.share.size(); ++node) longest = std::max(longest, period(imprint, node));
  return longest;
}

}  // namespace

SwabImprint swab_imprint(const Scene& scene, const State& initial) {
  const Eigen::Index nodes = tool_temperatures(initial).size();
  SwabImprint imprint{Eigen::VectorXd::Zero(nodes), Eigen::VectorXd::Zero(nodes),
                      std::vector<double>(scene.tools.size(), 0), ""};
  Eigen::Index first = 0;
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const Eigen::Index size = initial.tools[t].temperature.size();
    if (scene.tools[t].swab && size > 0) {
      const SwabbedTool swabbed = swabbed_tool(scene, initial, static_cast<Index>(t));
      if (!swabbed.failure.empty()) imprint.failure = "the swab of " + scene.tools[t].name + ": " + swabbed.failure;
      imprint.heat[t] = swabbed.heat;
      imprint.change.segment(first, size) = swabbed.temperature.array() - scene.tools[t].initial_temperature;
      imprint.share.segment(first, size).setConstant(1.0 / scene.tools[t].swab->every);
    }
    first += size;
  }
  return imprint;
}

std::vector<Eigen::VectorXd> since_swab(const SwabImprint& imprint, const Eigen::VectorXd& settled,
                                        const CycleMap& next, double tolerance) {
  constexpr int most = 2000;
  const auto fixed = next(settled);
  if (!fixed) return {};
  // One swab alone, k cycles after it; its trace in the mean of production is what all that came before have left.
  std::vector<Eigen::VectorXd> traces{imprint.change};
  while (traces.back().lpNorm<Eigen::Infinity>() > 0.02 * tolerance && static_cast<int>(traces.size()) < most) {
    const auto later = next(settled + traces.back());
    if (!later) return {};
    traces.push_back(*later - *fixed);
  }
  const auto count = static_cast<int>(traces.size());
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(settled.size());
  for (const Eigen::VectorXd& trace : traces) mean += trace.cwiseProduct(imprint.share);
  std::vector<Eigen::VectorXd> found;
  for (int k = 0; k < longest_period(imprint); ++k) {
    Eigen::VectorXd temperatures = settled - mean;
    for (Eigen::Index node = 0; node < settled.size(); ++node)
      if (const int every = period(imprint, node); every > 0)
        for (int m = k % every; m < count; m += every) temperatures[node] += traces[m][node];
    found.push_back(std::move(temperatures));
  }
  return found;
}

}  // namespace parison::forming
