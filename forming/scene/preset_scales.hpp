#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// How many times as long as in the presets the lengths of the numerics are for the glass of a scene: 1 up to 200 cm3,
/// beyond that they grow with the size of the body, the cube root of its volume, as its wall does. 1 where nothing
/// flows, and in planar scenes, whose depth has no meaning.
double preset_length_scale(const Scene& scene);

/// Makes the lengths of the numerics so long; the case has not been asked for its own yet.
void fit_preset_lengths(Scene& scene);

/// Whether a setting is one of these lengths.
bool is_length(const Setting& setting);

/// The longest step of a stage, s: numerics.max_step where the case has it. The preset's is for stages of up to 20 s;
/// in a longer one, glass that sags for minutes in a kiln, it grows with the duration.
double longest_step(const Scene& scene, const Stage& stage);

/// Between the fields that a run writes where the case does not say it, s: 0.1 s, in cases longer than a minute 600
/// times in all.
double usual_output_interval(const Scene& scene);

}  // namespace parison::forming
