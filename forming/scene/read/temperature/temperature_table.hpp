#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "core/case/case_file.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Temperatures of a CSV file with a heading such as r_mm,z_mm,T_degC: along r, along z, or a row for each point of a
/// grid of both in any order; linear between the points, that of the nearest beyond them.
StartField read_temperature_table(const core::CaseNode& node, const std::string& directory);

}  // namespace parison::forming
