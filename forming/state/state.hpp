#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <numeric>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/state/glass_fields.hpp"
#include "thermal/radiation/traced_places.hpp"

namespace parison::forming {

using core::Index;
using core::Point;

/// Every contact that the last flow solve left active (a node in a corner has two); empty where there was none yet.
struct ActiveContacts {
  std::vector<Index> node, tool;
  std::vector<Point> normal;  ///< unit, from the tool into the glass
};

/// The glass at an instant; its mesh moves with it.
struct GlassState : GlassFields {
  core::Mesh mesh;
  std::vector<Point> mass_nodes;  ///< node positions in which the mass was last distributed
  double density = 0;             ///< in those positions, kg/m3; of glass that expands, what its law is a multiple of
  Eigen::VectorXd mass_temperature;  ///< by node, K, in those positions, which gives the density there; empty where
                                     ///< density does not depend on temperature
  double mass = 0;                   ///< kg
  double initial_volume = 0;         ///< m3
  double initial_heat = 0;           ///< heat content at the start, J
  ActiveContacts active_contacts;
};

/// A tool at an instant; it keeps its mesh and moves by `offset`.
struct ToolState {
  core::Mesh mesh;                   ///< in the tool's own frame
  Eigen::VectorXd temperature;       ///< per node, K; empty where the scene has no heat
  double offset = 0;                 ///< along the axis, m
  double velocity = 0;               ///< along the axis, m/s
  double slowing = 0;                ///< rate at which the logarithm of its speed falls, 1/s; 0 where it does not
  double force = 0;                  ///< on the glass along the axis, mean of the last step, N
  double end_force = 0;              ///< the same at the end of that step, N
  double heat_received = 0;          ///< through interfaces since the start, J
  double heat_radiated = 0;          ///< the part of it that came as light, with light in bands, J
  double heat_from_enclosure = 0;    ///< light that came to its open surface from others, with an enclosure, J
  std::vector<double> heat_through;  ///< out through each boundary by cooling, air or given temperature, J
};

/// Why the glass was given a new mesh, and the names of these reasons.
enum class RemeshReason { stage_start, quality, failed_step };
inline constexpr std::array remesh_reasons{"stage_start", "quality", "failed_step"};

/// Mechanical work on the glass since the start and where it went, J. Remeshing moves nodes without forces and is no
/// part of it.
struct Work {
  double tools = 0, gravity = 0, air = 0;  ///< done on the glass
  double dissipation = 0;                  ///< viscous
  double friction = 0;                     ///< lost where the glass slides along tools
  double impact_loss = 0;                  ///< lost where it came to rest on a tool before a step was over
  double surface = 0;                      ///< stored in open surface by its tension
  double expansion = 0;                    ///< taken by the change of density against the stress
  double correction = 0;                   ///< taken by leading volume and penetrated nodes back; counts as unexplained
};

/// What remeshing did by itself since the start.
struct RemeshStatistics {
  std::array<Index, remesh_reasons.size()> count{};  ///< by RemeshReason
  double heat = 0, max_heat = 0;      ///< heat content changed: in all, and by one remesh without sign, J
  double volume = 0, max_volume = 0;  ///< volume likewise, m3
  double transfer_overshoot = 0;      ///< furthest that a new temperature went beyond all old ones, K
  double min_quality = 1;             ///< of a cell after any remesh
  double min_median = 1;              ///< quality of the median cell after any remesh
  Index before_step = -1;             ///< number of the step for which the mesh was made anew, -1 at a stage's start
  Index failed = 0;                   ///< new meshes that could not be made
  double lap_volume = 0;              ///< of the air in those, m3
  Index laps = 0;                     ///< small folds of the glass onto itself that were closed
  Index enclosed = 0;                 ///< places at which glass met glass and joined around air
  double enclosed_volume = 0;         ///< of that air when it was enclosed, m3
  Index torn = 0;                     ///< pieces that tore off, whose glass was given to the rest
  double torn_volume = 0;             ///< of those, m3
  double coarsening_factor = 1;       ///< by which a mesh was coarser than asked for, for the sake of max_cells
};

/// Sums since the start.
struct Totals {
  double to_air = 0;          ///< heat lost by the glass to air, J
  double light_to_air = 0;    ///< the part of it that went as light to the surroundings, with light in bands, J
  double from_enclosure = 0;  ///< light from other surfaces, by which `to_air` is less, with an enclosure, J
  double to_tools = 0;        ///< heat that crossed from glass to tools, J
  double dissipation = 0;     ///< viscous, into the glass, J
  Index steps = 0;
  Work work;
  RemeshStatistics remeshing;
};

/// The air in sealed cavities; empty where the stage vents them.
struct CavityAir {
  std::vector<double> volume;  ///< of each cavity, m3
  std::vector<double> energy;  ///< absolute pressure times volume, J; 0 in a void
  std::vector<double> amount;  ///< p V of the same air at the temperature given in the case, J
  /// Middles of the exposed edges of the glass, and the cavity that each belongs to, -1 in the open, -2 in a void that
  /// has just opened: by them the cavities are found again.
  std::vector<Point> marker;
  std::vector<Index> marker_cavity;
};

/// Everything that changes during a run.
struct State {
  double time = 0;  ///< s
  Index stage = 0;
  double stage_time = 0;              ///< since the stage's start, s
  double stage_start = 0;             ///< time of the stage's start, s
  bool has_moved = false;             ///< a tool was faster in this stage than the speed that ends it
  double next_step = 0;               ///< proposed by the step control, s
  Index next_limit = 0;               ///< the StepLimit of that
  double heat_substep = 0;            ///< proposed by the heat solver, s
  std::vector<Index> heat_couplings;  ///< four by four, thermal::Coupling; empty for a new mesh
  thermal::TracedPlaces light;        ///< empty for a new mesh and a new stage
  double last_step = 0;               ///< s, 0 when there is no velocity to extrapolate from
  double last_landed = 0;             ///< largest length of surface that a contact front passed in it, m
  double last_work_error = 0;         ///< of the work in it, as StepReport::work_error
  GlassState glass;
  std::vector<ToolState> tools;  ///< in the order of the scene
  bool moves_smoothly = false;   ///< the last change of velocity was close to what the acceleration before predicts
  std::vector<Point> probes;     ///< present positions, in the body's frame
  CavityAir cavity_air;
  Totals totals;
};

/// Bodies as heat, interface points and probes number them: the glass, then the tools.
inline constexpr Index glass_body = 0;
inline Index body_of_tool(Index tool) {
  return 1 + tool;
}
inline Index body_count(const State& state) {
  return 1 + static_cast<Index>(state.tools.size());
}
/// Mesh and nodal temperatures, K, of a body by that number.
inline const core::Mesh& mesh_of(const State& state, Index body) {
  return body == glass_body ? state.glass.mesh : state.tools[body - 1].mesh;
}
inline const Eigen::VectorXd& temperature_of(const State& state, Index body) {
  return body == glass_body ? state.glass.temperature : state.tools[body - 1].temperature;
}
inline Eigen::VectorXd& temperature_of(State& state, Index body) {
  return body == glass_body ? state.glass.temperature : state.tools[body - 1].temperature;
}

/// New glass meshes since the start.
inline Index remeshes(const State& state) {
  const auto& count = state.totals.remeshing.count;
  return std::accumulate(count.begin(), count.end(), Index{0});
}

}  // namespace parison::forming
