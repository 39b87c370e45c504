#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/run_in_progress.hpp"

namespace parison::forming {

/// The stages from Scene::solid on, in which the glass is a body in space; false when one cannot end, and the facts say
/// why. The round state stays as it was handed over, but for its clock and the places of tools. Glass that is a body in
/// space already goes on from the clock.
bool run_solid_stages(RunInProgress& run);

}  // namespace parison::forming
