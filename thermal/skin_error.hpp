#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <limits>

namespace parison::thermal {

/// A body that begins to exchange heat through its surface, as a layer with an insulated back, and how its mesh
/// resolves the skin.
struct SkinSide {
  double conductivity;  ///< W/m/K
  double capacity;      ///< volumetric, J/m3/K
  double first_cell;    ///< height of the cells at the surface, m
  double growth = 0.5;  ///< of the cells' height with the depth
  double depth =
      std::numeric_limits<double>::infinity();  ///< of the layer, m: its volume over the area it exchanges by
};

/// Relative error of the heat that a layer on such a mesh has given after `time`, s, to surroundings of another
/// temperature through a conductance h, W/m2/K: that of the semi-discrete equations over the exact solution of a
/// half-space (Carslaw and Jaeger 1959, section 2.7), or over that on a fine mesh where the heat has come to the back
/// of the layer, less 1. It is far above zero while the skin is thinner than the first cell.
/// With an infinite h the surface's nodes are set to the temperature of the surroundings at the start.
double skin_error(const SkinSide& side, double h, double time);

/// The same of two layers of different temperatures brought together at time 0.
double skin_error(const SkinSide& first, const SkinSide& second, double h, double time);

/// Conductance, W/m2/K, beyond which a contact counts as perfect: its resistance is 1e-6 of that of layers of such
/// conductivity and thickness, W/m/K and m. More changes nothing but the round-off.
double perfect_conductance(double conductivity, double thickness);

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
