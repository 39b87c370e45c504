#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// A glass node inside an active tool.
struct Penetration {
  Index node, tool;
  double depth;  ///< from the contact boundaries, m
};
/// All penetrations after a time `ahead`, s, with the present velocities.
std::vector<Penetration> penetrations(const Scene& scene, const State& state, double ahead);

/// Depth of the deepest glass node inside an active tool, m, or `known` where that is more: the distance to the face of
/// the tool that is closest, with or without contact. With what earlier steps had as `known` little is searched.
double max_penetration(const Scene& scene, const State& state, double known = 0);

/// The places on an edge, from 0 at its first node to 1 at its last, where penetration is looked for on every edge.
inline constexpr std::array<double, 9> edge_eighths{0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1};

/// Places on an edge (first, last, middle node, m, in the tool's frame) where penetration is looked for: its eighths
/// first, and where joints of the tool's outline lie beside it, since at a corner the tool may be deeper in the edge
/// than at any place chosen without it.
std::vector<double> places_on(const std::array<Point, 3>& edge, const core::Profile& outline);

/// Depth of the deepest of nine points on each edge of the glass that may touch, and of its places beside joints of a
/// tool's outline, in an active tool, m, or `known`: between nodes, a corner or a small radius of a tool can be deeper.
double max_edge_penetration(const Scene& scene, const State& state, double known = 0);

/// Depth of the deepest edge of `after` in a tool, behind its contact boundaries, m, where it is deeper than the
/// correction of edges leaves one that it can move and deeper than any of `before` by more than a step may move a node
/// into a tool; else 0.
double edge_depth_gained(const Scene& scene, const State& before, const State& after);

/// A boundary of a tool.
struct ToolFace {
  Index tool, boundary;
};
/// The face without contact, but no symmetry, through which a node of the glass has come into an active tool: that face
/// is the closest, a contact face at least twice as far, and the node deeper than 1 % of the mean wall or, in thick
/// glass, than steps leave it behind a contact face.
std::optional<ToolFace> entered_face(const Scene& scene, const State& state);

/// ", where contact boundary under of ring ends at its boundary hole, which has no contact" of a cell of the glass
/// with a node at such an end in an active tool; else empty.
std::string end_of_contact(const Scene& scene, const State& state, Index cell);

/// Raises the depths of nodes and edges in the totals of a state, in m and in mean walls of the glass as it is then,
/// and stores where and when the deepest were and the first face without contact through which glass has come.
void note_penetration(const Scene& scene, State& state);

/// "the deepest, 0.02 mm, in plunger at (r, z) = (3, 41.2) mm after 0.31 s"; empty where nothing was in a tool.
std::string place_of_penetration(const Scene& scene, double depth, const PenetrationPlace& place);

/// That glass has come into a tool through a face without contact, and what to do; empty where it has not.
std::string entered_face_sentence(const Scene& scene, const State& state);

}  // namespace parison::forming
