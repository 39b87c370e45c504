#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/study/search/goal.hpp"

namespace parison::forming {

/// What a finer accuracy adds to the results of a coarser one, from a place of the variables that was run at both.
/// Added to the runs at other places it makes of the coarser model one that agrees with the finer at that place (N. M.
/// Alexandrov, R. M. Lewis, C. R. Gumbert, L. L. Green and P. A. Newman, J. Aircraft 38 (2001) 1093-1101; J. W. Bandler
/// et al., IEEE Trans. Microwave Theory Tech. 52 (2004) 337-361).
struct Correction {
  Wall wall;                         ///< differences place by place over the outer arc; empty where one has no wall
  std::vector<Quantity> quantities;  ///< differences of those that both have
};

Correction correction_from(const Outcome& coarse, const Outcome& fine);

/// A run with the difference added; `wall_rms` and `wall_min` are those of the corrected wall. What the correction does
/// not have is left out, and a run without results stays as it is.
Outcome corrected(const Outcome& run, const Correction& correction, const WallPart& part);

/// Whether the finer accuracy misses `good_enough` or a limit which the coarser one held or came nearer to.
bool is_misled(const Goal& goal, const Worth& coarse, const Worth& fine);

}  // namespace parison::forming
