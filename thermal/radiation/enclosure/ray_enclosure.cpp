// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/enclosure/ray_enclosure.hpp"

#include "thermal/radiation/light_heat.hpp"
#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

/// What the excess irradiation of the glass adds to its radiosity: it enters, and part of it comes out again somewhere.
Eigen::MatrixXd through_glass(const RayEnclosure& enclosure, const RayExchange& rays, const RayBand& band) {
  const Eigen::Index patches = rays.area.size();
  const auto by_area = rays.area.inverse().matrix().asDiagonal();
  Eigen::MatrixXd outside = by_area * enclosure.shared;
  if (band.from_outside) outside = band.from_outside->solve(outside).eval();
  const Eigen::MatrixXd out = by_area * (band.factors.bottomRightCorner(patches, patches) * outside);
  return enclosure.surfaces->area.inverse().matrix().asDiagonal() * (enclosure.shared.transpose() * out);
}

}  // namespace

RayEnclosure make_ray_enclosure(const Light& light, const HeatSystem& system) {
  const Enclosure& surfaces = *system.enclosure;
  const RayExchange& rays = *light.rays;
  const auto count = static_cast<Eigen::Index>(surfaces.patches.size());
  RayEnclosure enclosure{
      system.enclosure, Eigen::MatrixXd::Zero(rays.area.size(), count), surfaces.emissivity, surfaces.emissivity, {}};
  for (Eigen::Index p = 0; p < count; ++p)
    if (surfaces.patches[static_cast<std::size_t>(p)].body == light.body)
      enclosure.grey[p] = 0, enclosure.absorbs[p] = 1;
  for (const EnclosurePoint& point : surfaces.points)
    if (surfaces.patches[static_cast<std::size_t>(point.patch)].body == light.body)
      enclosure.shared(rays.traced->surface[static_cast<std::size_t>(point.edge)].patch, point.patch) += point.area;
  for (const RayBand& band : rays.bands) {
    if (count == 0) break;
    Eigen::MatrixXd adds = through_glass(enclosure, rays, band);
    adds.diagonal().array() += 1 - enclosure.absorbs;
    Eigen::MatrixXd matrix = -surfaces.views.between * adds;
    matrix.diagonal().array() += surfaces.area;
    enclosure.bands.emplace_back(matrix);
  }
  return enclosure;
}

Eigen::VectorXd ray_excess(const RayEnclosure& enclosure, int band, const Eigen::ArrayXd& ray_area,
                           const Eigen::VectorXd& out, const PatchEmission& emitted) {
  const Enclosure& surfaces = *enclosure.surfaces;
  if (surfaces.patches.empty()) return {};
  const Eigen::ArrayXd of_glass =
      (enclosure.shared.transpose() * (out.array() / ray_area).matrix()).array() / surfaces.area;
  const Eigen::ArrayXd radiosity =
      of_glass + enclosure.grey * emitted.own + (1 - enclosure.absorbs) * emitted.surroundings;
  return enclosure.bands[static_cast<std::size_t>(band)].solve(
      excess_source(surfaces, radiosity, emitted.surroundings));
}

Eigen::ArrayXd absorbed_excess(const Light& light, const HeatSystem& system, const GroupLight& found) {
  if (system.enclosure->patches.empty()) return {};
  return light.enclosure->absorbs * found.excess.array();
}

}  // namespace parison::thermal
