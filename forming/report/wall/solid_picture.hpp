#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/report/wall/solid_wall.hpp"

namespace parison::forming {

/// The whole container in space as an SVG picture: seen from the side and above with the colours of its wall thickness,
/// and its thickness over the height in both planes of symmetry and where it is thinnest.
std::string solid_picture(const Scene& scene, const SolidState& solid, const SolidWall& wall);

}  // namespace parison::forming
