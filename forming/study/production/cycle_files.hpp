#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <string>

#include "core/mesh/mesh.hpp"
#include "forming/study/production/periodic_state.hpp"

namespace parison::forming {

/// Nodal temperatures of a body, K, as a table of the form that a case reads: r_mm,z_mm,T_degC over a grid of some 400
/// places around the body. Bilinear between these it is the field by least squares; places beyond the body continue it
/// smoothly.
std::string temperature_table_text(const core::Mesh& mesh, const Eigen::VectorXd& temperature);

/// Writes cycle.json, cycle.csv (the settled cycle over time) and start_up.csv (cycle by cycle) into the folder.
/// `reason`: why the state is not the settled one; empty where it is.
void write_periodic_state(const Scene& scene, const PeriodicRequest& request, const PeriodicState& state,
                          const std::string& reason);

/// Tools of settled production as a table for the terminal: use, temperatures, heat and cooling.
std::string periodic_table(const Scene& scene, const PeriodicState& state);

}  // namespace parison::forming
