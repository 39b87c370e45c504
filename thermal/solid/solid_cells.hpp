#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/solid_system.hpp"

namespace parison::thermal {

/// Adds the content of a body's unknowns, J, and the heat that conduction brings them, W.
void add_cells(const SolidLaws& body, const Eigen::VectorXd& temperature, Response& response);

/// Capacity plus step times conduction of each cell, J/K, at given temperatures; calls add(cell, matrix) for every
/// cell, nodes x nodes. The conductivity's own derivative is left out, so the matrices are symmetric and positive.
using CellMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// `slopes`, unless empty, are of heat that points of the body emit, W/K.
void for_each_cell_matrix(const SolidLaws& body, const Eigen::VectorXd& temperature, double step,
                          const Eigen::VectorXd& slopes,
                          const std::function<void(Index cell, CellMatrix& matrix)>& add);
/// Adds the capacity of each unknown, J/K: how the content rises with one change of all temperatures.
void add_capacity(const SolidLaws& body, const Eigen::VectorXd& temperature, Eigen::VectorXd& capacity);

}  // namespace parison::thermal
