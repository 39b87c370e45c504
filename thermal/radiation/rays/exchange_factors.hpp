#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "thermal/radiation/rays/light_resolution.hpp"
#include "thermal/radiation/rays/section.hpp"
#include "thermal/radiation/rays/zones.hpp"

namespace parison::thermal {

/// What a boundary edge is to the light.
struct RaySurface {
  Index patch;  ///< part of the surface that it belongs to; -1: a mirror
  bool black;   ///< in optical contact with a black wall: nothing is reflected
};

/// Direct exchange by light of one band, in W for emissive powers in vacuum of 1 W/m2, in the sense of H. C. Hottel,
/// A. F. Sarofim, *Radiative Transfer* (1967): symmetric. First the functions of the zones, whose emission is 4 n^2
/// kappa times the coefficients of the emissive power, then the patches of the surface, whose light comes in from
/// outside, diffuse.
using ExchangeFactors = Eigen::MatrixXd;

/// Those of each band, whose absorption coefficient, 1/m, is given for each zone, by rays, which begin at the
/// surface at places and in directions of a low-discrepancy sequence and are followed, with specular reflection by
/// Fresnel's equations, until little is left.
std::vector<ExchangeFactors> trace_exchange(const core::Mesh& mesh, Geometry geometry, const Zones& zones,
                                            const std::vector<RaySurface>& surface, Index patches, double index,
                                            const std::vector<Eigen::VectorXd>& absorption,
                                            const LightResolution& resolution);

}  // namespace parison::thermal
