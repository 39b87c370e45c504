#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <vector>

#include "contact/solid/section_surface.hpp"
#include "core/solid/prism_mesh.hpp"
#include "core/solid/quad_face.hpp"
#include "forming/scene/scene.hpp"
#include "forming/solid/flow/solid_flow.hpp"
#include "forming/state/state.hpp"
#include "thermal/solid/solid_problem.hpp"

namespace parison::forming {

/// Sides of the glass as the faces of SolidState count them.
enum class SolidSide { inner, outer, rim };

/// A tool of the stages in which the glass is a solid.
struct SolidTool {
  Index tool;  ///< index into Scene::tools
  std::shared_ptr<const contact::SectionSurface> surface;
  core::PrismMesh mesh;                         ///< in the tool's own frame
  Eigen::VectorXd temperature;                  ///< by node, K
  Eigen::VectorXd mass;                         ///< by point of the cells, kg
  double heat_received = 0;                     ///< from the glass since the start of the solid, J, of the sector
  core::Vector3 force = core::Vector3::Zero();  ///< of the glass on it in the last step, N, of the sector
};

/// Sums since the glass became a solid, of its sector.
struct SolidTotals {
  Index steps = 0, rejected = 0, factors = 0, solutions = 0;
  double to_air = 0, to_tools = 0;              ///< J
  double light_to_air = 0, light_to_tools = 0;  ///< J: the parts of them that are light in bands
  double start_heat = 0;                        ///< J
  double volume_error = 0;                      ///< largest of a cell in a step, as a share of it
  double heat_imbalance = 0;                    ///< sum of the heat that no balance explains, J
};

/// Glass and tools in space: a sector about the axis.
struct SolidState {
  double cell_size = 0;      ///< along the wall where the glass was handed over, m
  core::HexMesh first_mesh;  ///< of the hand-over: by its places unknowns are eliminated
  flow::SolidGlass glass;
  Eigen::VectorXd point_mass;              ///< of the glass by point of its cells, kg
  std::vector<core::HexFace> faces;        ///< the surface of the glass but for planes of symmetry
  std::vector<core::QuadFace> heat_faces;  ///< the same; boundary_id is a SolidSide
  std::vector<core::SymmetryPlane> planes;
  std::vector<std::vector<Index>> columns;  ///< nodes through the wall, from the inner side to the outer one
  std::vector<std::vector<Index>> stacks;   ///< cells through the wall, in the same order
  Eigen::VectorXd temperature_rate;         ///< of the last step, K/s; empty: none
  Eigen::VectorXd contact_opening;      ///< by point of SolidGlass::contact, of the gap beyond that at first touch, m;
                                        ///< empty where no contact law has a gap
  Eigen::VectorXd branch_stress;        ///< deviator, flow::tensor_entries of each branch of each of the cells'
                                        ///< flow::memory_points, Pa; empty until the glass cools
  Eigen::VectorXd fictive_temperature;  ///< of each branch of each point, K
  std::vector<SolidTool> tools;
  double share = 1;                                       ///< of the whole turn
  double last_step = 0, next_step = 0, heat_substep = 0;  ///< s
  SolidTotals totals;
};

/// The faces of one side.
std::vector<core::HexFace> faces_of(const SolidState& state, SolidSide side);

}  // namespace parison::forming
