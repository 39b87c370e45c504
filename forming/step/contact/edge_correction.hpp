#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Moves the middle nodes of edges that enter a tool of `state` between their ends out of it, as a constraint of the
/// flow cannot where glass slides around a corner: an edge of length L over a corner that turns by t cuts it by L t/10
/// within the way of half an edge. An edge may stay as deep as its ends are, or as a node at the tool. Edges
/// with no node that touches the tool stay as they are (`touched`: the tool of each node, -1 for none); one whose cell
/// would be inverted is moved as far as it can be. Whether any was moved.
bool move_edges_out(const Scene& scene, const State& state, const std::vector<Index>& touched, core::Mesh& mesh);

/// Slides the middle nodes of edges that touch a tool with all nodes, and lie in it between them, along the edge to its
/// middle, with all that the glass has there: on a rounding of the tool an edge whose middle node is off its middle
/// cuts the tool. Mass and heat of the glass stay. Whether any slid.
bool centre_middles(const Scene& scene, State& state);

/// The same two at the end of a step; volume, mass and heat of the glass stay.
void correct_edges(const Scene& scene, State& state);

}  // namespace parison::forming
