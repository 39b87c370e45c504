// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/sizing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

constexpr int bins_along = 64;
constexpr int block = 8;  ///< bins along a block

}  // namespace

SizeField::SizeField(std::vector<SizeSource> sources, double growth, double largest)
    : sources_(std::move(sources)), growth_(growth), largest_(largest), low_(Point::Zero()) {
  if (sources_.empty()) return;
  Point high = sources_[0].at;
  low_ = high;
  for (const SizeSource& source : sources_) {
    low_ = low_.cwiseMin(source.at);
    high = high.cwiseMax(source.at);
  }
  const Point extent = high - low_;
  bin_ = std::max(extent.maxCoeff() / bins_along, largest_ * 1e-6);
  columns_ = static_cast<int>(extent[0] / bin_) + 1;
  rows_ = static_cast<int>(extent[1] / bin_) + 1;
  bins_.resize(static_cast<std::size_t>(columns_) * rows_);
  blocks_.resize(static_cast<std::size_t>(columns_ / block + 1) * (rows_ / block + 1));
  all_.resize(sources_.size());
  std::iota(all_.begin(), all_.end(), 0);
}

double SizeField::wish(const SizeSource& source, double distance) const {
  return source.size + growth_ * std::max(0.0, distance - source.reach);
}

std::vector<int> SizeField::candidates(const std::vector<int>& among, const Point& centre, double radius) const {
  double bound = largest_;
  for (const int i : among) bound = std::min(bound, wish(sources_[i], (sources_[i].at - centre).norm() + radius));
  std::vector<int> result;
  for (const int i : among)
    if (wish(sources_[i], (sources_[i].at - centre).norm() - radius) <= bound) result.push_back(i);
  return result;
}

const std::vector<int>& SizeField::block_of(int column, int row) const {
  column /= block, row /= block;
  auto& list = blocks_[static_cast<std::size_t>(row) * (columns_ / block + 1) + column];
  if (list.empty()) list = candidates(all_, low_ + bin_ * block * Point(column + 0.5, row + 0.5), 0.75 * bin_ * block);
  return list;
}

double SizeField::finest(const Point& x) const {
  double size = largest_;
  if (sources_.empty()) return size;
  const auto place = [&](int axis, int count) {
    return std::clamp(static_cast<int>(std::floor((x[axis] - low_[axis]) / bin_)), 0, count - 1);
  };
  const int column = place(0, columns_), row = place(1, rows_);
  const Point centre = low_ + bin_ * Point(column + 0.5, row + 0.5);
  const double radius = 0.75 * bin_;
  const auto least = [&](const std::vector<int>& list) {
    for (const int i : list) size = std::min(size, wish(sources_[i], (sources_[i].at - x).norm()));
    return size;
  };
  if ((x - centre).norm() > radius) return least(candidates(all_, x, 0));
  auto& list = bins_[static_cast<std::size_t>(row) * columns_ + column];
  if (list.empty()) {
    list = candidates(block_of(column, row), centre, radius);
    if (list.empty()) list.push_back(0);
  }
  return least(list);
}

std::vector<double> divide(double length, const std::function<double(double)>& size, Index at_least) {
  std::vector<double> at{0}, integral{0};
  double before = size(0);
  while (at.back() < length) {
    double next = at.back() + 0.25 * before;
    if (next > length - 0.05 * before) next = length;
    const double here = size(next);
    integral.push_back(integral.back() + 0.5 * (next - at.back()) * (1 / before + 1 / here));
    at.push_back(next);
    before = here;
  }
  const double total = integral.back();
  const auto count = std::max(at_least, static_cast<Index>(std::ceil(total - 0.15)));
  std::vector<double> result{0};
  std::size_t k = 0;
  for (Index i = 1; i < count; ++i) {
    const double wanted = total * i / count;
    while (integral[k + 1] < wanted) ++k;
    const double share = (wanted - integral[k]) / (integral[k + 1] - integral[k]);
    result.push_back(at[k] + share * (at[k + 1] - at[k]));
  }
  result.push_back(length);
  return result;
}

}  // namespace parison::remesh
