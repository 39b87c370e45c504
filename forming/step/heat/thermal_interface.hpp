#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/interface_point.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "thermal/problem.hpp"

namespace parison::forming {

/// Thermal interfaces of the glass with every active tool that has one, at the present positions.
std::vector<core::InterfacePoint> thermal_interface(const Scene& scene, const State& state);

/// Conductance of a point of the interface at a glass surface temperature, K: contact pressure and viscosity into h.
core::Conductance point_conductance(const Scene& scene, const core::InterfacePoint& point, double temperature,
                                    long& clamped_lookups);

/// The same for all points of an interface, prepared for many evaluations.
thermal::InterfaceLaw interface_law(const Scene& scene, const std::vector<core::InterfacePoint>& interface,
                                    long& clamped_lookups);

}  // namespace parison::forming
