// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/table.hpp"

#include <algorithm>
#include <cmath>

namespace parison::core {

namespace {

/// Index of the interval of x that contains `at`, between 0 and size - 2.
std::size_t interval(const std::vector<double>& x, double at) {
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  const auto last = static_cast<std::ptrdiff_t>(x.size()) - 2;
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
