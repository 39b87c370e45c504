#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/tool_balance.hpp"

namespace parison::flow {

/// The candidates that start closed: the guess, or those without a gap where it is empty.
std::vector<bool> first_set(const Problem& problem, const std::vector<bool>& warm);

/// What an update of the contact set did.
struct SetChange {
  int changed = 0;  ///< contacts closed or opened
  int latched = 0;  ///< contacts that pull but stay closed, as they were opened too often
};

/// Closes the contacts that would be passed through and opens those that pull. `releases` counts how often each was opened.
SetChange update_set(const Problem& problem, const Instant& instant, std::vector<bool>& active, std::vector<int>& releases);

/// Navier drag per node, N.s/m, capped by Coulomb's limit at the last iterate where there is one.
Eigen::VectorXd friction_drag(const Problem& problem, const std::vector<bool>& active, const Eigen::VectorXd& area,
                              const Instant* last);

}  // namespace parison::flow
