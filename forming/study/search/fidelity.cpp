// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/fidelity.hpp"

#include <algorithm>
#include <cmath>

namespace parison::forming {
namespace {

/// Differences below this share are round-off.
constexpr double round_off = 1e-9;

std::vector<double> difference(const std::vector<double>& coarse, const std::vector<double>& fine) {
  std::vector<double> found(fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i) found[i] = fine[i] - coarse[i];
  return found;
}

void add(const std::vector<double>& difference, std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += difference[i];
}

bool is_of_the_wall(const Quantity& quantity) {
  return quantity.name == "wall_rms" || quantity.name == "wall_min";
}

}  // namespace

Correction correction_from(const Outcome& coarse, const Outcome& fine) {
  Correction found;
  if (!coarse.wall.thickness.empty() && !fine.wall.thickness.empty())
    found.wall = {difference(coarse.wall.radius, fine.wall.radius), difference(coarse.wall.height, fine.wall.height),
                  difference(coarse.wall.thickness, fine.wall.thickness)};
  for (const Quantity& quantity : fine.quantities.values) {
    const Quantity* other = coarse.quantities.find(quantity.name);
    if (!other || is_of_the_wall(quantity)) continue;
    found.quantities.push_back({quantity.name, quantity.unit, quantity.value - other->value, quantity.scale});
  }
  return found;
}

Outcome corrected(const Outcome& run, const Correction& correction, const WallPart& part) {
  if (!run.reason.empty()) return run;
  Outcome found;
  for (const Quantity& difference : correction.quantities)
    if (const Quantity* own = run.quantities.find(difference.name))
      found.quantities.values.push_back({own->name, own->unit, own->value + difference.value, own->scale});
  if (run.wall.thickness.empty() || correction.wall.thickness.empty()) return found;
  found.wall = run.wall;
  add(correction.wall.radius, found.wall.radius);
  add(correction.wall.height, found.wall.height);
  add(correction.wall.thickness, found.wall.thickness);
  add_wall(found.wall, part, found.quantities);
  return found;
}

bool is_misled(const Goal& goal, const Worth& coarse, const Worth& fine) {
  const auto is_more = [](double a, double b) { return a - b > round_off * std::max(std::abs(a), std::abs(b)); };
  const auto good = good_value(goal);
  if (good && is_more(fine.value, *good) && is_more(fine.value, coarse.value)) return true;
  for (Eigen::Index i = 0; i < fine.excess.size(); ++i)
    if (fine.excess[i] > round_off && is_more(fine.excess[i], coarse.excess[i])) return true;
  return false;
}

}  // namespace parison::forming
