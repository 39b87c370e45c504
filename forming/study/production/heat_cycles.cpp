// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/heat_cycles.hpp"

#include <algorithm>

#include "forming/step/idle/idle_tools.hpp"
#include "forming/study/production/fixed_point.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {

HeatCycles::HeatCycles(const Scene& scene, const MachineCycle& cycle, const State& initial)
    : scene_(scene), cycle_(cycle), tools_(tools_of(initial)) {}

std::optional<Eigen::VectorXd> HeatCycles::without_glass(const Eigen::VectorXd& temperatures) const {
  State state = tools_;
  set_tool_temperatures(temperatures, state);
  const auto last = static_cast<Index>(scene_.stages.size()) - 1;
  for (state.stage = 0;; ++state.stage) {
    state.stage_start = state.time;
    const double rest = cycle_.seconds - state.time;
    const double duration = state.stage == last ? rest : std::min(rest, scene_.stages[state.stage].duration);
    if (duration > 0 && !idle_tools(scene_, state, duration).empty()) return std::nullopt;
    if (state.stage == last) return tool_temperatures(state);
  }
}

bool HeatCycles::learn(const CycleRun& run) {
  const auto alone = without_glass(run.start);
  if (!alone) return false;
  imprint_ = run.end - *alone;
  start_ = run.start;
  met_ = run.met;
  return true;
}

std::optional<Eigen::VectorXd> HeatCycles::next(const Eigen::VectorXd& temperatures) const {
  auto after = without_glass(temperatures);
  if (!after) return after;
  Eigen::Index node = 0;
  for (std::size_t t = 0; t < tools_.tools.size(); ++t)
    for (const Eigen::Index end = node + tools_.tools[t].temperature.size(); node < end; ++node) {
      const double excess = met_[t] - start_[node];
      (*after)[node] += imprint_[node] * (excess > 0 ? (met_[t] - temperatures[node]) / excess : 1);
    }
  return after;
}

std::optional<Eigen::VectorXd> HeatCycles::settled(const Eigen::VectorXd& start, double tolerance) const {
  constexpr int depth = 5, most = 200;
  const FixedPointOptions options{tolerance, depth, most,
                                  [](const Eigen::VectorXd& change) { return change.lpNorm<Eigen::Infinity>(); }};
  auto found = find_fixed_point(
      start, [this](const Eigen::VectorXd& x) { return next(x); }, options);
  if (!found.converged) return std::nullopt;
  return std::move(found.value);
}

}  // namespace parison::forming
