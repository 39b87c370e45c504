// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/camera/temperature_at.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/mesh/element.hpp"

namespace parison::thermal {

namespace {

/// How far reference coordinates lie outside the triangle; 0 or less inside.
double outside(const std::array<double, 2>& at) {
  return std::max({-at[0], -at[1], at[0] + at[1] - 1});
}

}  // namespace

FieldAtPoints::FieldAtPoints(const core::Mesh& mesh, Eigen::VectorXd field) : mesh_(mesh), field_(std::move(field)) {
  core::Point high = low_ = mesh.nodes.front();
  for (const core::Point& x : mesh.nodes) {
    low_ = low_.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const core::Point extent = high - low_;
  width_ = std::sqrt(std::max(extent[0] * extent[1], 1e-6 * extent.squaredNorm()) / mesh.cell_count());
  for (int d = 0; d < 2; ++d) count_[d] = 1 + static_cast<long>(extent[d] / width_);
  cells_.resize(static_cast<std::size_t>(count_[0] * count_[1]));
  for (core::Index c = 0; c < mesh.cell_count(); ++c) {
    maps_.push_back(core::cell_map(mesh, c));
    core::Point from = mesh.nodes[mesh.cells()[c][0]], to = from;
    for (const core::Index node : mesh.cells()[c]) {
      from = from.cwiseMin(mesh.nodes[node]);
      to = to.cwiseMax(mesh.nodes[node]);
    }
    const core::Point margin = 0.1 * (to - from);
    const auto first = bin(from - margin), last = bin(to + margin);
    for (long j = first[1]; j <= last[1]; ++j)
      for (long i = first[0]; i <= last[0]; ++i) cells_[static_cast<std::size_t>(i + count_[0] * j)].push_back(c);
  }
}

std::array<long, 2> FieldAtPoints::bin(const core::Point& x) const {
  std::array<long, 2> at{};
  for (int d = 0; d < 2; ++d)
    at[d] = std::clamp(static_cast<long>(std::floor((x[d] - low_[d]) / width_)), 0L, count_[d] - 1);
  return at;
}

double FieldAtPoints::operator()(const core::Point& x) const {
  const auto at = bin(x);
  double nearest = std::numeric_limits<double>::infinity();
  core::Index cell = -1;
  std::array<double, 2> reference{};
  for (const core::Index c : cells_[static_cast<std::size_t>(at[0] + count_[0] * at[1])]) {
    const auto found = core::invert(maps_[static_cast<std::size_t>(c)], x);
    const double off = outside(found);
    if (!(off < nearest)) continue;
    nearest = off, cell = c, reference = found;
    if (off <= 0) break;
  }
  if (cell < 0) return field_.mean();
  for (double& r : reference) r = std::clamp(r, 0.0, 1.0);
  if (const double sum = reference[0] + reference[1]; sum > 1)
    for (double& r : reference) r /= sum;
  const auto shape = core::triangle_shape(reference[0], reference[1]);
  double value = 0;
  for (int i = 0; i < 6; ++i) value += shape[i] * field_[mesh_.cells()[cell][i]];
  return value;
}

}  // namespace parison::thermal
