// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "forming/report/quantity_labels.hpp"
#include "forming/study/audit.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/stop_request.hpp"
#include "tools/tradeoff/tradeoff.hpp"

namespace parison::tools {
namespace {

using forming::AuditChange;
using forming::AuditRun;

/// Changes of more than so many times those of runs that should agree count.
constexpr double above_noise = 3;

/// The larger of two changes, number by number.
AuditChange larger(const AuditChange& a, const AuditChange& b) {
  const auto of = [](double x, double y) { return std::fmax(std::abs(x), std::abs(y)); };
  AuditChange both = a.most_change > b.most_change ? a : b;
  both.shape = of(a.shape, b.shape);
  both.thickness = of(a.thickness, b.thickness);
  both.heat = of(a.heat, b.heat);
  both.mean_temperature = of(a.mean_temperature, b.mean_temperature);
  return both;
}

/// A number of the table; in brackets where it is not above the noise.
std::string cell(double value, double noise, const char* unit, bool with_sign = false) {
  if (!std::isfinite(value)) return "-";
  const std::string text = with_sign ? fmt::format("{:+.2g}{}", value, unit) : fmt::format("{:.2g}{}", value, unit);
  return std::abs(value) > above_noise * std::abs(noise) ? text : '(' + text + ')';
}

std::string row(const std::string& name, const AuditChange& change, const AuditChange& noise, double wall) {
  std::string text = fmt::format(
      "{:<18}{:>11}{:>10}{:>10}{:>10}{:>11}", name, cell(1e3 * change.shape, 1e3 * noise.shape, " mm"),
      cell(100 * change.shape / wall, 100 * noise.shape / wall, " %"),
      cell(100 * change.thickness, 100 * noise.thickness, " %"), cell(100 * change.heat, 100 * noise.heat, " %"),
      cell(change.mean_temperature, noise.mean_temperature, " K", true));
  if (change.most_change > above_noise * noise.most_change)
    text += fmt::format("   {} {:.2g} %", forming::quantity_label(change.most_changed), 100 * change.most_change);
  return text;
}

void print_head(double wall) {
  fmt::print("\n{:<18}{:>11}{:>10}{:>10}{:>10}{:>11}\n", "part", "surface", "of wall", "wall", "heat", "glass");
  fmt::print(
      "  surface: mean distance of the surfaces at the end, and that over {:.3g} mm, twice the volume over the "
      "surface;\n"
      "  wall: change of its thickness, mean over the profile; heat: into the tools; glass: its mean temperature;\n"
      "  then the other quantity of interest that changes most. In brackets: less than {:g} times the noise.\n\n",
      1e3 * wall, above_noise);
}

void print_report(const std::vector<AuditRun>& runs) {
  const AuditRun& base = runs.front();
  print_head(base.wall);
  AuditChange noise = audit_change(base, base);
  for (const AuditRun& run : runs)
    if (is_noise(run.variant) && run.completed) noise = larger(noise, audit_change(run, base));
  fmt::print("{}\n", row("noise", noise, {0, 0, 0, 0, "", 0}, base.wall));
  for (const AuditRun& run : runs) {
    if (&run == &base || is_noise(run.variant)) continue;
    if (run.completed)
      fmt::print("{}\n", row(run.variant.name, audit_change(run, base), noise, base.wall));
    else
      fmt::print("{:<18}stopped: {}\n", run.variant.name, run.reason);
  }
  fmt::print("\n");
  for (const AuditRun& run : runs)
    if (&run != &base && !is_noise(run.variant)) fmt::print("  {:<18}{}\n", run.variant.name, run.variant.what);
}

}  // namespace

int model_parts(const TradeoffRequest& request) {
  catch_signals();
  const forming::Scene scene = forming::read_scene(request.case_path, request.base, request.overrides);
  const auto variants = forming::audit_variants(scene);
  fmt::print("{} at {} accuracy: {} runs\n", scene.name, scene.accuracy_name, variants.size());
  std::vector<AuditRun> runs;
  for (const auto& variant : variants) {
    runs.push_back(forming::audit_run(request.case_path, variant, stop_requested));
    if (stop_requested()) return run_failed;
    fmt::print("  {:<18}{:>6.1f} s\n", variant.name, runs.back().seconds);
    std::fflush(stdout);
    if (runs.size() == 1 && !runs[0].completed) {
      fmt::print(stderr, "parison: the case itself stopped in {}\n", runs[0].reason);
      return run_failed;
    }
  }
  print_report(runs);
  return 0;
}

}  // namespace parison::tools
