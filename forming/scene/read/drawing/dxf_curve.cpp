// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/dxf_curve.hpp"

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
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

using Weighted = Eigen::Vector3d;  ///< x w, y w, w

/// A rational B-spline over its knots.
struct Spline {
  std::size_t degree;
  std::vector<double> knots;
  std::vector<Weighted> points;

  /// The place and derivative within a span of knots by the algorithm of de Boor (C. de Boor, J. Approximation Theory 6
  /// (1972) 50-62).
  CurvePoint at(double t, std::size_t span) const {
    std::vector<Weighted> d(points.begin() + static_cast<std::ptrdiff_t>(span - degree),
                            points.begin() + static_cast<std::ptrdiff_t>(span + 1));
    Weighted rate = Weighted::Zero();
    for (std::size_t r = 1; r <= degree; ++r) {
      if (r == degree)
        rate = static_cast<double>(degree) * (d[degree] - d[degree - 1]) / (knots[span + 1] - knots[span]);
      for (std::size_t j = degree; j >= r; --j) {
        const double first = knots[j + span - degree], width = knots[j + 1 + span - r] - first;
        d[j] += (t - first) / width * (d[j] - d[j - 1]) - (d[j] - d[j - 1]);
      }
    }
    const double w = d[degree][2];
    const Point x = d[degree].head<2>() / w;
    return {x, (rate.head<2>() - rate[2] * x) / w};
  }
};

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
  for (const Weighted& point : spline.points)
    if (!(point[2] > 1e-9 && point[2] < 1e9))
      file.refuse(entity.line,
                  fmt::format("a SPLINE with the weight {:g} was found, allowed are weights above zero", point[2]));
}

}  // namespace

std::vector<Segment> dxf_ellipse(const DxfFile& file, const DxfEntity& entity, double unit) {
  const auto centre = points_of(file, entity, 10, unit), axis = points_of(file, entity, 11, unit);
  const double ratio = value_of(file, entity, 40, 0), from = value_of(file, entity, 41, 0);
  double to = value_of(file, entity, 42, 2 * M_PI);
  if (centre.size() != 1 || axis.size() != 1 || !(axis[0].norm() > 0) || !(ratio > 1e-6 && ratio <= 1))
    file.refuse(entity.line,
                "an ELLIPSE without centre, major axis and a ratio from 0 to 1 was found, allowed is one with them");
  if (to <= from) to += 2 * M_PI;
  if (!(to > from && to - from <= 2 * M_PI * (1 + 1e-9)))
    file.refuse(entity.line,
                fmt::format("an ELLIPSE from {:g} to {:g} rad was found, allowed is up to one turn", from, to));
  const Point &major = axis[0], minor = ratio * Point(-major[1], major[0]);
  const auto curve = [&](double t) -> CurvePoint {
    return {centre[0] + std::cos(t) * major + std::sin(t) * minor, -std::sin(t) * major + std::cos(t) * minor};
  };
  std::vector<Segment> arcs;
  constexpr int parts = 4;
  for (int i = 0; i < parts; ++i) {
    const auto part = arcs_of(curve, from + (to - from) * i / parts, from + (to - from) * (i + 1) / parts,
                              tolerance::curve * major.norm());
    arcs.insert(arcs.end(), part.begin(), part.end());
  }
  return arcs;
}

std::vector<Segment> dxf_spline(const DxfFile& file, const DxfEntity& entity, double unit) {
  const auto control = points_of(file, entity, 10, unit), through = points_of(file, entity, 11, unit);
  if (control.empty() && through.size() >= 3) return smooth_through(through, tolerance::curve * extent(through));
  if (control.empty())
    file.refuse(entity.line,
                "a SPLINE without control points and without three points to go through was found, allowed is "
                "one with them");
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
  std::vector<Segment> arcs;
  const double least = 1e-9 * (spline.knots.back() - spline.knots.front());
  for (std::size_t span = spline.degree; span < spline.points.size(); ++span) {
    if (!(spline.knots[span + 1] - spline.knots[span] > least) || arcs.size() > max_segments) continue;
    const auto part = arcs_of([&](double t) { return spline.at(t, span); }, spline.knots[span], spline.knots[span + 1],
                              tolerance::curve * extent(control));
    arcs.insert(arcs.end(), part.begin(), part.end());
  }
  return arcs;
}

}  // namespace parison::forming
