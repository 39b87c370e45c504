#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/solution.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/balance/expansion.hpp"

namespace parison::forming {

/// Conservation of the glass volume. The flow equations conserve it at an instant; straight motion over a finite step
/// and remeshing do not. All that restores it is here:
///   1. the flow equations get a right-hand side div v that offsets the error as far as it can be predicted;
///   2. their solution gets a multiple of its dilatation mode, so that the step ends with the wanted volume;
///   3. the predicted mesh in the middle of a step gets one as well, of the mode of the last step;
///   4. a new mesh, and one of which edges were moved out of a tool, gets its volume by a shift of its surface.
/// Where density depends on temperature, "volume" is `conserved_volume`, and its conservation is that of mass:
///   5. a step whose heat ends with other temperatures than predicted gets one more multiple of the mode.

/// Volume of the glass beyond its initial one, m3.
double excess_volume(const Scene& scene, const State& state);

/// Volume that a step of length dt shall end with, m3: the initial volume; a larger error is reduced over several
/// steps.
double target_volume(const Scene& scene, const State& state, double dt);

/// The prescribed div v of a step, 1/s, from the volume error at its start and, where `velocity` is given, the error
/// that straight motion with it over dt makes beside the expansion. `midpoint` is the mesh on which the flow is solved.
double prescribed_dilatation_rate(const Scene& scene, const State& state, const core::Mesh& midpoint,
                                  const Eigen::VectorXd* velocity, double dt, const Expansion& expansion = {});

/// Adds so much of its dilatation mode to the flow that the step of length dt ends with the volume `target_volume`.
/// Leaves it unchanged where the mode is missing or hardly changes the volume.
void correct_volume(const Scene& scene, const State& state, double dt, const Eigen::VectorXd& end_temperature,
                    flow::Equilibrium& equilibrium);

/// Volume by which a step of length dt with such velocities (two per node, m/s) misses its `target_volume`, as a share
/// of the initial volume.
double missed_volume(const Scene& scene, const State& state, const Eigen::VectorXd& velocity, double dt,
                     const Eigen::VectorXd& end_temperature = {});

/// The velocity (two per node, m/s) with so much of the state's last dilatation mode that straight motion over dt leads
/// to the initial volume; unchanged where the mode is unknown or hardly changes the volume.
Eigen::VectorXd volume_conserving(const Scene& scene, const State& state, Eigen::VectorXd velocity, double dt,
                                  const Eigen::VectorXd& temperature = {});

/// Adds so much of the dilatation mode to a step of length dt behind `before` that glass whose density depends on
/// temperature has its mass at the temperatures found; the tools follow with `tool_mode`, m/s of each for 1/s.
void conserve_mass(const Scene& scene, const State& before, const std::vector<double>& tool_mode, double dt,
                   State& after);

/// Shifts the surface of a glass mesh, new or corrected, along its normals until it has the volume `target`, m3, to
/// round-off, edges moved out of tools with it:
/// the part that no tool touches, by the same distance everywhere and not into a tool; the whole surface, contacts as
/// well, where no part is free or the free part is so small that it would move far, for what is below a few micrometres
/// there.
void restore_volume(const Scene& scene, const State& state, double target, core::Mesh& mesh);

/// Restores a small volume by a shift of no more than a micrometre of the surface that is 20 um and more away from
/// every active tool, so that nothing has to be moved out of one afterwards. False, and nothing moved, where that is
/// not enough.
bool shift_free_surface(const Scene& scene, const State& state, double target, core::Mesh& mesh);

/// Volume of the glass relative to its initial one, minus 1.
double volume_drift(const Scene& scene, const State& state);

}  // namespace parison::forming
