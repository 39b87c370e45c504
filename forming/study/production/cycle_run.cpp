// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/cycle_run.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "forming/report/summary.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/sample.hpp"
#include "forming/step/idle/idle_tools.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {
namespace {

/// Temperatures and heats of the tools at the end of the machine cycle, or those of the moment.
struct CycleEnd {
  Eigen::VectorXd temperature;
  std::vector<CycleHeat> heat;
};

std::vector<CycleHeat> heats(const State& state) {
  std::vector<CycleHeat> all;
  for (const ToolState& tool : state.tools) all.push_back({tool.heat_received, tool.heat_through});
  return all;
}

/// Linear between two moments of a run.
CycleEnd between(const State& before, const State& state, double time) {
  const double share = (time - before.time) / (state.time - before.time);
  const auto mean = [&](double a, double b) { return a + share * (b - a); };
  CycleEnd end{tool_temperatures(before), heats(before)};
  end.temperature += share * (tool_temperatures(state) - end.temperature);
  const auto later = heats(state);
  for (std::size_t t = 0; t < later.size(); ++t) {
    end.heat[t].received = mean(end.heat[t].received, later[t].received);
    for (std::size_t i = 0; i < later[t].through.size(); ++i)
      end.heat[t].through[i] = mean(end.heat[t].through[i], later[t].through[i]);
  }
  return end;
}

/// Follows the tools through the forming.
class CycleObserver : public RunObserver {
 public:
  CycleObserver(const Scene& scene, const MachineCycle& cycle) : scene_(scene), cycle_(cycle) {}

  void run_begins(const RunView& view) override {
    for (const ToolState& tool : view.state.tools) surfaces_.emplace_back(tool.mesh, scene_.geometry);
    start = tool_temperatures(view.state);
    met.assign(view.state.tools.size(), view.state.glass.temperature.mean());
  }
  void stage_begins(const RunView& view) override {
    for (const StageTool& used : scene_.stages[view.state.stage].tools)
      if (!std::exchange(begun_[used.tool], true)) met[used.tool] = view.state.glass.temperature.mean();
  }
  void step_taken(const RunView& view, const State& before, const StepReport&) override {
    if (before.time < cycle_.seconds && view.state.time >= cycle_.seconds)
      end = between(before, view.state, cycle_.seconds);
  }
  void fields_due(const RunView&, const State& at) override {
    if (!samples.empty() && at.time <= samples.back().time) return;
    if (at.time <= cycle_.seconds) add_sample(at, scene_.stages[at.stage].name);
  }

  void add_sample(const State& state, const std::string& stage) {
    CycleSample sample{state.time, stage, {}, {}};
    for (std::size_t t = 0; t < state.tools.size(); ++t)
      sample.tools.push_back(surfaces_[t].temperatures(state.tools[t], std::numeric_limits<double>::infinity()));
    for (std::size_t p = 0; p < scene_.probes.size(); ++p) {
      const Index body = scene_.probes[p].body;
      sample.probes.push_back(
          body == glass_body ? std::numeric_limits<double>::quiet_NaN()
                             : forming::sample(mesh_of(state, body), temperature_of(state, body), state.probes[p]));
    }
    samples.push_back(std::move(sample));
  }

  Eigen::VectorXd start;
  std::vector<double> met;
  std::optional<CycleEnd> end;  ///< of the machine cycle, where the forming lasts that long
  std::vector<CycleSample> samples;

 private:
  const Scene& scene_;
  const MachineCycle& cycle_;
  std::vector<ToolSurface> surfaces_;
  std::map<Index, bool> begun_;
};

/// The tools alone until the end of the machine cycle.
std::string idle_rest(const Scene& scene, double cycle_end, State& tools, CycleObserver& observer) {
  while (tools.time < cycle_end) {
    const double rest = cycle_end - tools.time;
    const bool last = rest <= scene.output.interval * (1 + 1e-9);
    if (const std::string failure = idle_tools(scene, tools, last ? rest : scene.output.interval); !failure.empty())
      return "idle tools: " + failure;
    if (last) tools.time = cycle_end;
    observer.add_sample(tools, "idle");
  }
  return "";
}

}  // namespace

CycleRun run_cycle(const Scene& scene, const MachineCycle& cycle, const std::string& directory,
                   const StopRequest& stop) {
  CycleObserver observer(scene, cycle);
  CycleRun result;
  result.forming =
      directory.empty() ? run(scene, {&observer}, stop) : run_in_folder(scene, directory, {&observer}, stop);
  if (!directory.empty()) write_summary(directory, scene, result.forming.state, result.forming.facts);
  result.stopped = result.forming.facts.stopped;
  result.failure = result.forming.facts.completed ? "" : result.forming.facts.reason;
  result.start = observer.start;
  result.met = observer.met;
  if (!result.failure.empty()) return result;
  State tools = tools_of(result.forming.state);
  if (!observer.end) {
    result.failure = idle_rest(scene, cycle.seconds, tools, observer);
    observer.end = CycleEnd{tool_temperatures(tools), heats(tools)};
  }
  result.end = std::move(observer.end->temperature);
  result.heat = std::move(observer.end->heat);
  result.samples = std::move(observer.samples);
  return result;
}

}  // namespace parison::forming
