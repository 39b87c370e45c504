#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/tool_balance.hpp"

namespace parison::flow {

/// The candidates that start closed: the guess, or those without a gap where it is empty.
std::vector<bool> first_set(const Problem& problem, const std::vector<bool>& warm);

/// Closes the contacts that would be passed through and opens those that pull; true when the set changed. `releases` counts how
/// often each was opened.
bool update_set(const Problem& problem, const Instant& instant, std::vector<bool>& active, std::vector<int>& releases);

/// Navier drag per node, N.s/m, capped by Coulomb's limit at the last iterate where there is one.
Eigen::VectorXd friction_drag(const Problem& problem, const std::vector<bool>& active, const Eigen::VectorXd& area,
                              const Instant* last);

}  // namespace parison::flow
