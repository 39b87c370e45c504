#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

/// Adds the heat content of the cells at a temperature, J, or with `rate`, K/s, its rate, W, and the power that they
/// conduct into each unknown, W. Temperatures are those of the unknowns of all bodies, K.
void add_cells(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd* rate,
               Response& response);

/// Derivatives of the cells' content and conduction at a temperature, at their quadrature points.
void linearise_cells(const HeatSystem& system, const Eigen::VectorXd& temperature,
                     std::vector<BatchDerivatives>& batches);

/// Adds the derivative of content - step power in the direction of a change of the temperatures, K: J.
void apply_cells(const HeatSystem& system, const std::vector<BatchDerivatives>& batches, double step,
                 const Eigen::VectorXd& change, Eigen::VectorXd& result);

/// Adds C + step K of the cells at a temperature to the matrix, J/K: C the heat capacity, K the conduction.
void assemble_cells(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step);

}  // namespace parison::thermal
