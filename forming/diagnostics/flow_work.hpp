#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/step/step_result.hpp"

namespace parison::forming {

/// Which part of the dissipated work is in doubt, since the start.
struct FlowWork {
  double capped = 0;      ///< dissipated where the glass should be stiffer than its viscosity is let be, J
  double unforeseen = 0;  ///< by which work of the steps would differ at the viscosity that their own heat gave, J
  double sampled = 0;     ///< dissipated by loads in the steps that were compared with the recovered rate, J
  double unresolved = 0;  ///< the part of it in the difference, J
  double max_reynolds = 0;
};

/// The work, J, that a step of such a length and flow dissipates where the viscosity is at its cap.
double capped_work(const Scene& scene, const State& start, const flow::Solution& flow, double dt);

/// Adds a step of glass that flows.
void follow_flow_work(const Scene& scene, const State& before, const StepResult& step, FlowWork& work);

template <typename Visitor, typename Work>
void visit_flow_work(Visitor visit, Work& work) {
  visit("capped", work.capped);
  visit("unforeseen", work.unforeseen);
  visit("sampled", work.sampled);
  visit("unresolved", work.unresolved);
  visit("max_reynolds", work.max_reynolds);
}

}  // namespace parison::forming
