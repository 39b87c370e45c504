#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <variant>

#include "contact/conductance/conductance.hpp"

namespace parison::forming {

/// The laws of a contact by their names in a case, in the order of contact::ConductanceLaw.
inline constexpr std::array<const char*, std::variant_size_v<contact::ConductanceLaw>> law_names{
    "constant", "pressure-viscosity", "table", "gap"};

}  // namespace parison::forming
