// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/tradeoff.hpp"

#include <algorithm>
#include <cmath>

namespace parison::forming {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double level_of(const Variant& variant) {
  return read_accuracy(variant.accuracy).effective_level();
}

bool on_plot(const VariantResult& result) {
  return result.completed && result.variant.group != "model" && result.variant.group != "reference" &&
         result.error() > 0;
}

}  // namespace

double VariantResult::error() const {
  return std::fmax(profile.mean, heat);
}

void compare_variants(std::vector<VariantResult>& results, const std::string& base) {
  const auto found =
      std::find_if(results.begin(), results.end(), [&](const VariantResult& r) { return r.variant.name == base; });
  for (VariantResult& result : results) {
    const VariantResult& other = result.variant.group == "model" ? *found : results.front();
    result.profile = compare_profiles(result.quantities.profile, other.quantities.profile);
    result.heat = heat_difference(result.quantities, other.quantities);
  }
}

void mark_front(std::vector<VariantResult>& results) {
  for (VariantResult& result : results)
    result.on_front = on_plot(result) && std::none_of(results.begin(), results.end(), [&](const VariantResult& other) {
                        return on_plot(other) && other.cpu <= result.cpu && other.error() <= result.error() &&
                               (other.cpu < result.cpu || other.error() < result.error());
                      });
}

double over_front(const std::vector<VariantResult>& results, const VariantResult& variant) {
  std::vector<const VariantResult*> line;
  for (const VariantResult& result : results)
    if (result.on_front) line.push_back(&result);
  std::sort(line.begin(), line.end(), [](const auto* a, const auto* b) { return a->error() < b->error(); });
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i]->error() < variant.error()) continue;
    if (i == 0) return line[0]->error() == variant.error() ? variant.cpu / line[0]->cpu : none;
    const VariantResult &a = *line[i - 1], &b = *line[i];
    const double t = std::log(variant.error() / a.error()) / std::log(b.error() / a.error());
    return variant.cpu / std::exp((1 - t) * std::log(a.cpu) + t * std::log(b.cpu));
  }
  return line.empty() ? none : variant.cpu / line.back()->cpu;
}

ErrorLaw fit_error_law(const std::vector<VariantResult>& results, double (*error)(const VariantResult&)) {
  const double reference = level_of(results.front().variant);
  std::vector<std::pair<double, double>> points;  // level, error
  for (const VariantResult& result : results)
    if (result.completed && result.variant.group == "accuracy" && error(result) > 0)
      points.emplace_back(level_of(result.variant), error(result));
  ErrorLaw best{none, none};
  if (points.size() < 2) return best;
  double least = std::numeric_limits<double>::infinity();
  // Below the first order nothing here converges; only scatter looks so.
  constexpr double min_order = 1, max_order = 3, step = 0.01;
  for (double order = min_order; order <= max_order; order += step) {
    std::vector<double> logs;
    logs.reserve(points.size());
    for (const auto& [level, size] : points)
      logs.push_back(std::log(size / (std::exp2(-order * level) - std::exp2(-order * reference))));
    double mean = 0, spread = 0;
    for (const double value : logs) mean += value / double(logs.size());
    for (const double value : logs) spread += (value - mean) * (value - mean);
    if (spread < least) least = spread, best = {std::exp(mean), order};
  }
  return best;
}

}  // namespace parison::forming
