#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
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
/// section 2): opens active contacts in tension and closes inactive ones that the velocities would penetrate.
/// `releases` counts per candidate how often it was opened.
ActiveSetChange update_active_set(const Problem& problem, const Response& response, std::vector<bool>& active,
                                  std::vector<int>& releases);

/// The candidates that slide at Coulomb's limit, from one iteration to the next.
struct CoulombSliding {
  explicit CoulombSliding(std::size_t candidates) : sense(candidates, 0), reversals(candidates, 0) {}
  std::vector<int> sense;      ///< sign of the slip where the last iteration had the limiting friction, 0 elsewhere
  std::vector<int> reversals;  ///< how often the slip changed its sign
};

/// Adds the friction of the active contacts as a linear function of the slip velocity: Navier's law, traction = beta
/// times slip over the contact `area` (m2 per node), or where that exceeds Coulomb's limit mu times the contact force
/// of the last response, that limit, linearised at the last slip. Contact force and slip lag by an iteration
/// (fixed-point iteration). A node whose slip changes its sign returns to Navier's law for one iteration. `last` may be
/// null.
void add_friction(const Problem& problem, const std::vector<bool>& active, const Eigen::VectorXd& area,
                  const Response* last, CoulombSliding& sliding, Constraints& constraints);

}  // namespace parison::flow
