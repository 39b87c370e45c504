#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <Eigen/LU>
#include <memory>
#include <vector>

#include "thermal/radiation/enclosure/enclosure.hpp"

namespace parison::thermal {

struct Light;
struct GroupLight;

/// Emissive powers of black bodies in a group, W/m2, by patch of an enclosure: at the temperatures of the patches, and
/// of their surroundings.
struct PatchEmission {
  Eigen::ArrayXd own, surroundings;
};

/// An enclosure as the light of a glass with rays meets it: what comes out of the glass, with what enters elsewhere and
/// crosses it, and the tools' grey surfaces.
struct RayEnclosure {
  std::shared_ptr<const Enclosure> surfaces;
  Eigen::MatrixXd shared;  ///< open area that a patch of the rays and one of the enclosure have in common, m2
  Eigen::ArrayXd grey;     ///< emissivity by patch; of the glass 0
  Eigen::ArrayXd absorbs;  ///< share of the irradiation that a patch takes; of the glass 1, from which `out` goes off
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXd>> bands;  ///< A - K times what the excess adds to the radiosities
};

/// Prepares the coupling for a light with rays on a system with an enclosure.
RayEnclosure make_ray_enclosure(const Light& light, const HeatSystem& system);

/// Excess irradiation of the patches in a band, W/m2, for the light out of the patches of the rays, W, without it.
Eigen::VectorXd ray_excess(const RayEnclosure& enclosure, int band, const Eigen::ArrayXd& ray_area,
                           const Eigen::VectorXd& out, const PatchEmission& emitted);

/// What the patches take of the excess that was found, W/m2.
Eigen::ArrayXd absorbed_excess(const Light& light, const HeatSystem& system, const GroupLight& found);

}  // namespace parison::thermal
