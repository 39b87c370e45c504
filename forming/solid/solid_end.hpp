#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_state.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {

/// What conditions that end a stage are about, of glass in space at a time since the present stage's start, s. The
/// measure looks at `scene`, `clock` and `solid` when it is called.
EndMeasure end_measure(const Scene& scene, const State& clock, double stage_time, const SolidState& solid);

}  // namespace parison::forming
