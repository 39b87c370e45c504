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
constexpr double neighbourhood = 0.1;  ///< of the arc
constexpr double round_off = 1e-9;

/// From the difference of both runs to the error of the finer one.
double richardson() { return safety / (std::pow(companion_factor, order) - 1); }

/// What a quantity is alike with: the first word of its name.
std::string kind(const Quantity& quantity) { return quantity.name.substr(0, quantity.name.find('_')); }

bool is_thinnest(const Quantity& quantity) { return quantity.name.rfind("thickness_min", 0) == 0; }

/// As shares; no run tells to the last bit.
double share_between(const Quantity& a, const Quantity& b) {
  return std::max(std::abs(a.value - b.value) / b.scale, round_off);
}

/// Root mean square of the differences of each kind, as shares.
std::map<std::string, double> usual_differences(const Quantities& run, const Quantities& companion) {
  std::map<std::string, double> sum, count;
  for (const Quantity& quantity : run.values)
    if (const Quantity* other = companion.find(quantity.name); other && !is_thinnest(quantity)) {
      sum[kind(quantity)] += std::pow(share_between(*other, quantity), 2);
      count[kind(quantity)] += 1;
    }
  for (auto& [of, value] : sum) value = std::sqrt(value / count[of]);
  return sum;
}

/// Wall thickness near a place of the profile may be as wrong as where it is worst around it.
double largest_near(const std::vector<double>& profile, const std::vector<double>& other, int at) {
  const int reach = static_cast<int>(std::lround(neighbourhood * (profile_points - 1)));
  double largest = round_off * profile[at];
  for (int i = std::max(0, at - reach); i <= std::min(profile_points - 1, at + reach); ++i)
    largest = std::fmax(largest, std::abs(profile[i] - other[i]));
  return largest;
}

/// The thinnest wall and its place, which lies where the wall is as thin to within the error of its thickness.
void add_thinnest(Quantities& run, const Quantities& companion) {
  const double spacing = 1.0 / (profile_points - 1);
  double error = 0;
  for (Quantity& quantity : run.values) {
    if (!is_thinnest(quantity) || companion.profile.empty()) continue;
    if (quantity.name == "thickness_min") {
      const int at = static_cast<int>(std::lround(run.find("thickness_min_at")->value / spacing));
      quantity.error = error = richardson() * largest_near(run.profile, companion.profile, at);
      continue;
    }
    const int at = static_cast<int>(std::lround(quantity.value / spacing));
    int farthest = 0;
    for (int i = 0; i < profile_points; ++i)
      if (run.profile[i] <= run.profile[at] + error) farthest = std::max(farthest, std::abs(i - at));
    quantity.error = (farthest + 1) * spacing;
  }
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
    if (const Quantity* other = companion.find(quantity.name); other && !is_thinnest(quantity))
      quantity.error = richardson() * quantity.scale *
                       std::max(share_between(*other, quantity), least_of_kind * usual[kind(quantity)]);
  add_thinnest(bars.quantities, companion);
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
