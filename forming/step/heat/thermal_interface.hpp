#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/interface_point.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "thermal/problem.hpp"

namespace parison::forming {

/// Thermal interfaces of the glass with every active tool that has one, at the present positions.
std::vector<core::InterfacePoint> thermal_interface(const Scene& scene, const State& state);

/// Temperatures of both faces at a point, K.
struct FaceTemperatures {
  double glass, tool;
};

/// The same at all points of an interface.
struct FaceTemperatureArrays {
  Eigen::ArrayXd glass, tool;
};
FaceTemperatureArrays face_temperatures(const State& state, const std::vector<core::InterfacePoint>& interface);

/// Conductance of a point of the interface between faces of these temperatures, with its contact pressure and opening.
core::Conductance point_conductance(const Scene& scene, const core::InterfacePoint& point,
                                    const FaceTemperatures& temperature, long& clamped_lookups);

/// The same for all points of an interface, prepared for many evaluations; their openings are those at the time
/// `step_start`, s, and change from there.
thermal::InterfaceLaw interface_law(const Scene& scene, const std::vector<core::InterfacePoint>& interface,
                                    double step_start, long& clamped_lookups);

}  // namespace parison::forming
