#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "forming/diagnostics/cooling_seen.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// The base as a polariscope shows it, seen along the axis: retardation of light at a distance from the axis.
struct BaseView {
  std::vector<double> radius, thickness;  ///< m; of the glass that the light passes
  std::vector<double> retardation;        ///< m; of a round base positive where the radial stress is the larger
  std::vector<core::Vector3> at;          ///< on the outer side, m; of a base that is not round, a sector of it
  std::vector<double> on_diagonal;        ///< of it, retardation along x = y over that across, m
  double sector = 0;                      ///< rad

  std::size_t largest() const;  ///< index of the largest, without sign
};
/// Of an axisymmetric container with stress that stands as `up` says (1 along the axis, -1 against it), as far as its
/// base reaches; empty where there is none.
BaseView base_view(const Scene& scene, const GlassState& glass, int up);
/// Of glass in space, along each column of nodes through the base, by rising distance.
BaseView base_view(const SolidState& solid, int up);

/// What is told of a container that has cooled.
struct CooledContainer {
  SidesTension tension;        ///< on its surface
  double largest_tension = 0;  ///< principal, anywhere in the glass, Pa
  BaseView base;
  double volume = 0;                ///< of the glass, m3
  double height = 0, diameter = 0;  ///< m; 0 where it is no container
  std::optional<double> capacity;   ///< m3
};
/// Nothing of glass that has not cooled.
std::optional<CooledContainer> cooled_container(const Scene& scene, const State& state, bool has_wall);
/// Of glass in space, with its capacity, m3, at a time, s.
std::optional<CooledContainer> cooled_container(const Scene& scene, const SolidState& solid, double capacity,
                                                double time);

/// Tension on the surface of glass in space at a time, s; places are those in a plane through the axis.
SidesTension surface_tension(const SolidState& solid, double time);

}  // namespace parison::forming
