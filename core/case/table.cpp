// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parison::core {

namespace {

/// Index of the interval of x that contains `at`, between 0 and size - 2. Where entries are even, as those of a law
/// that was tabulated, it is next to the place that a straight line through the ends gives.
std::size_t interval(const std::vector<double>& x, double at) {
  const auto last = static_cast<std::ptrdiff_t>(x.size()) - 2;
  const double share = (at - x.front()) / (x.back() - x.front());
  const auto guess = share > 0 ? static_cast<std::ptrdiff_t>(std::min(share, 1.0) * static_cast<double>(last)) : 0;
  for (auto i = std::max<std::ptrdiff_t>(guess - 1, 0); i <= std::min(guess + 1, last); ++i)
    if (x[i] <= at && at < x[i + 1]) return static_cast<std::size_t>(i);
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - x.begin() - 1, 0, last));
}

}  // namespace

double Table::operator()(double at) const {
  if (x.size() == 1 || at <= x.front()) return y.front();
  if (at >= x.back()) return y.back();
  const std::size_t i = interval(x, at);
  return y[i] + (y[i + 1] - y[i]) * (at - x[i]) / (x[i + 1] - x[i]);
}

double Table::derivative(double at) const {
  if (x.size() == 1 || at < x.front() || at > x.back()) return 0;
  const std::size_t i = interval(x, at);
  return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
}

double Table::integral(double at) const {
  if (x.size() == 1) return y.front() * at;
  if (at <= x.front()) return y.front() * (at - x.front());
  double sum = 0;
  std::size_t i = 0;
  for (; i + 1 < x.size() && x[i + 1] <= at; ++i) sum += 0.5 * (y[i] + y[i + 1]) * (x[i + 1] - x[i]);
  if (i + 1 < x.size() && x[i] < at) sum += 0.5 * (y[i] + (*this)(at)) * (at - x[i]);
  return sum + y.back() * std::max(0.0, at - x.back());
}

double mean(const Table& table, double from, double to) {
  double sum = 0, at = from, value = table(from);
  const auto add_until = [&](double next) {
    const double there = table(next);
    sum += 0.5 * (value + there) * (next - at);
    at = next, value = there;
  };
  for (const double x : table.x)
    if (x > from && x < to) add_until(x);
  add_until(to);
  return sum / (to - from);
}

std::vector<double> corners(const Table& table, double share) {
  if (table.x.size() == 1) return {};
  const auto [low, high] = std::minmax_element(table.y.begin(), table.y.end());
  const double most = share * (*high - *low);
  std::vector<bool> kept(table.x.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, table.x.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const Table chord{{table.x[first], table.x[last]}, {table.y[first], table.y[last]}};
    std::size_t furthest = first;
    double distance = most;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double off = std::abs(table.y[i] - chord(table.x[i])); off > distance) distance = off, furthest = i;
    if (furthest == first) continue;
    kept[furthest] = true;
    open.push_back({first, furthest});
    open.push_back({furthest, last});
  }
  std::vector<double> at;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) at.push_back(table.x[i]);
  return at;
}

std::vector<double> kinks(const Table& table, double share) {
  std::vector<double> slope{0};
  for (std::size_t i = 0; i + 1 < table.x.size(); ++i)
    slope.push_back((table.y[i + 1] - table.y[i]) / (table.x[i + 1] - table.x[i]));
  slope.push_back(0);
  double largest = 0;
  for (const double value : slope) largest = std::max(largest, std::abs(value));
  std::vector<double> at;
  for (std::size_t i = 0; i < table.x.size(); ++i)
    if (std::abs(slope[i + 1] - slope[i]) > share * largest) at.push_back(table.x[i]);
  return at;
}

}  // namespace parison::core
