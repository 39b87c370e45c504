#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "thermal/radiation/rays/ray_exchange.hpp"

namespace parison::thermal {

/// Numbers at the quadrature points times others.
Field product(Field a, const Field& b);

/// The rays of a body: those that were traced last, or new ones where since then a node has moved, the kind of a
/// boundary has changed, or a zone absorbs otherwise, too much.
std::shared_ptr<const TracedRays> trace_where_changed(const Light& light, const HeatSystem& system,
                                                      KeptTraces<TracedRays>& kept);

}  // namespace parison::thermal
