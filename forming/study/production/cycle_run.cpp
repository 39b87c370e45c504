// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/cycle_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/math/numbers.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/sample.hpp"
#include "forming/step/idle/idle_tools.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {

namespace {

bool is_start_of(const Tool& tool, const std::string& key) {
  const std::string temperature = fmt::format("tool.{}.temperature", tool.name);
  return key == temperature || key.rfind(temperature + '.', 0) == 0;
}

}  // namespace

std::vector<std::string> lost_changes(const Scene& scene, const std::vector<CaseDifference>& settings) {
  std::vector<std::string> keys;
  for (const CaseDifference& setting : settings)
    if (std::any_of(scene.tools.begin(), scene.tools.end(),
                    [&](const Tool& tool) { return is_start_of(tool, setting.key); }))
      keys.push_back(setting.key);
  return keys;
}

std::string what_settled_tools_depend_on(const std::string& key) {
  const std::string tool = key.substr(0, key.find(".temperature"));
  return fmt::format(
      "changes of what heats and cools a tool, such as {0}.boundary.NAME.condition, {0}.swab, air, the glass or the "
      "stages; --cycle-time and --sets hold for all variants, and another of these is a cycle in an --output of its "
      "own",
      tool);
}

namespace {

/// A tool at the end of its cycle, or at any other moment.
struct ToolEnd {
  Eigen::VectorXd temperature;
  CycleHeat heat;
};

/// Linear between two moments.
ToolEnd between(const ToolState& before, const ToolState& after, double share) {
  ToolEnd end{(1 - share) * before.temperature + share * after.temperature, {0, before.heat_through}};
  const auto mean = [&](double a, double b) { return (1 - share) * a + share * b; };
  end.heat.received = mean(before.heat_received, after.heat_received);
  for (std::size_t i = 0; i < end.heat.through.size(); ++i)
    end.heat.through[i] = mean(end.heat.through[i], after.heat_through[i]);
  return end;
}

/// Follows the tools through the forming and the idle rest of their cycles.
class CycleObserver : public RunObserver {
 public:
  CycleObserver(const Scene& scene, const MachineCycle& cycle)
      : scene_(scene),
        cycle_(cycle),
        used(scene.tools.size(), 0),
        ends(scene.tools.size(), core::infinity),
        ended(scene.tools.size()) {}

  void run_begins(const RunView& view) override {
    for (const ToolState& tool : view.state.tools) surfaces_.emplace_back(tool.mesh, scene_.geometry);
    start = tool_temperatures(view.state);
    left = tools_of(view.state);
    met.assign(view.state.tools.size(), view.state.glass.temperature.mean());
    for (std::size_t t = 0; t < ends.size(); ++t)
      if (!scene_.tools[t].waits) ends[t] = cycle_.seconds_of(t);
  }
  void stage_begins(const RunView& view) override {
    for (const StageTool& one : scene_.stages[view.state.stage].tools) {
      if (std::exchange(begun_[one.tool], true)) continue;
      met[one.tool] = view.state.glass.temperature.mean();
      if (scene_.tools[one.tool].waits)
        ends[one.tool] = view.state.time + cycle_.seconds_of(static_cast<std::size_t>(one.tool));
    }
  }
  void stage_ends(const RunView& view) override {
    for (const StageTool& one : scene_.stages[view.state.stage].tools) {
      const auto t = static_cast<std::size_t>(one.tool);
      used[t] = view.state.time - (ends[t] - cycle_.seconds_of(t));
      left.tools[t].temperature = view.state.tools[t].temperature;
    }
  }
  void step_taken(const RunView& view, const State& before, const StepReport&) override {
    update_ends(before, view.state);
  }
  void fields_due(const RunView&, const State& at) override {
    if (samples.empty() || at.time > samples.back().time) add_sample(at, scene_.stages[at.stage].name);
  }

  /// Keeps the tools whose cycles end after one moment and not after another.
  void update_ends(const State& before, const State& after) {
    const double dt = after.time - before.time;
    for (std::size_t t = 0; t < ends.size(); ++t)
      if (!ended[t] && before.time < ends[t] && after.time >= ends[t])
        ended[t] = between(before.tools[t], after.tools[t], (ends[t] - before.time) / dt);
  }

  /// The time at which the cycle of the next tool ends; infinity where all have.
  double next_end() const {
    double next = core::infinity;
    for (std::size_t t = 0; t < ends.size(); ++t)
      if (!ended[t]) next = std::min(next, ends[t]);
    return next;
  }

  void add_sample(const State& state, const std::string& stage) {
    CycleSample sample{state.time, stage, {}, {}};
    for (std::size_t t = 0; t < state.tools.size(); ++t)
      sample.tools.push_back(surfaces_[t].temperatures(state.tools[t], core::infinity));
    for (std::size_t p = 0; p < scene_.probes.size(); ++p) {
      const Index body = scene_.probes[p].body;
      sample.probes.push_back(
          body == glass_body ? std::numeric_limits<double>::quiet_NaN()
                             : forming::sample(mesh_of(state, body), temperature_of(state, body), state.probes[p]));
    }
    samples.push_back(std::move(sample));
  }

 private:
  const Scene& scene_;
  const MachineCycle& cycle_;
  std::vector<ToolSurface> surfaces_;
  std::map<Index, bool> begun_;

 public:
  Eigen::VectorXd start;
  std::vector<double> met;
  std::vector<double> used;                   ///< as in CycleRun
  State left;                                 ///< the tools at the end of their use
  std::vector<double> ends;                   ///< of the cycles of the tools, s since the start of the container
  std::vector<std::optional<ToolEnd>> ended;  ///< by tool
  std::vector<CycleSample> samples;
};

/// The tools alone until their cycles have ended.
std::string idle_rest(const Scene& scene, State& tools, CycleObserver& observer) {
  for (double end = observer.next_end(); end < core::infinity; end = observer.next_end()) {
    const State before = tools;
    const double rest = end - tools.time;
    const bool last = rest <= scene.output.interval * (1 + 1e-9);
    if (const std::string failure = idle_tools(scene, tools, last ? rest : scene.output.interval); !failure.empty())
      return "idle tools: " + failure;
    if (last) tools.time = end;
    observer.update_ends(before, tools);
    observer.add_sample(tools, "idle");
  }
  return "";
}

/// Linear between two samples.
CycleSample between(const CycleSample& before, const CycleSample& after, double time) {
  const double share = (time - before.time) / (after.time - before.time);
  const auto mean = [&](double a, double b) { return a + share * (b - a); };
  CycleSample sample = after;
  sample.time = time;
  for (std::size_t t = 0; t < sample.tools.size(); ++t) {
    ToolTemperatures& tool = sample.tools[t];
    tool.mean = mean(before.tools[t].mean, tool.mean);
    tool.surface_mean = mean(before.tools[t].surface_mean, tool.surface_mean);
    tool.surface_max = mean(before.tools[t].surface_max, tool.surface_max);
  }
  for (std::size_t p = 0; p < sample.probes.size(); ++p) sample.probes[p] = mean(before.probes[p], sample.probes[p]);
  return sample;
}

/// At a time up to that of the last sample.
CycleSample at_time(const std::vector<CycleSample>& samples, double time) {
  auto after = std::lower_bound(samples.begin(), samples.end(), time,
                                [](const CycleSample& one, double t) { return one.time < t; });
  if (after == samples.end()) after = samples.end() - 1;
  return after == samples.begin() || after->time == time ? *after : between(*(after - 1), *after, time);
}

/// The samples of one machine cycle: before its first use, a tool that overlaps is as it is a cycle later.
std::vector<CycleSample> one_cycle(const Scene& scene, const MachineCycle& cycle, const CycleObserver& observer) {
  std::vector<CycleSample> samples;
  for (const CycleSample& sample : observer.samples)
    if (sample.time <= cycle.seconds) samples.push_back(sample);
  if (samples.back().time < cycle.seconds) samples.push_back(at_time(observer.samples, cycle.seconds));
  for (std::size_t t = 0; t < scene.tools.size(); ++t)
    for (CycleSample& sample : samples) {
      if (!scene.tools[t].waits || sample.time + cycle.seconds_of(t) > observer.ends[t]) continue;
      const CycleSample later = at_time(observer.samples, sample.time + cycle.seconds_of(t));
      sample.tools[t] = later.tools[t];
      for (std::size_t p = 0; p < scene.probes.size(); ++p)
        if (scene.probes[p].body == body_of_tool(static_cast<Index>(t))) sample.probes[p] = later.probes[p];
    }
  return samples;
}

}  // namespace

CycleRun run_cycle(const Scene& scene, const MachineCycle& cycle, const std::string& directory,
                   const StopRequest& stop) {
  CycleObserver observer(scene, cycle);
  CycleRun result;
  result.forming =
      directory.empty() ? run(scene, {&observer}, stop) : run_in_folder(scene, directory, {&observer}, stop);
  if (!directory.empty()) write_summary(directory, scene, result.forming);
  result.stopped = result.forming.facts.stopped;
  result.failure = result.forming.facts.completed ? "" : result.forming.facts.reason;
  result.start = observer.start;
  result.met = observer.met;
  result.used = observer.used;
  result.left = tool_temperatures(observer.left);
  if (!result.failure.empty()) return result;
  State tools = tools_of(result.forming.state);
  result.failure = idle_rest(scene, tools, observer);
  if (!result.failure.empty()) return result;
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    tools.tools[t].temperature = std::move(observer.ended[t]->temperature);
    result.heat.push_back(std::move(observer.ended[t]->heat));
  }
  result.end = tool_temperatures(tools);
  result.samples = one_cycle(scene, cycle, observer);
  return result;
}

}  // namespace parison::forming
