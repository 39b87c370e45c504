#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <vector>

#include "forming/flow/balance.hpp"

namespace parison::flow {

/// The active set of the first iteration: the guess, or where that is empty the candidates without a gap; tied
/// candidates always.
std::vector<bool> initial_active_set(const Problem& problem, const std::vector<bool>& guess);

/// What an update of the active set did.
struct ActiveSetChange {
  int changed = 0;  ///< contacts closed or opened
  int locked = 0;   ///< contacts in tension that were kept closed, because they were opened too often
};

/// Step of the primal-dual active set strategy (M. Hintermueller, K. Ito, K. Kunisch, 2002, SIAM J. Optim. 13, 865-888,
/// section 2): closes inactive contacts that the velocities would penetrate and opens active ones in tension, those
/// whose tension is not small beside the largest (J. Nocedal, S. Wright, 2006, Numerical Optimization, section 16.5:
/// active-set methods drop the constraint with the most negative multiplier). What one opening gives to its neighbours
/// is seen before they open too. Without friction the result is the same; friction goes with the contact, so that more
/// than one set may be in balance, and the one near the guess is wanted. `area` is the contact area of the nodes, m2;
/// `releases` counts per candidate how often it was opened.
ActiveSetChange update_active_set(const Problem& problem, const Response& response, const Eigen::VectorXd& area,
                                  std::vector<bool>& active, std::vector<int>& releases);

/// The candidates that slide at Coulomb's limit, from one iteration to the next.
struct CoulombSliding {
  explicit CoulombSliding(std::size_t candidates)
      : sense(candidates, 0), reversals(candidates, 0), cap(candidates, std::numeric_limits<double>::quiet_NaN()) {}
  std::vector<int> sense;      ///< sign of the slip where the last iteration had the limiting friction, 0 elsewhere
  std::vector<int> reversals;  ///< how often the slip changed its sign
  std::vector<double> cap;     ///< limiting friction of the last iteration, N; NaN before the first
  int iterations = 0;

  /// The limiting friction of a candidate, N: `from_force` for so many iterations, from then on the last of those. With
  /// given limits (Tresca's friction) the problem is convex and its iteration cannot cycle.
  double cap_of(Index candidate, double from_force) {
    constexpr int max_updates = 30;
    if (iterations <= max_updates || std::isnan(cap[candidate])) cap[candidate] = from_force;
    return cap[candidate];
  }
};

/// Adds the friction of the active contacts as a linear function of the slip velocity: Navier's law, traction = beta
/// times slip over the contact `area` (m2 per node), or where that exceeds Coulomb's limit mu times the contact force
/// of the last response, that limit, linearised at the last slip. Contact force and slip lag by an iteration
/// (fixed-point iteration). A node whose slip changes its sign returns to Navier's law for one iteration. `last` may be
/// null.
void add_friction(const Problem& problem, const std::vector<bool>& active, const Eigen::VectorXd& area,
                  const Response* last, CoulombSliding& sliding, Constraints& constraints);

}  // namespace parison::flow
