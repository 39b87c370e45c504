#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "contact/mortar/surface.hpp"
#include "core/mesh/interface_point.hpp"

namespace parison::classical {

/// The coupling that the mortar interface replaces, for comparison only: each slave node exchanges, over its lumped
/// area, with the nearest point of the nearest master edge. Surfaces that touch along their whole length; law 0, no
/// pressure.
std::vector<core::InterfacePoint> classical_interface(const contact::Surface& slave, const contact::Surface& master,
                                                      core::Geometry geometry);

}  // namespace parison::classical
