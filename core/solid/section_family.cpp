// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/section_family.hpp"

#include <algorithm>
#include <cmath>

#include "core/solid/section_table.hpp"

namespace parison::core {

namespace {

/// Value and its derivatives with respect to x and y, both not negative.
struct Gauge {
  double value, dx, dy;
};

/// Of the superellipse |x|^n + |y/depth|^n = value^n.
Gauge superellipse(double x, double y, double depth, double n) {
  const double across = y / depth, larger = std::max(x, across);
  if (larger == 0) return {0, 0, 0};
  const double u = x / larger, v = across / larger;
  const double scaled = std::pow(std::pow(u, n) + std::pow(v, n), 1 / n);
  const auto slope = [&](double share) { return std::pow(share / scaled, n - 1); };
  return {larger * scaled, slope(u), slope(v) / depth};
}

/// Of the rectangle with half sides `value` and `depth` times it, its corners rounded by `corner` times it.
Gauge rounded_rectangle(double x, double y, double depth, double corner) {
  const double a = 1 - corner, b = depth - corner;  // centre of the corner's arc
  if (y <= x * b) return {x, 1, 0};
  if (x * depth <= y * a) return {y / depth, 0, 1 / depth};
  const double square = a * a + b * b - corner * corner, along = x * a + y * b, far = x * x + y * y;
  const double value = far / (along + std::sqrt(std::max(0.0, along * along - square * far)));
  const double from_x = x - value * a, from_y = y - value * b;
  const double slope = a * from_x + b * from_y + corner * corner * value;
  return {value, from_x / slope, from_y / slope};
}

Gauge gauge(const MeasuredSections& measured, double x, double y, double height) {
  const double far = std::hypot(x, y);
  if (far == 0) return {0, 0, 0};
  const auto [value, by_far, by_angle] = measured.half_width(far, height, std::atan2(y, x));
  const double along = by_far / far, turn = by_angle / (far * far);  // the angle grows by (-y, x) / far^2
  return {value, along * x - turn * y, along * y + turn * x};
}

Gauge gauge(const SectionFamily& family, double x, double y, double height) {
  if (family.measured) return gauge(*family.measured, x, y, height);
  const double depth = family.depth.y.empty() ? 1 : family.depth(height);
  if (!family.corner.y.empty()) return rounded_rectangle(x, y, depth, std::min({family.corner(height), 1.0, depth}));
  return superellipse(x, y, depth, family.exponent.y.empty() ? 2 : family.exponent(height));
}

}  // namespace

double half_width_value(const SectionFamily& family, const Vector3& at) {
  if (family.is_round()) return std::hypot(at[0], at[1]);
  return gauge(family, std::abs(at[0]), std::abs(at[1]), at[2]).value;
}

HalfWidth half_width(const SectionFamily& family, const Vector3& at) {
  if (family.is_round()) {
    const double radius = std::hypot(at[0], at[1]);
    const Vector3 outward = radius == 0 ? Vector3::Zero() : Vector3(at[0] / radius, at[1] / radius, 0);
    return {radius, outward};
  }
  const Gauge here = gauge(family, std::abs(at[0]), std::abs(at[1]), at[2]);
  constexpr double apart = 1e-7;  // m: the shapes change over millimetres
  const Vector3 up = apart * Vector3::UnitZ();
  const double rise = (half_width_value(family, at + up) - half_width_value(family, at - up)) / (2 * apart);
  return {here.value, {std::copysign(1, at[0]) * here.dx, std::copysign(1, at[1]) * here.dy, rise}};
}

double reach(const SectionFamily& family, const Point& place, double angle) {
  if (family.is_round() || place[0] == 0) return 1;
  const double x = std::cos(angle), y = std::sin(angle);
  if (family.measured) return family.measured->far(place[0], place[1], std::atan2(std::abs(y), std::abs(x))) / place[0];
  return 1 / half_width_value(family, {x, y, place[1]});
}

double area_factor(const SectionFamily& family, double height) {
  if (family.is_round()) return 1;
  if (family.measured) return family.measured->area_factor(height);
  const double depth = family.depth.y.empty() ? 1 : family.depth(height);
  if (!family.corner.y.empty()) {
    const double corner = std::min({family.corner(height), 1.0, depth});
    return (4 * depth - (4 - M_PI) * corner * corner) / M_PI;
  }
  // J. Gielis' superellipse: 4 a b Gamma(1 + 1/n)^2 / Gamma(1 + 2/n).
  const double n = family.exponent.y.empty() ? 2 : family.exponent(height);
  return 4 * depth * std::exp(2 * std::lgamma(1 + 1 / n) - std::lgamma(1 + 2 / n)) / M_PI;
}

}  // namespace parison::core
