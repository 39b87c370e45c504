#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "contact/conductance/conductance.hpp"
#include "core/mesh/interface_point.hpp"

namespace parison::contact {

/// Conductances of all points of an interface, prepared for many evaluations: their pressures stay, their viscosities
/// change.
class InterfaceConductance {
 public:
  /// `laws` by core::InterfacePoint::law.
  InterfaceConductance(std::vector<ConductanceLaw> laws, const std::vector<core::InterfacePoint>& points);

  /// h, W/m2/K, and, where asked for, its derivative, from the natural logarithm of the viscosity, Pa.s, at each point;
  /// returns at how many points a table had to hold its end.
  core::Index operator()(const Eigen::ArrayXd& log_viscosity, Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dlog) const;

 private:
  struct Run {
    core::Index law, first, count;  ///< points that follow one another
  };
  std::vector<ConductanceLaw> laws_;
  std::vector<Run> runs_;
  Eigen::ArrayXd pressure_;  ///< Pa
  Eigen::ArrayXd
      log_pressure_factor_;  ///< logarithm of x of the law of pressure and viscosity at a viscosity of 1 Pa.s
};

}  // namespace parison::contact
