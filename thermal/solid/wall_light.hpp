#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/case/time_function.hpp"
#include "thermal/radiation/light_laws.hpp"
#include "thermal/solid/slab_light.hpp"
#include "thermal/system.hpp"

namespace parison::thermal {

struct SolidSystem;

/// What light meets outside of a point of the surface of the glass: tools by their share of its area, the black
/// surroundings on the rest, or, where it sees none, itself: all that comes out goes in again.
struct LightSide {
  std::array<Index, 9> unknowns;
  int point;                    ///< of face_shapes
  Index boundary;               ///< counted through all bodies
  Index surrounded_by;          ///< index into WallLight::surroundings; -1: sees itself
  double own_view;              ///< share of what the rest of it sees that is itself
  double area;                  ///< m2
  double free = 1;              ///< share of the area that no tool covers
  std::vector<Index> contacts;  ///< indices into WallLight::contacts
};

/// Point of the interface through which a tool covers a part of a side.
struct LightTouch {
  Index pair;         ///< index into SolidSystem::contacts
  Index point;        ///< of the interface
  double area;        ///< m2
  double emissivity;  ///< of the tool
  double opaque;      ///< exchange factor of the opaque bands
};

/// A line of quadrature points through the wall, from the inner side to the outer one.
struct LightLine {
  std::vector<Index> points;        ///< of the body's cells
  std::array<Index, 2> sides;       ///< indices into WallLight::sides
  std::vector<SlabExchange> bands;  ///< W per W/m2
};

/// The light of the bands in a wall of layered cells, each line of points a plane slab with the areas and volumes that
/// the wall has there. Light does not go along the wall.
struct WallLight {
  Index body;
  LightLaws laws;
  double square;                 ///< of the refractive index
  double emissivity;             ///< of the glass beyond the last band
  std::vector<LightSide> sides;  ///< 9 of each face
  std::vector<LightTouch> contacts;
  std::vector<LightLine> lines;
  std::vector<Eigen::VectorXd> emitting;                ///< by band and point: absorption times volume, m2
  std::vector<const core::TimeFunction*> surroundings;  ///< K, by boundary of the body; null where it sees itself
};

/// Prepares the light of a body that has `stacks`, with the absorption at its temperatures, K, by unknown.
WallLight make_wall_light(const SolidSystem& system, Index body, const Eigen::VectorXd& temperature);

/// Adds the heat that this light brings at a time, s, to power and flows. What the glass loses is what leaves its
/// sides, to round-off.
void add_wall_light(const WallLight& light, const SolidSystem& system, double time, const Eigen::VectorXd& temperature,
                    Response& response);

/// Half of the derivative of what each point of the body emits, W/K: between none and all of it is absorbed again.
Eigen::VectorXd light_slopes(const WallLight& light, const SolidSystem& system, const Eigen::VectorXd& temperature);

}  // namespace parison::thermal
