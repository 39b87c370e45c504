// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/heat_cycles.hpp"

#include <algorithm>
#include <limits>

#include "forming/step/idle/idle_tools.hpp"
#include "forming/study/production/fixed_point.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

HeatCycles::HeatCycles(const Scene& scene, const MachineCycle& cycle, const State& initial)
    : scene_(scene),
      cycle_(cycle),
      tools_(tools_of(initial)),
      use_ends_(scene.tools.size(), never),
      kept_(scene.tools.size()),
      given_(scene.tools.size()) {}

std::vector<double> HeatCycles::tool_ends() const {
  std::vector<double> ends;
  for (std::size_t t = 0; t < scene_.tools.size(); ++t)
    ends.push_back(cycle_.seconds_of(t) + (scene_.tools[t].waits ? cycle_.uses[t].begin : 0));
  return ends;
}

std::optional<Eigen::VectorXd> HeatCycles::cycle_with(const Eigen::VectorXd& temperatures, const Use& use) const {
  State state = tools_, ended = tools_;
  set_tool_temperatures(temperatures, state);
  const auto last = static_cast<Index>(scene_.stages.size()) - 1;
  const std::vector<double> ends = tool_ends();
  for (double stage_end = 0, now = 0;; now = state.time) {
    if (now == stage_end && now > 0) ++state.stage, state.stage_start = now;
    if (now == stage_end) stage_end = state.stage == last ? never : now + scene_.stages[state.stage].duration;
    double next = never;
    for (const std::vector<double>* moments : {&ends, &use_ends_})
      for (const double moment : *moments)
        if (moment > now) next = std::min(next, moment);
    if (next == never) return tool_temperatures(ended);
    next = std::min(next, stage_end);
    if (!idle_tools(scene_, state, next - now).empty()) return std::nullopt;
    state.time = next;
    for (std::size_t t = 0; t < ends.size(); ++t) {
      if (use_ends_[t] == next) use(t, state.tools[t].temperature);
      if (ends[t] == next) ended.tools[t].temperature = state.tools[t].temperature;
    }
  }
}

bool HeatCycles::learn(const CycleRun& run) {
  const std::vector<double> ends = tool_ends();
  State left = tools_;
  set_tool_temperatures(run.left, left);
  for (std::size_t t = 0; t < ends.size(); ++t) {
    use_ends_[t] = run.used[t] > 0 ? std::min(ends[t] - cycle_.seconds_of(t) + run.used[t], ends[t]) : never;
    kept_[t].setOnes(left.tools[t].temperature.size());
    given_[t].setZero(kept_[t].size());
  }
  const Use learn_use = [&](std::size_t t, Eigen::VectorXd& temperature) {
    for (Eigen::Index node = 0; node < temperature.size(); ++node) {
      const double with_glass = left.tools[t].temperature[node], warmed = with_glass - temperature[node],
                   glass = std::max(run.met[t], with_glass);
      const double share = warmed > 0 ? warmed / (glass - temperature[node]) : 0;
      kept_[t][node] = 1 - share;
      given_[t][node] = share > 0 ? share * glass : warmed;
    }
    temperature = left.tools[t].temperature;
  };
  const auto end = cycle_with(run.start, learn_use);
  if (end) rest_ = run.end - *end;
  return end.has_value();
}

bool HeatCycles::hold(const Eigen::VectorXd& temperatures) {
  const auto after = next(temperatures);
  if (after) rest_ += temperatures - *after;
  return after.has_value();
}

std::optional<Eigen::VectorXd> HeatCycles::next(const Eigen::VectorXd& temperatures) const {
  auto after = cycle_with(temperatures, [this](std::size_t t, Eigen::VectorXd& temperature) {
    temperature = kept_[t].cwiseProduct(temperature) + given_[t];
  });
  if (after) *after += rest_;
  return after;
}

std::optional<Eigen::VectorXd> HeatCycles::settled(const Eigen::VectorXd& start, double tolerance) const {
  constexpr int depth = 5, most = 200, patience = 15;
  constexpr double scatter = 0.05;  // K: the steps of the tools alone, chosen anew each cycle, change one by less
  double least = std::numeric_limits<double>::infinity();
  int since_least = 0;
  const auto size = [&](const Eigen::VectorXd& difference) {
    const double change = difference.lpNorm<Eigen::Infinity>();
    since_least = change < least ? 0 : since_least + 1;
    least = std::min(least, change);
    const bool only_scatters = since_least >= patience && change <= scatter;
    return only_scatters ? 0 : change;
  };
  auto found =
      find_fixed_point(start, [this](const Eigen::VectorXd& x) { return next(x); }, {tolerance, depth, 0, most, size});
  if (!found.converged) return std::nullopt;
  return std::move(found.value);
}

}  // namespace parison::forming
