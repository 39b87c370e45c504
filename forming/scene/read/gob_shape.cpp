// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/gob_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "forming/scene/read/curves/curve_arcs.hpp"

namespace parison::forming {
namespace {

using core::Point;

constexpr int ball_count = 300, point_count = 120;

/// A ball around a point of the axis; `place` rises against gravity.
struct Ball {
  double place, radius;  ///< m
};

/// Radius of the largest ball around a place on the axis that keeps its clearance; 0 in a solid.
double radius_at(const GobRoom& room, double z) {
  double radius = std::min(z - room.low, room.high - z);
  for (const Solid& solid : room.solids) {
    const Point x(1e-9 * (room.high - room.low), z - solid.shift);
    if (core::contains(*solid.profile, x)) return 0;
    for (const core::Segment& segment : solid.profile->segments) radius = core::distance(segment, x, radius);
  }
  return std::max(0.0, radius - room.clearance);
}

/// The balls of the rooms along the axis, each from above.
std::vector<std::vector<Ball>> rooms_along(const GobRoom& room) {
  std::vector<std::vector<Ball>> rooms(1);
  for (int i = ball_count; i >= 0; --i) {
    const double rise = double(i) / ball_count * (room.high - room.low);
    const double z = room.up > 0 ? room.low + rise : room.high - rise, radius = radius_at(room, z);
    if (radius > 0)
      rooms.back().push_back({room.up * z, radius});
    else if (!rooms.back().empty())
      rooms.emplace_back();
  }
  return rooms;
}

/// The balls of the largest room, from below; none is wider than a throat above it. A smaller one is a bore of a tool.
std::vector<Ball> balls_in(const GobRoom& room) {
  const auto section = [](const std::vector<Ball>& balls) {
    return std::accumulate(balls.begin(), balls.end(), 0.0,
                           [](double sum, const Ball& ball) { return sum + ball.radius * ball.radius; });
  };
  auto rooms = rooms_along(room);
  auto& balls =
      *std::max_element(rooms.begin(), rooms.end(), [&](auto& a, auto& b) { return section(a) < section(b); });
  const auto widest =
      std::max_element(balls.begin(), balls.end(), [](auto& a, auto& b) { return a.radius < b.radius; });
  for (auto ball = widest; ball != balls.end(); ++ball)
    if (ball != widest) ball->radius = std::min(ball->radius, (ball - 1)->radius);
  std::reverse(balls.begin(), balls.end());
  return balls;
}

/// Square of the radius of the balls' envelope; the radius is linear between two of them.
double envelope(const std::vector<Ball>& balls, double place) {
  double found = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Ball& a = balls[i];
    const auto square = [&](double p, double r) { found = std::max(found, r * r - (place - p) * (place - p)); };
    square(a.place, a.radius);
    if (i + 1 == balls.size()) break;
    const Ball& b = balls[i + 1];
    const double slope = (b.radius - a.radius) / (b.place - a.place);
    if (std::abs(slope) >= 1) continue;
    const double best = (place + slope * (a.radius - slope * a.place)) / (1 - slope * slope);
    if (best > a.place && best < b.place) square(best, a.radius + slope * (best - a.place));
  }
  return found;
}

/// Points of the envelope between its ends on the axis: radius and place; dense at the ends, where it is round.
std::vector<Point> outline_of(const std::vector<Ball>& balls) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Ball& ball : balls) {
    low = std::min(low, ball.place - ball.radius);
    high = std::max(high, ball.place + ball.radius);
  }
  std::vector<Point> points;
  for (int i = 0; i <= point_count; ++i) {
    const double place = (low + high) / 2 - (high - low) / 2 * std::cos(M_PI * i / point_count);
    const bool is_end = i == 0 || i == point_count;
    points.emplace_back(is_end ? 0 : std::sqrt(envelope(balls, place)), place);
  }
  return points;
}

double volume_of(const std::vector<Point>& points) {
  double volume = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double a = points[i - 1][0], b = points[i][0];
    volume += M_PI / 3 * (a * a + a * b + b * b) * (points[i][1] - points[i - 1][1]);
  }
  return volume;
}

/// The balls up to a place, with one there.
std::vector<Ball> filled_to(const std::vector<Ball>& balls, double place) {
  std::vector<Ball> below;
  for (const Ball& ball : balls) {
    if (ball.place >= place) {
      if (below.empty()) return {ball};
      const Ball& last = below.back();
      const double share = (place - last.place) / (ball.place - last.place);
      below.push_back({place, last.radius + share * (ball.radius - last.radius)});
      break;
    }
    below.push_back(ball);
  }
  return below;
}

}  // namespace

GobShape shape_gob(const GobRoom& room, double volume) {
  const std::vector<Ball> balls = balls_in(room);
  GobShape shape;
  if (balls.size() < 3) return shape;
  shape.most = volume_of(outline_of(balls));
  if (volume > shape.most) return shape;
  double low = balls.front().place, high = balls.back().place;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (volume_of(outline_of(filled_to(balls, middle))) < volume ? low : high) = middle;
  }
  std::vector<Point> points = outline_of(filled_to(balls, high));
  const auto is_below = [&](const Point& x) { return x[1] < high; };
  auto top = std::size_t(std::find_if_not(points.begin() + 1, points.end() - 1, is_below) - points.begin());
  if (room.up < 0) std::reverse(points.begin(), points.end()), top = points.size() - 1 - top;
  for (Point& x : points) x[1] *= room.up;
  const auto part = [&](std::size_t from, std::size_t to) {
    return std::vector<Point>(points.begin() + std::ptrdiff_t(from), points.begin() + std::ptrdiff_t(to) + 1);
  };
  const double tolerance = curve_tolerance(room.high - room.low);
  const Point out(1, 0), back(-1, 0), along = points[top + 1] - points[top - 1];
  shape.sides = smooth_through(part(0, top), tolerance, {out, along});
  const std::size_t before = shape.sides.size();
  for (const core::Segment& arc : smooth_through(part(top, points.size() - 1), tolerance, {along, back}))
    shape.sides.push_back(arc);
  shape.first_top = room.up > 0 ? before : 0;
  shape.tops = room.up > 0 ? shape.sides.size() - before : before;
  return shape;
}

}  // namespace parison::forming
