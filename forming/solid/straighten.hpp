#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// When cells are set right.
struct StraightenLimits {
  double bearable = 0.2;  ///< least Jacobian of a cell over that at its centre, above which all stay as they are
  double wanted = 0.3;    ///< that is aimed at
};

/// Where cells of the glass have got bad, sets nodes through the wall back between its sides and slides columns along
/// them. Mass and heat stay exactly those of the whole; fields are taken where the nodes now are. Returns whether
/// nodes moved.
bool straighten(const flow::Material& material, const thermal::Material& thermal, SolidState& solid,
                const StraightenLimits& limits = {});

}  // namespace parison::forming
