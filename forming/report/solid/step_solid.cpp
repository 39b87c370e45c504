// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/step_solid.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>

#include "core/math/numbers.hpp"

namespace parison::forming {
namespace {

using core::Point;
namespace occ = gmsh::model::occ;

/// Whether the outline bends so sharply at a point that it is an edge of the solid: by more than 25 degrees.
bool is_corner(const Point& before, const Point& at, const Point& after) {
  const Point in = (at - before).normalized(), out = (after - at).normalized();
  return in.dot(out) < std::cos(25 * M_PI / 180);
}

/// Derivative at a point of a run by its chord length: that of the parabola through it and its neighbours.
Point derivative(const std::vector<Point>& x, const std::vector<double>& s, std::size_t i) {
  const std::size_t middle = std::clamp(i, std::size_t{1}, x.size() - 2);
  const double before = s[middle] - s[middle - 1], after = s[middle + 1] - s[middle];
  const Point first = (x[middle] - x[middle - 1]) / before, second = (x[middle + 1] - x[middle]) / after;
  const Point curvature = (second - first) / (before + after);
  return first + (2 * (s[i] - s[middle]) + before) * curvature;
}

int add_point(const Point& x) {
  return occ::addPoint(x[0] / core::millimetre, 0, x[1] / core::millimetre);
}

/// A run of the outline between two corners.
struct Run {
  std::vector<Point> points;
  std::vector<double> arc;  ///< by chords, m
};

/// A cubic with continuous tangent through points [begin, end] of a run (Catmull and Rom 1974, chord length as
/// parameter), as a B-spline with double knots: between its ends each stretch has two control points of its own. It
/// follows each point from its neighbours alone, so that one rough place does not spread.
int add_spline(const Run& run, std::size_t begin, std::size_t end, int first, int last) {
  std::vector<int> control{first}, multiplicity{4};
  std::vector<double> knots{run.arc[begin] / core::millimetre};
  for (std::size_t i = begin; i < end; ++i) {
    const double third = (run.arc[i + 1] - run.arc[i]) / 3;
    control.push_back(add_point(run.points[i] + third * derivative(run.points, run.arc, i)));
    control.push_back(add_point(run.points[i + 1] - third * derivative(run.points, run.arc, i + 1)));
    multiplicity.push_back(i + 1 == end ? 4 : 2);
    knots.push_back(run.arc[i + 1] / core::millimetre);
  }
  control.push_back(last);
  return occ::addBSpline(control, -1, 3, {}, knots, multiplicity);
}

bool is_straight(const std::vector<Point>& points) {
  const Point along = points.back() - points.front();
  constexpr double straight = 1e-7;  // m
  return std::all_of(points.begin(), points.end(), [&](const Point& x) {
    const Point to = x - points.front();
    return std::abs(along[0] * to[1] - along[1] * to[0]) <= straight * along.norm();
  });
}

/// A run as a straight line where its points lie on one, else as splines of a few stretches each, which follow each
/// other smoothly: CAD kernels integrate over a face with a fixed number of points.
void add_run(const std::vector<Point>& points, int first, int last, std::vector<int>& curves) {
  if (is_straight(points)) {
    curves.push_back(occ::addLine(first, last));
    return;
  }
  Run run{points, {0}};
  for (std::size_t i = 1; i < points.size(); ++i)
    run.arc.push_back(run.arc.back() + (points[i] - points[i - 1]).norm());
  constexpr std::size_t stretches = 6;
  for (std::size_t begin = 0; begin + 1 < points.size(); begin += stretches) {
    const std::size_t end = std::min(begin + stretches, points.size() - 1);
    const int next = end + 1 == points.size() ? last : add_point(points[end]);
    curves.push_back(add_spline(run, begin, end, first, next));
    first = next;
  }
}

/// A loop is begun at a corner, and closed by its first point.
std::vector<Point> opened(const ContainerShape& shape) {
  std::vector<Point> points = shape.outline;
  if (!shape.is_loop) return points;
  const std::size_t count = points.size();
  std::size_t first = 0;
  while (first + 1 < count &&
         !is_corner(points[(first + count - 1) % count], points[first], points[(first + 1) % count]))
    ++first;
  std::rotate(points.begin(), points.begin() + static_cast<long>(first), points.end());
  points.push_back(points.front());
  return points;
}

}  // namespace

extern "C" void parison_write_solid(const std::string& path, const ContainerShape& shape, std::string& volume_text) {
  const std::vector<Point> points = opened(shape);
  std::vector<int> curves;
  const int start = add_point(points.front());
  std::size_t begin = 0;
  int first = start;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool is_end = i + 1 == points.size();
    if (!is_end && !is_corner(points[i - 1], points[i], points[i + 1])) continue;
    const int last = is_end && shape.is_loop ? start : add_point(points[i]);
    add_run({points.begin() + static_cast<long>(begin), points.begin() + static_cast<long>(i) + 1}, first, last,
            curves);
    begin = i;
    first = last;
  }
  if (!shape.is_loop) curves.push_back(occ::addLine(first, start));
  const int face = occ::addPlaneSurface({occ::addCurveLoop(curves)});
  gmsh::vectorpair made;
  occ::revolve({{2, face}}, 0, 0, 0, 0, 0, 1, 2 * M_PI, made);
  double volume = 0;
  for (const auto& [dimension, tag] : made)
    if (dimension == 3) occ::getMass(3, tag, volume);
  occ::remove({{2, face}});
  occ::synchronize();
  gmsh::write(path);
  volume_text = fmt::format("{}", volume);
}

}  // namespace parison::forming
