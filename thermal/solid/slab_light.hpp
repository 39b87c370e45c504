#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

namespace parison::thermal {

/// Exchange of light between places of a plane slab and its two sides, per m2 (direct exchange factors: H. C. Hottel,
/// A. F. Sarofim, *Radiative Transfer*, 1967). With e = 4 n^2 E(T) at the places and J the flux that comes to each
/// side from outside, place i absorbs sum between_ij e_j + 4 n^2 sum through_ib J_b and sends kappa l_i e_i; what
/// arrives outside of side b, with what the surface reflects of J_b, is sum through_ib e_i + 4 n^2 sum sides_bc J_c.
struct SlabExchange {
  Eigen::MatrixXd between;                           ///< symmetric
  Eigen::Matrix<double, Eigen::Dynamic, 2> through;  ///< by place and side: first, last
  Eigen::Matrix2d sides = Eigen::Matrix2d::Zero();   ///< symmetric
};

/// The radiative transfer equation in a plane slab of layers between smooth surfaces, by directions: Gauss points of
/// the cosine inside and outside of the cone of total reflection. In each layer the emission is the parabola through
/// its values at three places, the Gauss points; its integrals are exact.
class SlabLight {
 public:
  static constexpr int places = 3;  ///< of a layer
  explicit SlabLight(double refractive_index);

  /// Layers of a thickness, m, and an absorption, 1/m, each.
  SlabExchange exchange(const std::vector<double>& thickness, const std::vector<double>& absorption) const;

 private:
  struct Direction {
    double cosine, weight, reflected;
  };
  double square_;
  std::vector<Direction> directions_;
};

}  // namespace parison::thermal
