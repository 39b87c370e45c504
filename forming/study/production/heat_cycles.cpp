// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/heat_cycles.hpp"

#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/math/numbers.hpp"
#include "forming/step/idle/idle_tools.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {

namespace {

Eigen::Map<Eigen::VectorXd> view(N_Vector vector) {
  return {N_VGetArrayPointer(vector), static_cast<Eigen::Index>(N_VGetLength(vector))};
}

/// What the callback of KINSOL works with.
struct Search {
  const VectorMap& map;
  const FixedPointOptions& options;
  FixedPointOutcome outcome;
  double least = std::numeric_limits<double>::infinity();  ///< change so far
  Eigen::VectorXd best = {};                               ///< value of the map that belongs to it
  bool again = false;                                      ///< whether KINSOL is to begin anew from there
};

/// The map at `at`. What is negative ends KINSOL: the tolerance is met, nothing more can be evaluated, or the
/// acceleration leads away: close to the end the changes it goes by are nearly parallel.
int evaluate(N_Vector at, N_Vector image, void* data) {
  constexpr int enough = -1;
  constexpr double away = 10;  // times the least change so far
  auto& search = *static_cast<Search*>(data);
  search.again = false;
  if (search.outcome.evaluations == search.options.max_evaluations) return enough;
  const Eigen::VectorXd x = view(at);
  auto value = search.map(x);
  if (!value) return enough;
  ++search.outcome.evaluations;
  view(image) = *value;
  search.outcome.change = search.options.size(*value - x);
  search.outcome.value = std::move(*value);
  search.outcome.converged = search.outcome.change <= search.options.tolerance;
  search.again = !search.outcome.converged && search.outcome.change > away * search.least;
  if (search.outcome.change < search.least) search.least = search.outcome.change, search.best = search.outcome.value;
  return search.outcome.converged || search.again ? enough : 0;
}

void say_nothing(int, const char*, const char*, char*, void*) {}

}  // namespace

FixedPointOutcome find_fixed_point(const Eigen::VectorXd& start, const VectorMap& map,
                                   const FixedPointOptions& options) {
  Search search{map, options, {}};
  search.outcome.value = start;
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  N_Vector x = N_VNew_Serial(start.size(), context), scale = N_VClone(x);
  view(x) = start;
  N_VConst(1, scale);
  void* solver = KINCreate(context);
  KINSetErrHandlerFn(solver, say_nothing, nullptr);
  KINSetMAA(solver, options.depth);
  KINSetDelayAA(solver, options.delay);
  KINSetNumMaxIters(solver, options.max_evaluations + 1);
  KINInit(solver, evaluate, x);
  KINSetUserData(solver, &search);
  KINSetFuncNormTol(solver, std::numeric_limits<double>::min());  // the callback says when it is enough
  KINSol(solver, x, KIN_FP, scale, scale);
  while (search.again) {
    view(x) = search.best;
    KINSol(solver, x, KIN_FP, scale, scale);
  }
  KINFree(&solver);
  N_VDestroy(scale);
  N_VDestroy(x);
  SUNContext_Free(&context);
  return std::move(search.outcome);
}

HeatCycles::HeatCycles(const Scene& scene, const MachineCycle& cycle, const State& initial)
    : scene_(scene),
      cycle_(cycle),
      tools_(tools_of(initial)),
      use_ends_(scene.tools.size(), core::infinity),
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
    if (now == stage_end) stage_end = state.stage == last ? core::infinity : now + scene_.stages[state.stage].duration;
    double next = core::infinity;
    for (const std::vector<double>* moments : {&ends, &use_ends_})
      for (const double moment : *moments)
        if (moment > now) next = std::min(next, moment);
    if (next == core::infinity) return tool_temperatures(ended);
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
    use_ends_[t] = run.used[t] > 0 ? std::min(ends[t] - cycle_.seconds_of(t) + run.used[t], ends[t]) : core::infinity;
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
