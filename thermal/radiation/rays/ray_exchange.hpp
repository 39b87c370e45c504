#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <memory>
#include <optional>
#include <vector>

#include "thermal/radiation/light_cells.hpp"
#include "thermal/radiation/rays/exchange_factors.hpp"
#include "thermal/radiation/traced_places.hpp"

namespace parison::thermal {

struct Light;
struct GroupSource;
struct GroupLight;
struct HeatSystem;

/// What a boundary is to light: a patch of the surface through which it goes, a black wall, or a mirror.
enum class SurfaceKind { open, black, mirror };

/// What was traced, and the mesh that it was traced on. The zones move with the glass.
struct TracedRays {
  std::vector<Point> nodes;
  std::vector<std::array<Index, 6>> cells;
  std::vector<SurfaceKind> kinds;  ///< by boundary
  Zones zones;
  std::vector<RaySurface> surface;  ///< by boundary edge
  Index patches;
  std::vector<std::array<std::array<Index, core::batch_size>, core::cell_points>> zone;  ///< of the quadrature points
  std::vector<std::array<PointValues, zone_functions>> values;  ///< of its functions, zero in lanes without a cell
  std::vector<Eigen::VectorXd> absorption;                      ///< by band, of each zone as traced, 1/m
  std::vector<ExchangeFactors> factors;                         ///< by band, as traced
};

/// One band on the present mesh.
struct RayBand {
  Field share;  ///< absorption at the quadrature points over that of their zones as traced; empty where it is 1
  ExchangeFactors factors;  ///< closed: each row has the sum that equilibrium asks for
  std::optional<Eigen::PartialPivLU<Eigen::MatrixXd>> from_outside;  ///< where tools send light back
};

/// Exchange of light between the zones of a glass, its surface and what lies outside of it.
struct RayExchange {
  std::shared_ptr<const TracedRays> traced;
  Eigen::ArrayXd area;               ///< of the patches, m2
  Eigen::ArrayXd returned;           ///< share of the light out of a patch that comes back, diffuse
  std::vector<Index> edge_patch;     ///< of Light::edges
  std::vector<Index> contact_patch;  ///< of Light::contacts
  std::vector<RayBand> bands;
};

/// Prepares the exchange of a body; traces anew where the glass has moved too far since it was done last.
RayExchange make_ray_exchange(const Light& light, const HeatSystem& system, KeptTraces<TracedRays>& traced);

/// The light of a band for what cells and surface send.
GroupLight ray_light(const Light& light, int band, const GroupSource& source);

}  // namespace parison::thermal
