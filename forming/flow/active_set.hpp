#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/balance.hpp"

namespace parison::flow {

/// The candidates that start closed: the guess, or those without a gap where it is empty.
std::vector<bool> initial_active_set(const Problem& problem, const std::vector<bool>& warm);

/// What an update of the contact set did.
struct ActiveSetChange {
  int changed = 0;  ///< contacts closed or opened
  int locked = 0;   ///< contacts that pull but stay closed, as they were opened too often
};

/// Closes the contacts that would be passed through and opens those that pull. `releases` counts how often each was
/// opened.
ActiveSetChange update_active_set(const Problem& problem, const Instant& instant, std::vector<bool>& active,
                                  std::vector<int>& releases);

/// What is known of the candidates that slide at Coulomb's limit.
struct Sliding {
  explicit Sliding(std::size_t candidates) : sense(candidates, 0), reversals(candidates, 0) {}
  std::vector<int> sense;      ///< 1 or -1 where the last iterate had the limit's friction, 0 elsewhere
  std::vector<int> reversals;  ///< how often that turned round
};

/// Friction of the candidates that are closed, as a line in the slip: Navier's, or Coulomb's limit at the last iterate,
/// where there is one, with the slip it had. A node whose slip turns round is brought back to Navier's line first.
void add_friction(const Problem& problem, const std::vector<bool>& active, const Eigen::VectorXd& area,
                  const Instant* last, Sliding& sliding, Constraints& constraints);

}  // namespace parison::flow
