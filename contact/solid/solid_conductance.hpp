#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "contact/conductance/interface_conductance.hpp"
#include "core/solid/solid_interface.hpp"

namespace parison::contact {

/// What the conductance laws read of the points of an interface in space, point by point: pressure, law, opening and
/// closing rate, with area, gap and weight. Bodies and shape functions stay empty. For InterfaceConductance.
std::vector<core::InterfacePoint> conductance_points(const std::vector<core::SolidInterfacePoint>& points);

}  // namespace parison::contact
