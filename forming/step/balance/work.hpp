#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/solution.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Steps of which each may have an error in proportion to its own loss.
inline constexpr double usual_steps = 400;

/// Adds to `work`, J, the work of a step of length dt, s, from `start` with the velocities and forces of `flow`. The
/// work of gravity, air pressure and surface tension is computed from the positions before and after the step,
/// independently of the flow equations, so that the balance tests them.
void accumulate_work(const Scene& scene, const State& start, const flow::Solution& flow, double dt, Work& work);

/// The work, J without sign, by which the dissipation of a step (W at each quadrature point) would differ at the mean
/// viscosity over the step (Simpson's rule) of the temperatures that its heat gave, instead of that of those predicted
/// for its middle.
double unforeseen_work(const flow::Viscosity& viscosity, const core::Mesh& mesh, const std::vector<double>& dissipation,
                       const Eigen::VectorXd& predicted, const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                       double dt);

/// The work, J, by which an error of the work of a step counts: the greatest of all that was lost until `after` or done
/// by tools, air and gravity. Where nearly nothing was lost yet, the glass sinking by its own size is the measure. A
/// step that loses less than a 400th of the measure is compared with 400 times its own loss, but with a tenth of the
/// measure at least.
double measure_of_error(const Scene& scene, const State& start, const Work& before, const Work& after);

/// The work of a step that is neither lost nor stored in the surface nor `recovery`, J, which takes penetrated nodes
/// out of tools, over the measure of errors: the truncation error of the step. What an impact would create instead of
/// losing is an error too: glass that lands is held in tension there.
double work_error(const Scene& scene, const State& start, const Work& before, const Work& after, double recovery);

/// Least loss, J, that an imbalance is taken relative to: a share of what the loads of the present stage and those
/// before it could do. Less is what round-off does to glass at rest.
double least_loss(const Scene& scene, const State& state);

/// Work done on the glass that is neither lost nor stored in its surface, relative to what was lost; NaN where nothing
/// was.
double work_imbalance(const Work& work);

/// The same, relative to `least_loss`, J, where less was lost.
double work_imbalance(const Work& work, double least_loss);

}  // namespace parison::forming
