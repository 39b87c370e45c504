#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <optional>
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Time in which a tool is active, s.
double active_time(const Scene& scene, std::size_t tool);

/// Conductivities of the glass at its first temperature, W/m/K: of its lattice, with radiation in a wall of a length,
/// m, and in thick glass.
struct Conductivities {
  double alone, limited, unlimited;
};
Conductivities conductivities(const Scene& scene, double length);

/// Heat between glass and tools as half-spaces: conductivity of the glass, W/m/K, and whether tools stay as cold as
/// they start.
struct HalfSpaces {
  double conductivity;
  bool isothermal = false;
};
/// Relative increase of the heat into a tool of one pair of half-spaces over another, for the highest conductance and
/// the whole time in which the tool is active; the tool with the most counts.
double heat_gain(const Scene& scene, const HalfSpaces& more, const HalfSpaces& less);

/// Dimensionless numbers of a scene at its start, none where a property is missing.
struct DimensionlessNumbers {
  double length;        ///< m: cross-section over half its outline without symmetry boundaries, a plate's thickness
  double volume, mass;  ///< of the glass as drawn, m3 and kg; of a planar scene for a metre of depth
  std::optional<double> speed;      ///< m/s: fastest tool, else the pressure or gravity over the viscosity
  std::optional<double> viscosity;  ///< Pa.s, at the initial temperature
  std::optional<double> reynolds, capillary, peclet, biot, brinkman;
};
DimensionlessNumbers dimensionless_numbers(const Scene& scene);

/// Volume of an outline, m3, of a planar one for a metre of depth; arcs by many chords.
double outline_volume(const core::Profile& profile, core::Geometry geometry);

/// m/s, of a tool in a stage; 0 where it does not move.
double fastest(const StageTool& tool);

/// What a scene needs, for the terminal: physics on and off and why, numbers, stages and accuracy.
std::string describe_scene(const Scene& scene);
/// The same in few lines: what is run, and the settings that the case or --set chose.
std::string describe_scene_briefly(const Scene& scene);

}  // namespace parison::forming
