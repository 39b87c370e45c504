#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/materials/material_library.hpp"

namespace parison::tools {

/// An SVG picture of the viscosities of the glasses among some materials over temperature; refused where none is a
/// glass.
std::string viscosity_picture(const std::vector<forming::NamedMaterial>& materials);

}  // namespace parison::tools
