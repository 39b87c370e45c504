#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <optional>
#include <vector>

#include "core/case/time_function.hpp"
#include "core/solid/cell_table.hpp"
#include "core/solid/prism_mesh.hpp"
#include "core/solid/quad_face.hpp"
#include "core/solid/solid_interface.hpp"
#include "thermal/problem.hpp"
#include "thermal/properties.hpp"

namespace parison::thermal {

/// One body of a heat problem in space. Everything pointed to must outlive the problem. The mass at the points of the
/// cells is given, so the heat content does not change when the nodes move.
struct SolidBodyView {
  const std::vector<core::Vector3>* nodes;   ///< current positions, m
  core::CellList cells;                      ///< cell_list(mesh, hexahedron_table()) or (mesh, prism_table())
  const std::vector<core::QuadFace>* faces;  ///< the surface, without what is insulated in all cases
  const Eigen::VectorXd* mass;               ///< by point of the cells, kg: point_masses
  const Material* material;
  std::vector<std::optional<SurfaceExchange>> exchange;       ///< by boundary_id of the faces; empty: none on any
  std::vector<std::optional<core::TimeFunction>> prescribed;  ///< temperature by boundary_id, K; empty: none
  const Eigen::VectorXd* wall_thickness = nullptr;            ///< by node, m; null: no thin-wall limit
  /// Heat by point of the cells, W; null: none. Here enters dissipation.
  const Eigen::VectorXd* source = nullptr;
  core::TimeFunction source_factor = 1;  ///< multiplies `source`
  /// Of a body whose light is in bands: its cells as core::cell_stacks has them. Both ends of each have their faces.
  const std::vector<std::vector<Index>>* stacks = nullptr;
  std::vector<double> own_view = {};  ///< by boundary_id: share of what it sees that is itself; empty: none on any
  SurfaceLight light = {};  ///< surroundings by boundary_id; one without sees itself: light that leaves comes back
};

/// A body of hexahedra (glass) with its faces, or of prisms (tool) with its own faces; no exchange yet.
SolidBodyView solid_body(const core::HexMesh& mesh, const std::vector<core::QuadFace>& faces,
                         const Eigen::VectorXd& mass, const Material& material);
SolidBodyView solid_body(const core::PrismMesh& mesh, const Eigen::VectorXd& mass, const Material& material);

/// Mass at the points of the cells, kg, where the nodes are now: volume times the material's density at the nodal
/// temperature, K. To be kept with the mesh for as long as it moves.
Eigen::VectorXd point_masses(const std::vector<core::Vector3>& nodes, const core::CellList& cells,
                             const Material& material, const Eigen::VectorXd& temperature);

/// Thermal contact conductance at a time, as InterfaceLaw.
using SolidInterfaceLaw =
    std::function<void(double time, const std::vector<core::SolidInterfacePoint>& points,
                       const InterfaceTemperatures& temperature, Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dT)>;

/// A law of the plane for the points of an interface in space, whose pressures, laws and openings `points` has.
SolidInterfaceLaw in_space(InterfaceLaw law, std::vector<core::InterfacePoint> points);

/// Heat conduction in several bodies that touch, with the light in the wall of those that have it in bands. Where the
/// interface is in contact, its conductance replaces the exchange of both sides with the air.
struct SolidProblem {
  std::vector<SolidBodyView> bodies;
  core::SolidInterface interface;  ///< bodies of its pairs index `bodies`, faces their `faces`
  SolidInterfaceLaw law;           ///< unused without an interface
};

/// Heat content of a body relative to `content_reference`, J, from its nodal temperatures, K.
double heat_content(const SolidBodyView& body, const Eigen::VectorXd& temperature);

}  // namespace parison::thermal
