// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/dxf/dxf_curves.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::Point;
using core::Segment;

/// All values of a group code of an entity, in their order.
std::vector<double> values_of(const DxfFile& file, const DxfEntity& entity, int code) {
  std::vector<double> values;
  for (const DxfGroup& group : entity.groups)
    if (group.code == code) values.push_back(file.number(group));
  return values;
}

double value_of(const DxfFile& file, const DxfEntity& entity, int code, double otherwise) {
  const auto values = values_of(file, entity, code);
  return values.empty() ? otherwise : values.front();
}

std::vector<Point> points_of(const DxfFile& file, const DxfEntity& entity, int code, double unit) {
  const auto x = values_of(file, entity, code), y = values_of(file, entity, code + 10);
  if (x.size() != y.size())
    file.refuse(entity.line,
                fmt::format("a {} with {} values of group {} and {} of group {} was found, allowed are pairs",
                            entity.kind, x.size(), code, y.size(), code + 10));
  std::vector<Point> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back(unit * Point(x[i], y[i]));
  return points;
}

double extent(const std::vector<Point>& points) {
  double size = 0;
  for (const Point& x : points) size = std::max(size, (x - points.front()).norm());
  return size;
}

void check_spline(const DxfFile& file, const DxfEntity& entity, const Spline& spline, double degree) {
  constexpr double highest = 10;
  if (!(degree >= 1 && degree <= highest && degree == std::floor(degree)))
    file.refuse(entity.line, fmt::format("a SPLINE of degree {:g} was found, allowed are 1 to {:g}", degree, highest));
  if (spline.points.size() <= spline.degree || spline.knots.size() != spline.points.size() + spline.degree + 1)
    file.refuse(
        entity.line,
        fmt::format("a SPLINE of degree {} with {} control points and {} knots was found, allowed are as many knots "
                    "as control points and degree and 1 together",
                    spline.degree, spline.points.size(), spline.knots.size()));
  if (!std::is_sorted(spline.knots.begin(), spline.knots.end()))
    file.refuse(entity.line, "a SPLINE whose knots fall was found, allowed are rising knots");
  for (const Eigen::Vector3d& point : spline.points)
    if (!(point[2] > 1e-9 && point[2] < 1e9))
      file.refuse(entity.line,
                  fmt::format("a SPLINE with the weight {:g} was found, allowed are weights above zero", point[2]));
}

/// The direction that two groups name; nothing without them or for one without length.
std::optional<Point> direction_of(const DxfFile& file, const DxfEntity& entity, int code) {
  const Point direction(value_of(file, entity, code, 0), value_of(file, entity, code + 10, 0));
  if (direction.norm() > 1e-9) return direction;
  return {};
}

/// A SPLINE that has only the points it goes through: a point that is repeated counts once.
std::vector<Segment> through_points(const DxfFile& file, const DxfEntity& entity, double unit, bool closed) {
  const auto drawn = points_of(file, entity, 11, unit);
  const double same = tolerance::joined * extent(drawn);
  std::vector<Point> points;
  for (const Point& x : drawn)
    if (points.empty() || (x - points.back()).norm() > same) points.push_back(x);
  if (closed && points.size() > 1 && (points.front() - points.back()).norm() <= same) points.pop_back();
  if (points.size() < (closed ? 3 : 2))
    file.refuse(entity.line, fmt::format("a SPLINE without control points and with {} different points to go through "
                                         "was found, allowed are at least {}",
                                         points.size(), closed ? 3 : 2));
  return smooth_through(std::move(points), curve_tolerance(extent(drawn)),
                        {direction_of(file, entity, 12), direction_of(file, entity, 13), closed});
}

}  // namespace

double sweep_of(const DxfFile& file, const DxfEntity& entity, double from, double to, double turn) {
  constexpr double rounded = 1e-5;  // of a turn: what four decimals of an angle leave
  double difference = to - from;
  if (std::max(std::abs(from), std::abs(to)) > 10 * turn)
    file.refuse(entity.line,
                fmt::format("an {} from {:g} to {:g} was found, allowed are up to ten turns", entity.kind, from, to));
  if (difference > turn * (1 + rounded)) difference = std::fmod(difference, turn);
  if (difference <= 0) difference = turn - std::fmod(-difference, turn);
  return std::min(difference, turn);
}

std::vector<Segment> dxf_ellipse(const DxfFile& file, const DxfEntity& entity, double unit) {
  const auto centre = points_of(file, entity, 10, unit), axis = points_of(file, entity, 11, unit);
  const double ratio = value_of(file, entity, 40, 0), from = value_of(file, entity, 41, 0);
  if (centre.size() != 1 || axis.size() != 1 || !(axis[0].norm() > 0) || !(ratio > 1e-6 && ratio <= 1))
    file.refuse(entity.line,
                "an ELLIPSE without centre, major axis and a ratio from 0 to 1 was found, allowed is one with them");
  const double sweep = sweep_of(file, entity, from, value_of(file, entity, 42, 2 * M_PI), 2 * M_PI);
  const double side = value_of(file, entity, 230, 1) < 0 ? -1 : 1;  // seen from behind it turns the other way
  const Point &major = axis[0], minor = side * ratio * Point(-major[1], major[0]);
  const auto curve = [&](double t) -> CurvePoint {
    return {centre[0] + std::cos(t) * major + std::sin(t) * minor, -std::sin(t) * major + std::cos(t) * minor};
  };
  std::vector<Segment> arcs;
  constexpr int parts = 4;
  for (int i = 0; i < parts; ++i) {
    const auto part =
        arcs_of(curve, from + sweep * i / parts, from + sweep * (i + 1) / parts, curve_tolerance(major.norm()));
    arcs.insert(arcs.end(), part.begin(), part.end());
  }
  return arcs;
}

std::vector<Segment> dxf_spline(const DxfFile& file, const DxfEntity& entity, double unit) {
  const auto control = points_of(file, entity, 10, unit);
  const double flags = value_of(file, entity, 70, 0);
  const bool closed = std::fmod(std::abs(flags), 2) == 1;
  if (control.empty()) return through_points(file, entity, unit, closed);
  const double degree = value_of(file, entity, 71, 3);
  Spline spline{static_cast<std::size_t>(std::clamp(degree, 0.0, 100.0)), values_of(file, entity, 40), {}};
  const auto weights = values_of(file, entity, 41);
  if (!weights.empty() && weights.size() != control.size())
    file.refuse(entity.line,
                fmt::format("a SPLINE with {} control points and {} weights was found, allowed is one weight "
                            "for each",
                            control.size(), weights.size()));
  for (std::size_t i = 0; i < control.size(); ++i) {
    const double w = weights.empty() ? 1 : weights[i];
    spline.points.emplace_back(w * control[i][0], w * control[i][1], w);
  }
  check_spline(file, entity, spline, degree);
  auto arcs = arcs_of_spline(spline, curve_tolerance(extent(control)));
  if (closed && !arcs.empty() &&
      (arcs.front().start - arcs.back().end).norm() > tolerance::on_drawing * extent(control))
    file.refuse(entity.line,
                "a SPLINE that says it is closed was found whose ends do not meet, allowed is one whose "
                "knots lead round (explode or convert it in the CAD program)");
  return arcs;
}

}  // namespace parison::forming
