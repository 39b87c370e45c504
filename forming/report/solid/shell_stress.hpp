#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/report/solid/shell_file.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The stress of glass that was cooled, over its section; empty where it was not.
SectionStress section_stress(const GlassState& glass);

/// The lines of *INITIAL CONDITIONS, TYPE=STRESS for a shell, MPa, at the points of the solids that CalculiX makes of
/// it: 27 of S8, 9 of S6, through the wall last (G. Dhondt, CalculiX CrunchiX user's manual, "Eight-node shell
/// element").
std::string initial_stress(const Shell& shell, const SectionStress& stress);

}  // namespace parison::forming
