#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
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

/// A layer of a slab. Its emission is the parabola through the values at three places, whose integral gives each place
/// the weight that the quadrature of the cell has there.
class SlabLayer {
 public:
  static constexpr int places = 3, powers = 6;
  /// Of a thickness, m; `at` are the places from 0 to 1.
  SlabLayer(double thickness, const std::array<double, places>& at);

  double thickness;                                    ///< m
  std::array<double, places> weight;                   ///< of the places; their sum is 1
  Eigen::Matrix<double, places, powers> first, last;   ///< emission by powers of the distance from either side
  Eigen::Matrix<double, places * places, powers> own;  ///< of pairs of places by powers of their distance, both ways
};

/// The radiative transfer equation in a plane slab of layers between smooth surfaces, by directions: Gauss points of
/// the cosine inside and outside of the cone of total reflection. The integrals over layers are exact.
class SlabLight {
 public:
  explicit SlabLight(double refractive_index);

  /// Layers with an absorption, 1/m, each.
  SlabExchange exchange(const std::vector<SlabLayer>& layers, const std::vector<double>& absorption) const;

 private:
  struct Direction {
    double cosine, weight, reflected;
  };
  double square_;
  std::vector<Direction> directions_;
};

}  // namespace parison::thermal
