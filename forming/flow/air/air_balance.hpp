#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "forming/flow/air/trapped_air.hpp"

namespace parison::flow {

/// How the volumes of the pockets follow the driven tools and the pressures.
struct AirResponse {
  const TrappedAir* air = nullptr;
  /// Rates of the pockets' volumes, m3/s, a row each: column 0 with the driven tools at rest and all pockets at ambient
  /// pressure, then for each m/s of each driven tool, then for each Pa of each pocket.
  Eigen::MatrixXd rate;

  Index pockets() const { return Index(rate.rows()); }
};

/// `columns` are the velocities that belong to the columns of AirResponse::rate, two rows per node.
AirResponse air_response(const Problem& problem, const AirLoads& loads, const Eigen::MatrixXd& columns,
                         const std::vector<Index>& driven);

/// Balance of the driven tools and the law of the air together, to be solved for velocities, m/s, and gauge pressures,
/// Pa.
struct AirBalance {
  const AirResponse& response;
  /// Equations of the tools, linear: their row of `resistance` times (velocities, pressures) equals `rhs`.
  Eigen::MatrixXd resistance;
  Eigen::VectorXd rhs;

  /// Newton's method from the given unknowns; the pressure falls with the volume and the volume grows with the
  /// pressure, so that the solution is unique.
  Eigen::VectorXd solve(Eigen::VectorXd unknowns) const;
};

}  // namespace parison::flow
