// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/tradeoff.hpp"

#include <algorithm>
#include <cmath>

namespace parison::forming {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double level_of(const Rung& rung) {
  return read_accuracy(rung.accuracy).effective_level();
}

bool on_plot(const RungResult& result) {
  return result.completed && result.rung.group != "model" && result.rung.group != "reference" && result.error() > 0;
}

}  // namespace

double RungResult::error() const {
  return std::fmax(profile.mean, heat);
}

void compare_rungs(std::vector<RungResult>& results, const std::string& base) {
  const auto found =
      std::find_if(results.begin(), results.end(), [&](const RungResult& r) { return r.rung.name == base; });
  for (RungResult& result : results) {
    const RungResult& other = result.rung.group == "model" ? *found : results.front();
    result.profile = compare_profiles(result.quantities.profile, other.quantities.profile);
    result.heat = heat_difference(result.quantities, other.quantities);
  }
}

void mark_front(std::vector<RungResult>& results) {
  for (RungResult& result : results)
    result.on_front = on_plot(result) && std::none_of(results.begin(), results.end(), [&](const RungResult& other) {
                        return on_plot(other) && other.cpu <= result.cpu && other.error() <= result.error() &&
                               (other.cpu < result.cpu || other.error() < result.error());
                      });
}

double over_front(const std::vector<RungResult>& results, const RungResult& rung) {
  std::vector<const RungResult*> line;
  for (const RungResult& result : results)
    if (result.on_front) line.push_back(&result);
  std::sort(line.begin(), line.end(), [](const auto* a, const auto* b) { return a->error() < b->error(); });
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i]->error() < rung.error()) continue;
    if (i == 0) return line[0]->error() == rung.error() ? rung.cpu / line[0]->cpu : none;
    const RungResult &a = *line[i - 1], &b = *line[i];
    const double t = std::log(rung.error() / a.error()) / std::log(b.error() / a.error());
    return rung.cpu / std::exp((1 - t) * std::log(a.cpu) + t * std::log(b.cpu));
  }
  return line.empty() ? none : rung.cpu / line.back()->cpu;
}

ErrorLaw fit_error_law(const std::vector<RungResult>& results, double (*error)(const RungResult&)) {
  const double reference = level_of(results.front().rung);
  std::vector<std::pair<double, double>> points;  // level, error
  for (const RungResult& result : results)
    if (result.completed && result.rung.group == "dial" && error(result) > 0)
      points.emplace_back(level_of(result.rung), error(result));
  ErrorLaw best{none, none};
  if (points.size() < 2) return best;
  double least = std::numeric_limits<double>::infinity();
  // Below the first order nothing here converges; only scatter looks so.
  constexpr double lowest_order = 1, highest_order = 3, step = 0.01;
  for (double order = lowest_order; order <= highest_order; order += step) {
    std::vector<double> logs;
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
