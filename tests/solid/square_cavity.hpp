#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "contact/solid/tool_surface.hpp"

namespace parison::tests {

using core::Vector3;

/// A square cavity, open above, with round corners and heel, about the axis from its base at 0.
class SquareCavity : public contact::ToolSurface {
 public:
  SquareCavity(double half, double round) : half_(half), round_(round) {}
  contact::SurfaceGap gap(const Vector3& at) const override {
    const Vector3 sides(std::copysign(1.0, at[0]), std::copysign(1.0, at[1]), -1);
    const Vector3 beyond(std::abs(at[0]) - half_ + round_, std::abs(at[1]) - half_ + round_, round_ - at[2]);
    const Vector3 corner = beyond.cwiseMax(0.0);
    if (corner.norm() > 0) return {round_ - corner.norm(), -corner.normalized().cwiseProduct(sides)};
    int axis = 0;
    const double nearest = beyond.maxCoeff(&axis);
    return {round_ - nearest, -sides[axis] * Vector3::Unit(axis)};
  }

 private:
  double half_, round_;
};

}  // namespace parison::tests
