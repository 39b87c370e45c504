// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/heat_cycles.hpp"

#include <algorithm>
#include <limits>

#include "forming/step/idle/idle_tools.hpp"
#include "forming/study/production/fixed_point.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {

HeatCycles::HeatCycles(const Scene& scene, const MachineCycle& cycle, const State& initial)
    : scene_(scene), cycle_(cycle), tools_(tools_of(initial)) {}

std::vector<double> HeatCycles::tool_ends() const {
  std::vector<double> ends;
  for (std::size_t t = 0; t < scene_.tools.size(); ++t)
    ends.push_back(cycle_.seconds_of(t) + (scene_.tools[t].waits ? cycle_.uses[t].begin : 0));
  return ends;
}

std::optional<Eigen::VectorXd> HeatCycles::without_glass(const Eigen::VectorXd& temperatures) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  State state = tools_, ended = tools_;
  set_tool_temperatures(temperatures, state);
  const auto last = static_cast<Index>(scene_.stages.size()) - 1;
  const std::vector<double> ends = tool_ends();
  for (double stage_end = 0, now = 0;; now = state.time) {
    if (now == stage_end && now > 0) ++state.stage, state.stage_start = now;
    if (now == stage_end) stage_end = state.stage == last ? never : now + scene_.stages[state.stage].duration;
    double next = never;
    for (const double end : ends)
      if (end > now) next = std::min(next, end);
    if (next == never) return tool_temperatures(ended);
    next = std::min(next, stage_end);
    if (!idle_tools(scene_, state, next - now).empty()) return std::nullopt;
    state.time = next;
    for (std::size_t t = 0; t < ends.size(); ++t)
      if (ends[t] == next) ended.tools[t].temperature = state.tools[t].temperature;
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

bool HeatCycles::hold(const Eigen::VectorXd& temperatures) {
  const auto alone = without_glass(temperatures);
  if (!alone) return false;
  imprint_ = temperatures - *alone;
  start_ = temperatures;
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
  const FixedPointOptions options{tolerance, depth, 0, most,
                                  [](const Eigen::VectorXd& change) { return change.lpNorm<Eigen::Infinity>(); }};
  auto found = find_fixed_point(
      start, [this](const Eigen::VectorXd& x) { return next(x); }, options);
  if (!found.converged) return std::nullopt;
  return std::move(found.value);
}

}  // namespace parison::forming
