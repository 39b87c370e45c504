#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/step/step_result.hpp"

namespace parison::forming {

/// How wrong the light of a run is, from some of its steps.
struct LightSamples {
  double heat = 0;       ///< exchanged by all bodies in the steps in which parts of the rays were compared, J
  double uncertain = 0;  ///< the part of it by which these differed, J
};

/// Compares, in one of some steps, the heat flows of parts of the rays: what they differ by tells how wrong light is.
void follow_light(const Scene& scene, const State& before, const StepResult& step, LightSamples& samples);

template <typename Visitor, typename Samples>
void visit_light_samples(Visitor visit, Samples& samples) {
  visit("heat", samples.heat);
  visit("uncertain", samples.uncertain);
}

}  // namespace parison::forming
