#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "core/linear/cholesky.hpp"
#include "thermal/radiation/enclosure/ray_enclosure.hpp"
#include "thermal/radiation/light_cells.hpp"
#include "thermal/radiation/light_laws.hpp"
#include "thermal/radiation/rays/ray_exchange.hpp"

namespace parison::thermal {

using core::Index;
struct HeatSystem;
struct Flows;
struct StepMatrix;

/// Boundary edge of a glass through which light leaves.
struct LightEdge {
  std::array<Index, 3> temperature, light;  ///< unknowns, in the system and in the light's equations
  Index boundary_edge;                      ///< counted through all bodies
  Index mid_node;                           ///< of the mesh
  Index boundary;                           ///< of the glass
  bool black;                               ///< a black wall of the glass's own temperature; else open
  std::array<double, 3> area;               ///< at the points of edge_rule(3), m2
  EdgeShapes shape;                         ///< of the unknowns
};

/// Interface point through which light goes to a tool.
struct LightContact {
  std::array<Index, 3> light;  ///< unknowns of the slave's edge
  Eigen::Vector3d shape;       ///< their weights
  Index boundary;              ///< of the glass
  bool open;                   ///< whether light would go to the surroundings there
  double emissivity;           ///< of the tool
  double opaque_open, opaque;  ///< emissivity to the surroundings, exchange factor with the tool
};

/// Laws and factors that serve until material or topology change.
struct KeptLight {
  Radiation radiation;
  LightLaws laws;
  std::vector<std::array<Index, 6>> cells;
  core::Assembly assembly;             ///< cliques: the cells, then the boundary edges
  std::vector<core::Cholesky> factor;  ///< by group
  KeptTraces<TracedRays> rays;         ///< of the model transfer
  bool varies = false;                 ///< whether the absorption depends on temperature

  explicit KeptLight(const Radiation& given) : radiation(given), laws(given) {}
};

/// The light in a glass on the present meshes: that of each group of band and directions, its flux to the surroundings
/// and to the tools, and what the opaque bands exchange at the surface. By rays, or in the P1 approximation, where the
/// irradiation G of a group is the solution of
///   - div(diffusion grad G) + kappa G = kappa share 4 n^2 E(T).
struct Light {
  Index body;
  Index size;                            ///< unknowns of G
  std::vector<BatchIndices<6>> batches;  ///< unknowns of G of the batches of cells
  Field volumes;                         ///< m3
  std::vector<LightEdge> edges;
  std::vector<LightContact> contacts;     ///< by point of the interface
  std::optional<RayExchange> rays;        ///< of the model transfer, which needs no G in the glass
  std::optional<RayEnclosure> enclosure;  ///< of that model: what lies outside is not the surroundings alone
  std::shared_ptr<KeptLight> kept;
  bool solvable;  ///< false where a factorisation failed, on a mesh with cells inverted: all heat by light is NaN
  std::vector<Field> relative = {};  ///< by band: absorption at the points over that of its groups; empty where it is 1

  const LightLaws& laws() const { return kept->laws; }
  /// Coefficients of a group's flux through an edge, and through a point of the interface to the surroundings, where
  /// it would be open, and to the tool.
  double coefficient(int group, const LightEdge& edge) const {
    return edge.black ? laws().group(group).black : laws().group(group).open;
  }
  /// The same by group, null where it is 1.
  const Field* relative_of(int group) const {
    const auto band = static_cast<std::size_t>(laws().group(group).band);
    return relative.empty() || relative[band].empty() ? nullptr : &relative[band];
  }
  double open(int group, const LightContact& contact) const { return contact.open ? laws().group(group).open : 0; }
  double to_tool(int group, const LightContact& contact) const { return laws().to_tool(group, contact.emissivity); }
};

/// Prepares the light of a body, factors or rays included; reuses what `kept` has.
Light make_light(const HeatSystem& system, Index body, Index first_boundary_edge, std::shared_ptr<KeptLight>& kept);

/// Adds the heat that light brings at a time, s, and temperatures of the unknowns, K, to the flows and, unless null, to
/// the power into each unknown, W. In each group the sources in the glass are what enters through its surface, to
/// round-off.
void add_light(const Light& light, const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
               Flows& flows, Eigen::VectorXd* power);

/// Derivatives of that heat with respect to temperature.
struct LightDerivatives {
  std::vector<Field> emission;                     ///< by group, of what the quadrature points emit, W/K
  std::vector<Eigen::ArrayXd> from_surfaces;       ///< by group, of a black body at the points of the enclosure, W/m2/K
  std::vector<Eigen::ArrayXd> from_tool;           ///< by group, of what the tool sends through a point, W/K
  std::vector<std::array<double, 3>> opaque_edge;  ///< of the flux of opaque bands to the surroundings, W/K
  Eigen::ArrayXd opaque_slave, opaque_master;      ///< of what glass and tool send each other through a point, W/K
  Eigen::ArrayXd opaque_open;                      ///< of what the glass would send the surroundings there, W/K
};
LightDerivatives linearise_light(const Light& light, const HeatSystem& system, const Eigen::VectorXd& temperature);

/// Adds to `result`, J, the step, s, times the change of the heat flowing out by light when the temperatures change by
/// `change`, K.
void apply_light(const Light& light, const HeatSystem& system, const LightDerivatives& derivatives, double step,
                 const Eigen::VectorXd& change, Eigen::VectorXd& result);

/// Adds the step times a symmetric positive part of these derivatives to the matrix: half of the emission in the glass,
/// as between none and all of it is absorbed again, and the emission of each surface.
void assemble_light(StepMatrix& matrix, const Light& light, const HeatSystem& system,
                    const Eigen::VectorXd& temperature, double step);

/// Irradiation of each group by P1, W/m2, a column for each: what `add_light` finds.
Eigen::MatrixXd irradiation(const Light& light, const HeatSystem& system, double time,
                            const Eigen::VectorXd& temperature);

}  // namespace parison::thermal
