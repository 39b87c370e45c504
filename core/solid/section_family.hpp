#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "core/case/table.hpp"
#include "core/solid/hex_mesh.hpp"

namespace parison::core {

struct MeasuredSections;

/// Horizontal sections of a tool that is not round, over its height: an outline drawn in the plane y = 0 gives half the
/// width in x, these shapes the rest. Every section is symmetric about both planes. A rounded rectangle has a corner
/// radius, a superellipse |x/a|^n + |y/b|^n = 1 an exponent; without either the section is an ellipse. Or they were
/// measured, which is all then.
struct SectionFamily {
  Table depth;     ///< half the depth in y over half the width, by height, m; empty: 1
  Table corner;    ///< corner radius over half the width, by height; empty: no rounded rectangle
  Table exponent;  ///< n by height; empty: no superellipse
  std::shared_ptr<const MeasuredSections> measured = nullptr;

  bool is_round() const { return depth.y.empty() && corner.y.empty() && exponent.y.empty() && !measured; }
};

/// Half the width of the section of a family that passes through a point, m, and its gradient.
struct HalfWidth {
  double value;
  Vector3 gradient;
};
HalfWidth half_width(const SectionFamily& family, const Vector3& at);
/// The same without the gradient.
double half_width_value(const SectionFamily& family, const Vector3& at);

/// How far from the axis the place (half width, height) of the outline is at an angle from x, rad, over its half width.
double reach(const SectionFamily& family, const Point& place, double angle);

/// Area of a section over that of the circle with half its width.
double area_factor(const SectionFamily& family, double height);

}  // namespace parison::core
