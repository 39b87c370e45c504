// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/rays/zones.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace parison::thermal {

namespace {

constexpr double sliver = 0.2;      ///< section area of a box that is joined with a neighbour, of a full one's
constexpr int fewest_points = 6;    ///< of the mesh in a box that is not joined
constexpr double most_boxes = 400;  ///< along either axis, for meshes that have gone wild
constexpr double thinnest = 1e-4;   ///< second moment, of that of the box, below which a zone has no slope that way

}  // namespace

Zones::Zones(const std::vector<Point>& position, const std::vector<double>& volume, const std::vector<double>& area,
             int count) {
  h_ = std::sqrt(std::accumulate(area.begin(), area.end(), 0.0) / count);
  if (!(h_ > 0)) h_ = 1;  // the mesh is inside out
  low_ = position.front();
  Point high = low_;
  for (const Point& x : position) low_ = low_.cwiseMin(x), high = high.cwiseMax(x);
  for (int a = 0; a < 2; ++a) {
    boxes_[a] = static_cast<Index>(std::clamp(std::ceil((high[a] - low_[a]) / h_), 1.0, most_boxes));
    low_[a] = 0.5 * (low_[a] + high[a] - boxes_[a] * h_);
  }
  std::vector<double> in_box(boxes_[0] * boxes_[1], 0.0);
  std::vector<int> points(in_box.size(), 0);
  for (std::size_t q = 0; q < position.size(); ++q) {
    in_box[box_at(position[q])] += area[q];
    ++points[box_at(position[q])];
  }
  join_slivers(in_box, points);
  fill_gaps();
  const auto zones = static_cast<std::size_t>(*std::max_element(zone_of_box_.begin(), zone_of_box_.end()) + 1);
  zone_.assign(zones, {Point::Zero(), 0, {}});
  std::vector<Index> of_point(position.size());
  for (std::size_t q = 0; q < position.size(); ++q) {
    Zone& zone = zone_[of_point[q] = at(position[q])];
    zone.volume += volume[q];
    zone.centre += volume[q] * position[q];
  }
  for (Zone& zone : zone_) zone.centre /= zone.volume;
  std::vector<std::array<double, 3>> moments(zones, {0, 0, 0});
  for (std::size_t q = 0; q < position.size(); ++q) {
    const Point x = position[q] - zone_[of_point[q]].centre;
    auto& m = moments[of_point[q]];
    m[0] += volume[q] * x[0] * x[0];
    m[1] += volume[q] * x[0] * x[1];
    m[2] += volume[q] * x[1] * x[1];
  }
  one_.setZero(function_count());
  for (std::size_t z = 0; z < zones; ++z) {
    const auto& m = moments[z];
    const double least = thinnest * zone_[z].volume * h_ * h_ / 12;
    auto& [a, b, c] = zone_[z].second;
    a = b = c = 0;
    if (m[0] > least) a = 1 / std::sqrt(m[0]);
    const double rest = m[2] - m[1] * m[1] * a * a;
    if (rest > least) c = 1 / std::sqrt(rest), b = -m[1] * a * a * c;
    one_[zone_functions * static_cast<Index>(z)] = std::sqrt(zone_[z].volume);
  }
}

Index Zones::box_at(const Point& x) const {
  std::array<Index, 2> i;
  for (int a = 0; a < 2; ++a)
    i[a] = std::clamp<Index>(static_cast<Index>(std::floor((x[a] - low_[a]) / h_)), 0, boxes_[a] - 1);
  return i[1] * boxes_[0] + i[0];
}

Index Zones::at(const Point& x) const {
  return zone_of_box_[box_at(x)];
}

std::vector<Index> Zones::neighbours(Index i, Index j) const {
  std::vector<Index> boxes;
  for (const auto& [i2, j2] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}})
    if (i2 >= 0 && j2 >= 0 && i2 < boxes_[0] && j2 < boxes_[1]) boxes.push_back(j2 * boxes_[0] + i2);
  return boxes;
}

/// Numbers the boxes that are zones; a sliver has the number of its neighbour with the largest area.
void Zones::join_slivers(const std::vector<double>& area, const std::vector<int>& points) {
  const double least = sliver * h_ * h_;
  const auto is_sliver = [&](Index box) { return area[box] < least || points[box] < fewest_points; };
  zone_of_box_.assign(area.size(), -1);
  std::vector<Index> joined(area.size(), -1);
  for (Index j = 0; j < boxes_[1]; ++j)
    for (Index i = 0; i < boxes_[0]; ++i) {
      const Index box = j * boxes_[0] + i;
      if (points[box] == 0 || !is_sliver(box)) continue;
      double most = 0;
      for (const Index other : neighbours(i, j))
        if (!is_sliver(other) && area[other] > most) most = area[joined[box] = other];
    }
  Index count = 0;
  for (std::size_t box = 0; box < area.size(); ++box)
    if (points[box] > 0 && joined[box] < 0) zone_of_box_[box] = count++;
  for (std::size_t box = 0; box < area.size(); ++box)
    if (joined[box] >= 0) zone_of_box_[box] = zone_of_box_[joined[box]];
}

/// Boxes without a quadrature point, where rays may pass all the same, belong to the zone of a neighbour.
void Zones::fill_gaps() {
  for (bool more = true; more;) {
    more = false;
    const std::vector<Index> before = zone_of_box_;
    for (Index j = 0; j < boxes_[1]; ++j)
      for (Index i = 0; i < boxes_[0]; ++i) {
        Index& zone = zone_of_box_[j * boxes_[0] + i];
        if (zone >= 0) continue;
        for (const Index other : neighbours(i, j))
          if (before[other] >= 0) zone = before[other];
        more = more || zone < 0;
      }
  }
}

ZoneValues Zones::values(Index z, const Point& at) const {
  const Zone& zone = zone_[z];
  const Point x = at - zone.centre;
  const auto& [a, b, c] = zone.second;
  return {1 / std::sqrt(zone.volume), a * x[0], b * x[0] + c * x[1]};
}

}  // namespace parison::thermal
