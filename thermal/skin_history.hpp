#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "thermal/skin_error.hpp"

namespace parison::thermal {

/// What a surface exchanges heat with: a conductance, W/m2/K, infinite where the surface's own temperature is given, to
/// surroundings of a temperature, K.
struct SkinLoad {
  double h = 0, temperature = 0;
};

/// A time, s, in which that runs evenly from a start to an end.
struct SkinInterval {
  double duration;
  SkinLoad start, end;
};

/// The exchange of a surface from the start of a run on: pulses, stages and ramps are intervals of their own.
using SkinHistory = std::vector<SkinInterval>;

/// Error of the heat that a layer of one temperature at the start, K, exchanges on such a mesh: at the end of an
/// interval at which it is worst, over all heat that has passed without sign. Both by integration in time of the column
/// under the surface, on its mesh and on a fine one.
double skin_error(const SkinSide& side, double start_temperature, const SkinHistory& history);

/// The largest first cell, m, not above that of `side`, with which that error keeps within `tolerance`, as it does with
/// all smaller ones.
double fitting_first_cell(const SkinSide& side, double start_temperature, const SkinHistory& history, double tolerance);

}  // namespace parison::thermal
