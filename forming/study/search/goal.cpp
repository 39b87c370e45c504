// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/goal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/numbers.hpp"
#include "forming/study/search/minimum/least_squares.hpp"

namespace parison::forming {

namespace {

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
  const auto is_more = [](double a, double b) { return a - b > core::round_off * std::max(std::abs(a), std::abs(b)); };
  const auto good = good_value(goal);
  if (good && is_more(fine.value, *good) && is_more(fine.value, coarse.value)) return true;
  for (Eigen::Index i = 0; i < fine.excess.size(); ++i)
    if (fine.excess[i] > core::round_off && is_more(fine.excess[i], coarse.excess[i])) return true;
  return false;
}

namespace {

/// By what limits that do not hold weigh beside the goal.
constexpr double limit_weight = 3;

/// What a share of a quantity is taken of; of temperatures 100 K, as they have no zero of their own.
double scale_of(const std::string& unit, double value) {
  if (unit == "degC") return 100;
  return std::max(std::abs(value), 1e-9);
}

double linear_at(const WallTable& table, double at) {
  const auto after = std::upper_bound(table.at.begin(), table.at.end(), at);
  if (after == table.at.begin()) return table.thickness.front();
  if (after == table.at.end()) return table.thickness.back();
  const auto i = static_cast<std::size_t>(after - table.at.begin());
  const double share = (at - table.at[i - 1]) / (table.at[i] - table.at[i - 1]);
  return table.thickness[i - 1] + share * (table.thickness[i] - table.thickness[i - 1]);
}

/// The thickness that is wanted at each place, mm.
std::vector<double> wanted_wall(const Target& target, const Wall& wall, double mean) {
  std::vector<double> wanted(wall.thickness.size(), target.kind == Target::Kind::even_wall ? mean : target.value);
  if (target.kind == Target::Kind::wall && !target.wall.at.empty())
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double arc = target.wall.arc_end * double(i) / double(wanted.size() - 1);
      wanted[i] = linear_at(target.wall, target.wall.over_arc ? arc : wall.height[i]);
    }
  return wanted;
}

/// Shares of the mean thickness that is wanted, weighed so that their norm is the rms over the area.
std::optional<Eigen::VectorXd> wall_residual(const Target& target, const Wall& wall) {
  if (wall.thickness.empty()) return std::nullopt;
  const std::vector<double> shares = area_shares(wall, target.part);
  const std::vector<double> wanted = wanted_wall(target, wall, mean_thickness(wall, shares));
  Eigen::VectorXd residual(Eigen::Index(shares.size()));
  double mean = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) mean += shares[i] * wanted[i];
  if (!(mean > 0)) return std::nullopt;
  for (std::size_t i = 0; i < shares.size(); ++i)
    residual[Eigen::Index(i)] = std::sqrt(shares[i]) * (wall.thickness[i] - wanted[i]) / mean;
  return residual;
}

std::optional<Eigen::VectorXd> excess_of(const Goal& goal, const Quantities& quantities) {
  Eigen::VectorXd excess(Eigen::Index(goal.limits.size()));
  for (std::size_t i = 0; i < goal.limits.size(); ++i) {
    const Limit& limit = goal.limits[i];
    const Quantity* found = quantities.find(limit.quantity);
    if (!found) return std::nullopt;
    excess[Eigen::Index(i)] =
        (limit.at_least ? limit.value - found->value : found->value - limit.value) / scale_of(limit.unit, limit.value);
  }
  return excess;
}

}  // namespace

bool is_better(const Worth& a, const Worth& b) {
  if (a.residual.size() > 0)
    return counted(a.residual, a.excess.size()).norm() < counted(b.residual, b.excess.size()).norm();
  if (a.holds() != b.holds()) return a.holds();
  return a.holds() ? a.value < b.value : a.excess.maxCoeff() < b.excess.maxCoeff();
}

std::optional<Worth> worth(const Goal& goal, const Outcome& outcome) {
  using Kind = Target::Kind;
  if (!outcome.reason.empty()) return std::nullopt;
  const Target& target = goal.target;
  const auto excess = excess_of(goal, outcome.quantities);
  if (!excess) return std::nullopt;
  Worth found{{}, *excess, 0};
  if (target.kind == Kind::even_wall || target.kind == Kind::wall) {
    const auto residual = wall_residual(target, outcome.wall);
    if (!residual) return std::nullopt;
    found.residual = *residual;
    found.value = 100 * residual->norm();
  } else {
    const Quantity* quantity = outcome.quantities.find(target.quantity);
    if (!quantity) return std::nullopt;
    found.value = target.kind == Kind::most ? -quantity->value : quantity->value;
    if (target.kind == Kind::value) {
      found.value = std::abs(quantity->value - target.value);
      found.residual =
          Eigen::VectorXd::Constant(1, (quantity->value - target.value) / scale_of(quantity->unit, target.value));
    }
  }
  if (target.is_scalar()) return found;
  const Eigen::Index own = found.residual.size();
  found.residual.conservativeResize(own + excess->size());
  found.residual.tail(excess->size()) = limit_weight * *excess;
  return found;
}

std::optional<double> good_value(const Goal& goal) {
  const Target& target = goal.target;
  if (!target.good_enough) return std::nullopt;
  return target.kind == Target::Kind::most ? -*target.good_enough : *target.good_enough;
}

double good_norm(const Goal& goal) {
  const Target& target = goal.target;
  if (!target.good_enough) return 0;
  if (target.kind == Target::Kind::value) return *target.good_enough / scale_of(target.unit, target.value);
  return *target.good_enough / 100;
}

std::string what_is_sought(const Goal& goal) {
  using Kind = Target::Kind;
  switch (goal.target.kind) {
    case Kind::even_wall:
      return "rms deviation of the wall from its mean, %";
    case Kind::wall:
      return "rms deviation of the wall from the wanted one, %";
    case Kind::value:
      return goal.target.quantity + " off its wanted value";
    case Kind::least:
      return goal.target.quantity;
    case Kind::most:
      break;
  }
  return "- " + goal.target.quantity;
}

}  // namespace parison::forming
