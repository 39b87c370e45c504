#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "forming/flow/problem.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Nodes of the glass boundary, each once, in the order of the boundary.
std::vector<Index> surface_nodes(const core::Mesh& mesh);

/// How the active tools move over the next dt; one entry for each tool of the scene.
std::vector<flow::ToolMotion> tool_motions(const Scene& scene, const State& state, double dt);

/// Contact candidates of all surface nodes with all active tools (Signorini conditions on the velocity). The gap is
/// evaluated at the positions that `velocity` (core::dim per node, m/s) and the tools' present velocities would reach
/// after dt, s, and linearised there: second order in dt.
std::vector<flow::ContactCandidate> contact_candidates(const Scene& scene, const State& state,
                                                       const Eigen::VectorXd& velocity, double dt);

/// Gap up to which a tool that grips holds glass by its form, m.
double depth_of_form(const Scene& scene);

/// Nodes on the contact boundaries of the glass, each once.
std::vector<Index> contact_nodes(const core::Mesh& glass);

/// Flags of the same among all nodes.
std::vector<bool> touching_nodes(const core::Mesh& glass);

/// Distance from each glass node to a tool, m; +infinity inside the glass and beyond `reach`. `nodes`: those of
/// contact_nodes, when they are known.
Eigen::VectorXd tool_gaps(const Scene& scene, const State& state, const std::vector<Index>& nodes, Index tool,
                          double reach);
Eigen::VectorXd tool_gaps(const Scene& scene, const State& state, Index tool, double reach);

/// A function that projects points inside an active tool onto its surface and returns all others unchanged.
std::function<Point(const Point&)> projector_out_of_tools(const Scene& scene, const State& state);

/// Projects the surface nodes of `mesh` that lie inside an active tool onto its surface: where the surface meets a
/// symmetry line along that line; the other nodes of symmetry boundaries stay.
void project_out_of_tools(const Scene& scene, const State& state, core::Mesh& mesh);

/// Sets nodes that have passed the axis onto it, and middles of edges so that no point of an edge is beyond it: glass
/// that arrives there meets its mirror image.
double keep_beside_axis(core::Geometry geometry, core::Mesh& mesh);

/// Constraints of a node whose normals differ by less than 3 degrees (this is the cosine) count as one.
inline constexpr double same_direction = 0.9986;

}  // namespace parison::forming
