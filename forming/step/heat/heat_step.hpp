#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/interface_point.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/workspace.hpp"
#include "thermal/radiation/light_error.hpp"

namespace parison::forming {

/// Result of advance_heat.
struct HeatOutcome {
  bool converged = false;
  std::string reason;        ///< why it did not converge
  int substeps = 0;          ///< of the time integration
  double flux_mismatch = 0;  ///< between heat out of the glass and into a tool, relative
};

/// Advances the temperatures of all bodies from the state's time by dt, s, on their present meshes, and accumulates the
/// heat balance in the state's totals. `dissipation` is in W at each point of triangle_rule(4) of the glass, cell by
/// cell; empty for none. Static stages are integrated by IDA, all others by TR-BDF2. When it does not converge the
/// temperatures are those before.
HeatOutcome advance_heat(const Scene& scene, State& state, const std::vector<core::InterfacePoint>& interface,
                         const std::vector<double>& dissipation, double dt, Workspace& workspace);

/// Heat that leaves the glass in a state, W.
struct HeatRates {
  double to_air;                       ///< to air and, without light in bands, to the surroundings
  double light_to_air;                 ///< light in bands, to the surroundings and what an enclosure has there
  Eigen::ArrayXd conducted, radiated;  ///< by tool, through the contacts
};
HeatRates heat_rates(const Scene& scene, const State& state);

/// By how much parts of the rays differ in the heat flows of a state, across such an interface.
thermal::LightError light_error(const Scene& scene, const State& state,
                                const std::vector<core::InterfacePoint>& interface);

/// A body with what its boundaries exchange heat with in the present stage, on one of its meshes, which it points to.
/// A tool that waits for its first use exchanges none.
thermal::BodyView body_view(const Scene& scene, const State& state, Index body, const core::Mesh& mesh);

/// Local error that a heat step may have, K: that of the accuracy, or less where all temperatures differ by little.
double temperature_tolerance(const Scene& scene);
/// Options with this error, for a step that begins with a substep of so many s, as a whole where that is 0.
thermal::StepOptions heat_options(const Scene& scene, double initial_substep = 0);

}  // namespace parison::forming
