// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/curves/curve_arcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {

std::vector<core::Segment> mirrored(const std::vector<core::Segment>& path, const core::Point& first,
                                    const core::Point& second) {
  const core::Point along = (second - first).normalized();
  const double turn = 2 * std::atan2(along[1], along[0]);
  const auto image = [&](const core::Point& x) -> core::Point {
    const core::Point from = x - first;
    return first + 2 * from.dot(along) * along - from;
  };
  std::vector<core::Segment> result;
  const auto line_to = [&](const core::Point& x) {
    result.emplace_back();
    result.back().end = image(x);
  };
  for (std::size_t i = path.size(); i-- > 0;) {
    const core::Segment& part = path[i];
    line_to(part.end);
    if (!part.is_arc) continue;
    core::Segment arc = part;
    arc.start = image(part.end);
    arc.end = image(part.start);
    arc.centre = image(part.centre);
    arc.from = turn - part.to;
    arc.to = turn - part.from;
    result.push_back(arc);
  }
  return result;
}

namespace {

using core::Point;
using Weighted = Eigen::Vector3d;

/// The place and derivative within a span of knots by the algorithm of de Boor (C. de Boor, J. Approximation Theory 6
/// (1972) 50-62).
CurvePoint place_on(const Spline& spline, double t, std::size_t span) {
  const std::size_t degree = spline.degree;
  const auto& knots = spline.knots;
  std::vector<Weighted> d(spline.points.begin() + static_cast<std::ptrdiff_t>(span - degree),
                          spline.points.begin() + static_cast<std::ptrdiff_t>(span + 1));
  Weighted rate = Weighted::Zero();
  for (std::size_t r = 1; r <= degree; ++r) {
    if (r == degree) rate = static_cast<double>(degree) * (d[degree] - d[degree - 1]) / (knots[span + 1] - knots[span]);
    for (std::size_t j = degree; j >= r; --j) {
      const double first = knots[j + span - degree], width = knots[j + 1 + span - r] - first;
      d[j] += (t - first) / width * (d[j] - d[j - 1]) - (d[j] - d[j - 1]);
    }
  }
  const double w = d[degree][2];
  const Point x = d[degree].head<2>() / w;
  return {x, (rate.head<2>() - rate[2] * x) / w};
}

}  // namespace

std::vector<core::Segment> arcs_of_spline(const Spline& spline, double tolerance) {
  std::vector<core::Segment> arcs;
  const double least = 1e-9 * (spline.knots.back() - spline.knots.front());
  // A polynomial of high degree bends often in one span.
  const std::size_t parts = spline.degree > 3 ? spline.degree : 1;
  for (std::size_t span = spline.degree; span < spline.points.size(); ++span) {
    const double first = spline.knots[span], width = spline.knots[span + 1] - first;
    if (!(width > least) || arcs.size() > max_segments) continue;
    const auto curve = [&](double t) { return place_on(spline, t, span); };
    if (spline.degree == 1) {
      arcs.emplace_back();
      arcs.back().start = curve(first).x;
      arcs.back().end = curve(first + width).x;
      continue;
    }
    for (std::size_t i = 0; i < parts; ++i) {
      const auto part = arcs_of(curve, first + width * double(i) / double(parts),
                                first + width * double(i + 1) / double(parts), tolerance);
      arcs.insert(arcs.end(), part.begin(), part.end());
    }
  }
  return arcs;
}

void bend(core::Segment& segment, double turn) {
  const Point along = segment.end - segment.start, left(-along[1], along[0]);
  segment.is_arc = true;
  segment.centre = 0.5 * (segment.start + segment.end) + left / (2 * std::tan(0.5 * turn));
  segment.radius = (segment.start - segment.centre).norm();
  segment.from = std::atan2(segment.start[1] - segment.centre[1], segment.start[0] - segment.centre[0]);
  segment.to = segment.from + turn;
}

namespace {

using core::Segment;

/// From start to end, turning by an angle, positive to the left; a line where it leaves that by less than `straight`,
/// m.
Segment arc_of(const Point& start, const Point& end, double turn, double straight) {
  Segment arc;
  arc.start = start;
  arc.end = end;
  if (std::abs(turn) * (end - start).norm() / 8 >= straight) bend(arc, turn);
  return arc;
}

/// Where the two arcs of a biarc meet: both of their tangents have the same length.
Point joint(const CurvePoint& a, const CurvePoint& b) {
  const Point chord = b.x - a.x, sum = a.derivative + b.derivative;
  const double across = 2 * (1 - a.derivative.dot(b.derivative)), along = chord.dot(sum);
  const double root = std::sqrt(along * along + across * chord.squaredNorm());
  const double tangent = chord.squaredNorm() / (along + root);
  return 0.5 * (a.x + b.x + tangent * (a.derivative - b.derivative));
}

/// Two arcs between places with unit tangents.
std::array<Segment, 2> biarc(const CurvePoint& a, const CurvePoint& b, double straight) {
  const Point middle = joint(a, b), first = middle - a.x, second = b.x - middle;
  return {arc_of(a.x, middle, 2 * std::atan2(core::cross(a.derivative, first), a.derivative.dot(first)), straight),
          arc_of(middle, b.x, 2 * std::atan2(core::cross(second, b.derivative), second.dot(b.derivative)), straight)};
}

/// With a unit tangent; where the derivative vanishes, that towards a place nearby.
CurvePoint with_tangent(const PlaneCurve& curve, double at, double nearby) {
  CurvePoint place = curve(at);
  if (place.derivative.norm() == 0) place.derivative = (curve(at + 1e-6 * (nearby - at)).x - place.x) * (nearby - at);
  if (place.derivative.norm() > 0) place.derivative.normalize();
  return place;
}

struct Fit {
  const PlaneCurve& curve;
  double tolerance;
  std::vector<Segment> segments;

  bool is_near(const std::array<Segment, 2>& arcs, double from, double to) const {
    constexpr int samples = 8;
    for (int i = 1; i < samples; ++i) {
      const Point x = curve(from + (to - from) * i / samples).x;
      double distance = std::numeric_limits<double>::infinity();
      for (const Segment& arc : arcs) distance = core::distance(arc, x, distance);
      if (!(distance <= tolerance)) return false;
    }
    return true;
  }

  void add(double from, double to, int depth) {
    constexpr std::size_t too_many = 20'000;  // more than any outline may have
    if (segments.size() > too_many) return;
    constexpr int deepest = 14;
    constexpr double most = M_PI / 2;  // turned by a pair of arcs
    const CurvePoint a = with_tangent(curve, from, to), b = with_tangent(curve, to, from);
    const double turn = std::abs(std::atan2(core::cross(a.derivative, b.derivative), a.derivative.dot(b.derivative)));
    const auto arcs = biarc(a, b, 1e-2 * tolerance);
    if (depth < deepest && (turn > most || !is_near(arcs, from, to))) {
      const double middle = 0.5 * (from + to);
      add(from, middle, depth + 1);
      add(middle, to, depth + 1);
      return;
    }
    if (!arcs[0].end.allFinite()) return segments.push_back(arc_of(a.x, b.x, 0, tolerance));
    for (const Segment& arc : arcs)
      if ((arc.end - arc.start).norm() > 0) segments.push_back(arc);
  }
};

/// Solves slope[i-1] / width[i-1] + 2 (1 / width[i-1] + 1 / width[i]) slope[i] + slope[i+1] / width[i] = ..., which
/// makes the second derivative continuous, where the first and the last slope are known.
void solve_inner_slopes(const std::vector<double>& at, const std::vector<Point>& x, std::vector<Point>& slope) {
  const std::size_t last = x.size() - 1;
  std::vector<double> factor(x.size(), 0);
  for (std::size_t i = 1; i < last; ++i) {
    const double before = 1 / (at[i] - at[i - 1]), after = 1 / (at[i + 1] - at[i]),
                 diagonal = 2 * (before + after) - before * factor[i - 1];
    factor[i] = after / diagonal;
    slope[i] = (3 * (before * before * (x[i] - x[i - 1]) + after * after * (x[i + 1] - x[i])) - before * slope[i - 1]) /
               diagonal;
  }
  for (std::size_t i = last - 1; i > 0; --i) slope[i] -= factor[i] * slope[i + 1];
}

/// The slopes of the cubics through values over rising places.
std::vector<Point> slopes(const std::vector<double>& at, const std::vector<Point>& x, const CurveEnds& ends) {
  const std::size_t last = x.size() - 1;
  const auto width = [&](std::size_t i) { return at[i + 1] - at[i]; };
  const auto chord = [&](std::size_t i) -> Point { return (x[i + 1] - x[i]) / width(i); };
  std::vector<Point> slope(x.size());
  const bool is_parabola = last > 1;  // else a line
  if (ends.start)
    slope[0] = ends.start->normalized();
  else
    slope[0] = is_parabola ? Point(chord(0) - (chord(1) - chord(0)) * width(0) / (width(0) + width(1))) : chord(0);
  if (ends.end)
    slope[last] = ends.end->normalized();
  else
    slope[last] = is_parabola ? Point(chord(last - 1) + (chord(last - 1) - chord(last - 2)) * width(last - 1) /
                                                            (width(last - 1) + width(last - 2)))
                              : chord(last - 1);
  solve_inner_slopes(at, x, slope);
  return slope;
}

/// The same of a closed curve, whose last point is the first: the common slope there makes the curvature the same on
/// both sides. The slopes are linear in it, so that two of its values tell all.
std::vector<Point> closed_slopes(const std::vector<double>& at, const std::vector<Point>& x) {
  const std::size_t last = x.size() - 1;
  const double after = 1 / (at[1] - at[0]), before = 1 / (at[last] - at[last - 1]);
  std::vector<Point> zero(x.size(), Point::Zero()), one = zero;
  one.front() = one.back() = Point::Ones();
  solve_inner_slopes(at, x, zero);
  solve_inner_slopes(at, x, one);
  const Point load = 3 * (before * before * (x[last] - x[last - 1]) + after * after * (x[1] - x[0]));
  const auto rest = [&](const std::vector<Point>& slope) -> Point {
    return before * slope[last - 1] + 2 * (before + after) * slope[0] + after * slope[1] - load;
  };
  const Point at_zero = rest(zero), share = at_zero.array() / (at_zero - rest(one)).array();
  for (std::size_t i = 0; i <= last; ++i) zero[i] += (share.array() * (one[i] - zero[i]).array()).matrix();
  return zero;
}

}  // namespace

double curve_tolerance(double size) {
  constexpr double largest = 0.9e-6;  // m; the distance is measured at samples
  return std::min(tolerance::curve * size, largest);
}

std::vector<Segment> arcs_of(const PlaneCurve& curve, double from, double to, double tolerance) {
  Fit fit{curve, tolerance, {}};
  fit.add(from, to, 0);
  return std::move(fit.segments);
}

PlaneCurve cubic(const CurvePoint& start, const CurvePoint& end) {
  return [start, end](double t) -> CurvePoint {
    const double s = 1 - t;
    return {s * s * (1 + 2 * t) * start.x + t * t * (1 + 2 * s) * end.x + s * s * t * start.derivative -
                t * t * s * end.derivative,
            6 * s * t * (end.x - start.x) + s * (s - 2 * t) * start.derivative + t * (t - 2 * s) * end.derivative};
  };
}

std::vector<Segment> smooth_through(std::vector<Point> points, double tolerance, const CurveEnds& ends) {
  if (ends.closed) points.push_back(points.front());
  std::vector<double> at{0};
  for (std::size_t i = 1; i < points.size(); ++i) at.push_back(at.back() + (points[i] - points[i - 1]).norm());
  const auto slope = ends.closed ? closed_slopes(at, points) : slopes(at, points, ends);
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double width = at[i + 1] - at[i];
    const auto arcs =
        arcs_of(cubic({points[i], width * slope[i]}, {points[i + 1], width * slope[i + 1]}), 0, 1, tolerance);
    segments.insert(segments.end(), arcs.begin(), arcs.end());
  }
  return segments;
}

}  // namespace parison::forming
