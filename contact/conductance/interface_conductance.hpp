#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "contact/conductance/conductance.hpp"
#include "core/mesh/interface_point.hpp"

namespace parison::contact {

/// The conductance at all points of an interface, prepared for many evaluations with the same pressures and new
/// viscosities. The result at a point does not depend on its index, to the last bit.
class InterfaceConductance {
 public:
  /// `laws` are indexed by core::InterfacePoint::law.
  InterfaceConductance(std::vector<ConductanceLaw> laws, const std::vector<core::InterfacePoint>& points);

  /// Sets h, W/m2/K, at each point from the natural logarithm of the viscosity, Pa.s, and, where `dh_dlog` is not null,
  /// its derivative with respect to that logarithm. Returns at how many points a table clamped its argument.
  core::Index operator()(const Eigen::ArrayXd& log_viscosity, Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dlog) const;

  /// Sets h, and its derivative with respect to the slave's temperature, where the law is that of a gap; leaves all
  /// others. `age` is the time, s, since the openings of the points; temperatures in K, one for each point.
  void set_gap_conductance(double age, const std::vector<core::InterfacePoint>& points,
                           const Eigen::ArrayXd& slave_temperature, const Eigen::ArrayXd& master_temperature,
                           Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dT) const;

 private:
  /// Consecutive points with the same law.
  struct Run {
    core::Index law, first, count;
  };
  std::vector<ConductanceLaw> laws_;
  std::vector<Run> runs_;
  Eigen::ArrayXd pressure_;       ///< Pa, not negative
  Eigen::ArrayXd pressure_part_;  ///< PressureViscosityLaw::pressure_part; 0 for other laws
};

}  // namespace parison::contact
