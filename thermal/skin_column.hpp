#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "thermal/skin_error.hpp"

namespace parison::thermal {

/// Stiffness, W/m2/K, and mass, J/m2/K, of the cells under one place of a surface; the first unknown is the surface.
struct SkinColumn {
  Eigen::MatrixXd stiffness, mass;
};

/// The column of a layer, for times up to `time`, s; `shortest`, s, is that of the thinnest skin that matters.
SkinColumn skin_column(const SkinSide& side, double time, double shortest);

/// Whether the heat comes to the back of a layer in a time, s.
bool reaches_back(const SkinSide& side, double time);

/// A layer on a mesh so fine that it stands for the exact solution.
SkinSide fine_side(SkinSide side);

/// Depth that the heat penetrates in a time, s: sqrt(alpha t), m.
double penetration(const SkinSide& side, double time);

}  // namespace parison::thermal
