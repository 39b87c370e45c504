// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "forming/report/cavity_report.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/container/container_report.hpp"
#include "forming/report/cooling/residual_stress.hpp"
#include "forming/report/error_bars.hpp"
#include "forming/report/model_bars.hpp"
#include "forming/report/quantity_labels.hpp"
#include "forming/report/summary.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

double celsius(double kelvin) {
  return kelvin - thermal::content_reference;
}

std::string line(const std::string& label, const std::string& value) {
  return fmt::format("  {:<22}{}\n", label, value);
}

/// A place for a line of the terminal.
std::string at(const Point& x) {
  return fmt::format("({:.1f}, {:.1f}) mm", 1e3 * x[0], 1e3 * x[1]);
}

std::string radiation_text(const Scene& scene) {
  const std::string seen = scene.enclosure ? ", surfaces see each other" : "";
  if (scene.radiation_choice) return describe(*scene.radiation_choice) + seen;
  return model_name(scene.glass.thermal->radiation) + seen;
}

std::string thickness_lines(const Summary& summary) {
  const ThicknessRange& range = summary.thickness;
  if (!std::isfinite(range.mean)) return line("wall thickness", summary.no_wall.empty() ? "n/a" : summary.no_wall);
  return line("wall thickness", fmt::format("min {:.2f} mm, mean {:.2f} mm, max {:.2f} mm", 1e3 * range.lowest,
                                            1e3 * range.mean, 1e3 * range.highest)) +
         line("at (r, z)", fmt::format("min {}, max {}", at(range.lowest_at), at(range.highest_at))) +
         (summary.beside_finish.lowest > range.lowest
              ? line("without the finish", fmt::format("min {:.2f} mm at {}", 1e3 * summary.beside_finish.lowest,
                                                       at(summary.beside_finish.lowest_at)))
              : "");
}

/// What the numbers of a planar scene are for; empty of an axisymmetric one.
std::string depth_line(const Scene& scene) {
  if (scene.geometry != core::Geometry::planar) return "";
  const auto is_symmetry = [](const Boundary& boundary) { return boundary.kind == BoundaryKind::symmetry; };
  const auto& boundaries = scene.glass.boundaries;
  const bool is_part = std::any_of(boundaries.begin(), boundaries.end(), is_symmetry);
  return line("planar", fmt::format("masses, volumes, heats and forces are those of a metre of depth{}",
                                    is_part ? ", of the part of the section that is drawn" : ""));
}

std::string glass_lines(const Scene& scene, const State& state, const Summary& summary) {
  const GlassFacts& glass = summary.glass;
  std::string text =
      line("glass", fmt::format("{} g, {} cm3", figures(1e3 * glass.mass, 1), figures(1e6 * glass.volume, 2)));
  text += depth_line(scene);
  if (scene.has_heat())
    text += line("glass temperature", fmt::format("mean {:.0f} degC, from {:.0f} to {:.0f} degC", celsius(glass.mean),
                                                  celsius(glass.lowest), celsius(glass.highest)));
  if (const std::string hot = hot_glass_text(scene, summary.run.diagnostics.hot_glass); !hot.empty())
    text += line("too hot at the most", hot);
  text += thickness_lines(summary);
  const std::string capacity = summary.capacity_in_space
                                   ? figures(1e6 * *summary.capacity_in_space, 2) + " ml to the rim"
                                   : capacity_text(scene, state, summary.no_wall.empty());
  if (!capacity.empty()) text += line("capacity", capacity);
  for (const auto& [label, found] : cooling_lines(summary)) text += line(label, found);
  if (std::isfinite(summary.outer_within_02mm) && !scene.tools.empty())
    text += line("outer surface",
                 fmt::format("{:.1f} % within 0.2 mm of the active tools", 100 * summary.outer_within_02mm));
  return text;
}

std::string tool_lines(const Summary& summary) {
  if (summary.tools.empty()) return {};
  const bool light = summary.tools.front().radiated.has_value();
  std::string text = fmt::format("\n  {:<22}{:>12}{:>18}{:>16}{}\n", "tool", "heat, kJ", "max, degC", "end offset, mm",
                                 light ? "   as light, kJ" : "");
  for (const ToolSummary& tool : summary.tools) {
    const std::string max_temperature =
        std::isnan(tool.hottest.temperature) ? "-" : fmt::format("{:.0f}", celsius(tool.hottest.temperature));
    const std::string as_light = tool.radiated ? fmt::format("{:>15.2f}", 1e-3 * *tool.radiated) : "";
    text += fmt::format("  {:<22}{:>12.2f}{:>18}{:>16.2f}{}\n", tool.name, 1e-3 * tool.heat_received, max_temperature,
                        1e3 * tool.position, as_light);
  }
  return text;
}

std::string stage_lines(const RunFacts& run) {
  std::string text = fmt::format("\n  {:<22}{:>12}{:>18}   {}\n", "stage", "from, s", "to, s", "ended by");
  for (const StageRecord& stage : run.stages)
    text += fmt::format("  {:<22}{:>12.3f}{:>18.3f}   {}\n", stage.name, stage.start, stage.end, stage.end_reason);
  return text + '\n';
}

/// The sealed cavities of the run's end.
std::string cavity_line(const Scene& scene, const State& state) {
  if (!seals_cavities(scene)) return "";
  const CavityReport report = cavity_report(scene, state);
  if (report.size() == 0) return line("sealed cavities", "none at the end");
  double volume = 0, mass = 0;
  for (std::size_t i = 0; i < report.size(); ++i) volume += report.volume[i], mass += report.mass[i];
  const auto [low, high] = std::minmax_element(report.pressure.begin(), report.pressure.end());
  return line("sealed cavities", fmt::format("{} at the end, {:.3g} cm3, {:.3g} mg of air, {:.3g} to {:.3g} bar",
                                             report.size(), 1e6 * volume, 1e6 * mass, 1e-5 * *low, 1e-5 * *high));
}

/// Wall time, and what it was spent on.
std::string wall_line(const RunFacts& run) {
  std::string parts;
  for (const char* part : timed_parts) {
    const auto found = run.timing.find(part);
    if (found != run.timing.end() && found->second >= 0.05)
      parts += fmt::format("{}{} {:.1f}", parts.empty() ? ": " : ", ", part, found->second);
  }
  return line("wall time", fmt::format("{:.1f} s{}", run.wall_seconds, parts));
}

std::string run_lines(const Scene& scene, const State& state, const Summary& summary) {
  const Totals& totals = state.totals;
  const Diagnostics& seen = summary.run.diagnostics;
  const std::string unconverged =
      seen.steps.unconverged > 0 ? fmt::format(", {} with a coupling not converged", seen.steps.unconverged) : "";
  std::string text = line("steps", fmt::format("{} ({} rejected{}), {} remeshes", totals.steps, seen.steps.rejected,
                                               unconverged, remeshes(state)));
  text += line("volume drift", fmt::format("{:.4f} % at the end, {:.4f} % at the most",
                                           100 * summary.glass.volume_drift, 100 * seen.max_drift));
  if (scene.has_heat()) {
    text += line("energy imbalance", fmt::format("{:.4f} %", 100 * summary.glass.energy_imbalance));
    const std::string light = scene.has_light() ? fmt::format(" ({:.2f} kJ of it light to the surroundings)",
                                                              1e-3 * summary.heat_lost.light_to_air)
                                                : "";
    text += line("heat lost", fmt::format("{:.2f} kJ to tools, {:.2f} kJ to air{}", 1e-3 * summary.heat_lost.to_tools,
                                          1e-3 * summary.heat_lost.to_air, light));
  }
  if (scene.has_flow() && !scene.tools.empty())
    text += line("max penetration", fmt::format("{:.4f} mm", 1e3 * seen.in_tools.node.depth));
  text += cavity_line(scene, state);
  text += wall_line(summary.run);
  for (const Flag& flag : summary.flags) text += line("flag", flag.sentence);
  for (const std::string& warning : summary.run.warnings) text += line("warning", warning);
  for (const std::string& complaint : complaints(summary.run.checks)) text += line("check", complaint);
  return text;
}

std::string percent_line(const char* label, double fraction) {
  return std::isfinite(fraction) ? fmt::format("  {:<42}{:>14.2g} %\n", label, 100 * fraction) : "";
}

std::string error_text(const Quantity& quantity) {
  if (!std::isfinite(quantity.error)) return "-";
  if (quantity.name == "thickness_min_at" && quantity.error >= 1) return "anywhere";
  return fmt::format("+- {:.2g}", quantity.error);
}

/// What the column of models means, and where that of the tolerances is.
std::string model_lines(const std::vector<ModelUse>& models) {
  if (models.empty()) return "";
  return fmt::format(
      "  model: {}; its column is what the best one moved such quantities at most where\n"
      "  it was measured, - where the run has it, ? where it was not measured\n"
      "  tolerances: `parison uncertainty` shows what they add, beside these two\n",
      models_text(models));
}

/// What the bars rest on.
std::string coarser_lines(const ErrorBars& bars) {
  std::string factors;
  double seconds = 0;
  for (const CoarserRun& run : bars.coarser) {
    factors += fmt::format("{}{:.3g}", factors.empty() ? "" : " and ", run.factor);
    seconds += run.cpu_seconds;
  }
  return fmt::format(
      "  by {} {} times coarser ({:.1f} s CPU), the largest that the differences of the runs show;\n"
      "  about nine of ten true errors are smaller; - where no coarser run has the quantity\n",
      bars.coarser.size() == 1 ? "a run" : "runs", factors, seconds);
}

/// What an accuracy that was asked for is that of, in the scene at hand.
std::string controlled(const ErrorBars& bars) {
  const bool wall = std::isfinite(bars.profile_mean), heat = std::isfinite(bars.heat);
  return wall && heat ? "the wall in the mean and of the heat into tools"
         : wall       ? "the wall in the mean"
         : heat       ? "the heat into tools"
                      : "each of the quantities above, as there is no wall and no heat into tools";
}

/// The runs that were made for an accuracy that was asked for, and whether it was reached.
std::string control_lines(const ErrorBars& bars) {
  const AccuracyRecord& control = *bars.control;
  std::string text = fmt::format("\n  accuracy asked for: {:.3g} % of {}\n", 100 * control.target, controlled(bars));
  double seconds = 0;
  for (const ControlledRun& run : control.runs) {
    seconds += run.cpu_seconds;
    text += fmt::format("  run at \"draft coarser {:.4g}\", {:.1f} s CPU: ", run.factor, run.cpu_seconds);
    text += !run.completed                ? "stopped before its end\n"
            : std::isfinite(run.estimate) ? fmt::format("error estimated at {:.2g} %\n", 100 * run.estimate)
                                          : "nothing to compare with yet\n";
  }
  const std::vector<std::string> condemned =
      control.runs.empty() ? std::vector<std::string>() : control.runs.back().condemned_by;
  for (const std::string& check : condemned) text += fmt::format("  its checks speak against that: {}\n", check);
  if (!control.not_mended.empty())
    text += fmt::format(
        "  finer runs do not bring {} within the limit, so none was made; the error reached is estimated at {:.2g} %\n",
        fmt::join(control.not_mended, ", "), 100 * control.runs.back().estimate);
  return text + fmt::format("  {}, {:.1f} s CPU in all\n", control.reached() ? "reached" : "not reached", seconds);
}

}  // namespace

std::string error_table(const ErrorBars& bars) {
  std::string text = fmt::format("\n  {:<42}{:>14}{:>14}{:>10}\n", "quantity", "value", "numerical", "model");
  for (const Quantity& quantity : bars.quantities.values)
    text += fmt::format("  {:<42}{:>14.5g}{:>14}{:>10} {}\n", quantity_label(quantity.name), quantity.value,
                        error_text(quantity), model_text(quantity.model),
                        quantity.place.allFinite() ? quantity.unit + ", at " + at(quantity.place) : quantity.unit);
  text += percent_line("wall thickness, mean error", bars.profile_mean);
  text += percent_line("wall thickness, largest error", bars.profile_max);
  text += percent_line("heat into tools, error", bars.heat);
  text += coarser_lines(bars) + model_lines(bars.quantities.models);
  return bars.control ? text + control_lines(bars) : text;
}

std::string summary_table(const Scene& scene, const State& state, const Summary& summary) {
  std::string text = fmt::format("\n{} at {} accuracy: ", scene.name, scene.accuracy_name);
  text += summary.run.completed ? fmt::format("completed, {:.4g} s simulated\n", state.time)
                                : fmt::format("stopped at {:.4g} s: {}\n", state.time, summary.run.reason);
  for (const std::string& assignment : scene.overrides) text += line("override", assignment);
  if (scene.has_heat()) text += line("radiation", radiation_text(scene));
  if (const std::string moves = models_move_text(summary.quantities.models); !moves.empty())
    text += line("best model moves", moves);
  return text + glass_lines(scene, state, summary) + tool_lines(summary) + stage_lines(summary.run) +
         run_lines(scene, state, summary);
}

std::string verdict_line(const Summary& summary) {
  return line("verdict", verdict_of_run(summary.run.checks, summary.run.completed));
}

}  // namespace parison::forming
