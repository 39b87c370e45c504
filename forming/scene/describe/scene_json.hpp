#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/json.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Adds what describe_container and describe_unusual say of a scene, and the outlines of its bodies, to the object
/// that is open: `weight_g`, `volume_cm3`, `container`, `clearance`, `findings`, `bodies`, `cycle_s`, `stages`; lengths
/// in mm.
void add_scene(const Scene& scene, core::JsonWriter& json);

}  // namespace parison::forming
