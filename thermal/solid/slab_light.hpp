#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

namespace parison::thermal {

/// Exchange of light between places of a wall and its two sides, W per W/m2 (direct exchange factors: H. C. Hottel,
/// A. F. Sarofim, *Radiative Transfer*, 1967). With e = 4 n^2 E(T) at the places and J the flux that comes to each
/// side from outside, place i absorbs sum between_ij e_j + 4 n^2 sum through_ib J_b and sends kappa V_i e_i; what
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

/// The radiative transfer equation in a wall of layers between smooth surfaces of two areas, by directions: Gauss
/// points inside and outside of the cones of total reflection. The wall is a part of a spherical shell, and a plane
/// slab where the areas are alike: along a ray the area times the squared sine of the angle to the normal stays the
/// same, so that what one side reflects totally may leave through the wider one. In layers the integrals of the
/// emission are exact.
class SlabLight {
 public:
  explicit SlabLight(double refractive_index) : index_(refractive_index) {}

  /// Layers with an absorption, 1/m, each, between sides of these areas, m2.
  SlabExchange exchange(const std::vector<SlabLayer>& layers, const std::vector<double>& absorption,
                        const Eigen::Vector2d& area) const;

 private:
  double index_;
};

/// The square roots of the areas of all sides of layers with these volumes, m3, m: they go evenly through the wall.
std::vector<double> shell_radii(const std::vector<double>& volume, const Eigen::Vector2d& area);
/// Mean area between two such roots, m2.
inline double mean_area(double r, double s) {
  return (r * r + r * s + s * s) / 3;
}

}  // namespace parison::thermal
