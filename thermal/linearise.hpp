#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "thermal/system.hpp"

namespace parison::thermal {

/// Slopes of content and power with temperature at the points of a group of cells.
struct GroupSlopes {
  PointPacks capacity;        ///< J/K
  PointPacks conductivity;    ///< W/m/K
  PointPacks flow_a, flow_b;  ///< of the heat flow along the reference coordinates, by dk/dT alone, W/K
};
/// Derivative of the heat equations at a temperature, with the slopes of conductivity and conductance.
struct Linearisation {
  std::vector<GroupSlopes> groups;
  std::vector<std::array<double, 3>> edges;  ///< of surface exchange at the points of edge_rule(3), W/K
  ContactSlopes contacts;
};
Linearisation linearise(const HeatSystem& system, const Eigen::VectorXd& temperature);

/// What a change of the temperatures, K, does to content - step power, J.
Eigen::VectorXd apply(const HeatSystem& system, const Linearisation& linearisation, double step,
                      const Eigen::VectorXd& change);

}  // namespace parison::thermal
