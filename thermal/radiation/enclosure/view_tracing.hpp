#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "thermal/radiation/enclosure/enclosure.hpp"

namespace parison::thermal {

inline constexpr double covered = 1e-3;  ///< share of an edge's area below which it is closed

/// The views that serve with these areas of the edges: those kept, or new ones where the bodies or the contacts have
/// changed too much since they were traced.
std::shared_ptr<const TracedViews> views_that_serve(const HeatSystem& system, const EdgeAreas& open,
                                                    const EdgeAreas& full, KeptTraces<TracedViews>& kept);

}  // namespace parison::thermal
