#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <optional>
#include <vector>

#include "core/case/time_function.hpp"
#include "core/mesh/interface_point.hpp"
#include "core/mesh/mesh.hpp"
#include "thermal/properties.hpp"
#include "thermal/radiation/rays/light_resolution.hpp"
#include "thermal/radiation/traced_places.hpp"

namespace parison::thermal {

using core::Index;

/// What the light of a body that has it meets at its surface, and how a body answers light that comes
/// across an interface.
struct SurfaceLight {
  /// Temperature of the black surroundings that an open boundary sees, K, by boundary of the mesh. A boundary without
  /// reflects all light, but one of prescribed temperature is black, of that temperature and in optical contact. Empty:
  /// none.
  std::vector<std::optional<core::TimeFunction>> surroundings;
  double emissivity = 0;  ///< hemispherical: of the opaque bands of a body with light, of the grey surface of any other
  bool in_place = true;   ///< in an enclosure: whether the body is there at all
  double offset = 0;      ///< in an enclosure: of the body's mesh from where the body is, along the axis, m
};

/// One body of a heat problem, with its boundary values over time. Everything pointed to must outlive the problem. The
/// mass of each material point is fixed by `mass_mesh` and `density`, so the heat content does not change when `mesh`
/// moves.
struct BodyView {
  const core::Mesh* mesh;       ///< current positions, used for conduction and surfaces
  const core::Mesh* mass_mesh;  ///< positions for which `density` holds; same topology as `mesh`
  double density;               ///< on mass_mesh, kg/m3
  const Material* material;
  std::vector<std::optional<SurfaceExchange>> exchange;       ///< by boundary of the mesh; empty: none on any
  std::vector<std::optional<core::TimeFunction>> prescribed;  ///< Dirichlet temperature by boundary, K; empty: none
  const Eigen::VectorXd* wall_thickness = nullptr;            ///< by node, m; null: no thin-wall limit
  const std::vector<double>* source = nullptr;  ///< W at each point of triangle_rule(4), cell by cell; null: none
  core::TimeFunction source_factor = 1;         ///< multiplies `source`
  SurfaceLight light = {};
  /// Of a body whose absorption varies: the temperatures by node, K, at which it is taken. Null: `advance` takes those
  /// of the middle of the step.
  const Eigen::VectorXd* absorption_at = nullptr;
  /// Of a body whose density depends on temperature: by node, K, that for which its mass lies as in `mass_mesh`. Null:
  /// `density` is that of all of it.
  const Eigen::VectorXd* mass_temperature = nullptr;
};

/// Whether the wall thickness limits the radiation inside the body.
inline bool has_thin_wall(const BodyView& body) {
  return body.wall_thickness && is_rosseland(*body.material);
}

/// Temperatures of both sides at the points of an interface, K.
struct InterfaceTemperatures {
  const Eigen::ArrayXd &slave, &master;
};

/// Thermal contact conductance at a time, s: sets `h`, W/m2/K, at every interface point from the temperatures of both
/// sides there and, unless the pointer is null, the derivatives of `h` with respect to the slave's. All arrays have one
/// entry for each point.
using InterfaceLaw =
    std::function<void(double time, const std::vector<core::InterfacePoint>& points,
                       const InterfaceTemperatures& temperature, Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dT)>;

/// Heat conduction in several bodies that touch. Where the interface is in contact, its conductance replaces the
/// exchange of both sides with the air.
struct Problem {
  core::Geometry geometry;
  std::vector<BodyView> bodies;
  std::vector<core::InterfacePoint> interface;  ///< slave_body and master_body index `bodies`
  InterfaceLaw law;                             ///< unused without an interface
  bool enclosure = false;  ///< whether open surfaces see each other; all bodies then have their `surroundings`
  LightResolution light_resolution = {};
  /// Where light was traced last, from where it goes on; null: from what was kept by the last call.
  const TracedPlaces* traced = nullptr;
};

/// Heat content of a body relative to `content_reference`, J, from its nodal temperatures, K.
double heat_content(const BodyView& body, core::Geometry geometry, const Eigen::VectorXd& temperature);

}  // namespace parison::thermal
