// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/error_bars.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/files.hpp"
#include "forming/checkpoint.hpp"

namespace parison::forming {
namespace {

constexpr double safety = 1;
constexpr double order = 1;
/// A difference may vanish by chance: none is taken for smaller than this share of what is usual among its kind.
constexpr double least_of_kind = 0.5;

/// From the difference of both runs to the error of the finer one.
double richardson() { return safety / (std::pow(companion_factor, order) - 1); }

/// What a quantity is alike with: the first word of its name.
std::string kind(const Quantity& quantity) { return quantity.name.substr(0, quantity.name.find('_')); }

bool is_place(const Quantity& quantity) { return quantity.name == "thickness_min_at"; }

double share_between(const Quantity& a, const Quantity& b) { return std::abs(a.value - b.value) / b.scale; }

/// Root mean square of the differences of each kind, as shares.
std::map<std::string, double> usual_differences(const Quantities& run, const Quantities& companion) {
  std::map<std::string, double> sum, count;
  const auto add = [&](const std::string& of, double share) {
    sum[of] += share * share;
    count[of] += 1;
  };
  for (const Quantity& quantity : run.values)
    if (const Quantity* other = companion.find(quantity.name); other && !is_place(quantity))
      add(kind(quantity), share_between(*other, quantity));
  if (const double mean = compare_profiles(companion.profile, run.profile).mean; std::isfinite(mean)) add("thickness", mean);
  for (auto& [of, value] : sum) value = std::sqrt(value / count[of]);
  return sum;
}

/// How far from the thinnest place the wall is as thin to within the error of its thickness.
double place_error(const Quantities& run, double thinnest_at, double error) {
  const double spacing = 1.0 / (profile_points - 1);
  const int at = static_cast<int>(std::lround(thinnest_at / spacing));
  const double as_thin = run.profile[at] + 2 * error;
  int farthest = 0;
  for (int i = 0; i < profile_points; ++i)
    if (run.profile[i] <= as_thin) farthest = std::max(farthest, std::abs(i - at));
  return (farthest + 1) * spacing;
}

/// The same case in the same state of the program, run to its end.
bool is_complete(const std::string& directory) {
  const std::string path = directory + "/summary.json";
  return std::filesystem::exists(path) && core::read_json(core::read_text(path), path).flag_of("completed");
}

bool has_checkpoint(const std::string& directory) { return std::filesystem::exists(directory + "/checkpoint.h5"); }

}  // namespace

ErrorBars error_bars(const Quantities& run, const Quantities& companion) {
  ErrorBars bars{run, 0, 0, 0, 0};
  auto usual = usual_differences(run, companion);
  for (Quantity& quantity : bars.quantities.values)
    if (const Quantity* other = companion.find(quantity.name); other && !is_place(quantity))
      quantity.error = richardson() * quantity.scale *
                       std::max(share_between(*other, quantity), least_of_kind * usual[kind(quantity)]);
  const Quantity* thinnest = bars.quantities.find("thickness_min");
  for (Quantity& quantity : bars.quantities.values)
    if (is_place(quantity) && thinnest) quantity.error = place_error(run, quantity.value, thinnest->error);
  const ProfileDifference profile = compare_profiles(companion.profile, run.profile);
  bars.profile_mean = richardson() * profile.mean;
  bars.profile_largest = richardson() * profile.largest;
  bars.heat = richardson() * heat_difference(companion, run);
  return bars;
}

std::optional<ErrorBars> estimate_errors(const Scene& scene, const Quantities& run, const std::string& directory,
                                         const StopRequest& stop) {
  const std::string folder = directory + "/companion", path = folder + "/summary.json";
  if (!is_complete(folder)) {
    const Scene coarse = read_scene(scene.file, coarser_text(scene.accuracy_name, companion_factor), scene.overrides);
    fmt::print("\nthe companion run for the error bars, in {}\n", folder);
    const RunOutcome outcome = has_checkpoint(folder) ? resume(coarse, folder, stop) : forming::run(coarse, folder, stop);
    write_summary(folder, coarse, outcome.state, outcome.facts);
    if (!outcome.facts.completed) return {};
  }
  const core::JsonValue summary = core::read_json(core::read_text(path), path);
  ErrorBars bars = error_bars(run, read_quantities(summary));
  bars.companion_cpu_seconds = summary.number_of("cpu_seconds");
  return bars;
}

}  // namespace parison::forming
