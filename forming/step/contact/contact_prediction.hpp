#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/problem.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Initial guess of the active set for the flow solve, a flag for each candidate: contacts that were active in the last
/// solve (after a remesh or at a stage's start, when only the tool of each node is known, the node's first candidate
/// with that tool), and candidates that the velocity `guess`, m/s, would violate.
std::vector<bool> likely_contacts(const State& state, const ActiveContacts& active, const flow::Problem& problem,
                                  const Eigen::VectorXd& guess);

/// Adds to the candidates of each node those of `bounds` whose normals differ from all that the node has.
void keep_bounds(const std::vector<flow::ContactCandidate>& bounds, std::vector<flow::ContactCandidate>& candidates);

/// Candidates for both sides of the re-entrant corners in which the last step left nodes. The search by distance
/// returns only the nearer side where the corner is so flat that it counts as smooth.
std::vector<flow::ContactCandidate> corner_bounds(const Scene& scene, const State& state);

}  // namespace parison::forming
