#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Tools of a changed case that overlap on the way that a given motion takes one of them, by more than a clearance, as
/// a sentence; empty where there are none. Where tools of the base overlap too, on a given way, where they stand or on
/// the way of a plunger that a force drives to its stop, they are meant to slide in each other. Stages that an event
/// may end before the motion does are left out: nobody knows how far it goes.
std::string new_overlap_on_the_way(const Scene& base, const Scene& changed);

}  // namespace parison::forming
