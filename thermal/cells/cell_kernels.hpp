#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

/// Adds the cells' content, or with `rate`, K/s, its rate, and their conduction.
void add_cells(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd* rate,
               Response& response);

/// Slopes of the cells at a temperature.
void linearise_cells(const HeatSystem& system, const Eigen::VectorXd& temperature,
                     std::vector<BatchDerivatives>& batches);

/// Adds what a change of the temperatures, K, does to the cells' content - step power, J.
void apply_cells(const HeatSystem& system, const std::vector<BatchDerivatives>& batches, double step,
                 const Eigen::VectorXd& change, Eigen::VectorXd& result);

/// Adds the cells' capacity and step times conduction at a temperature to the matrix.
void assemble_cells(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step);

}  // namespace parison::thermal
