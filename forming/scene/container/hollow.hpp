#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "core/case/table.hpp"
#include "forming/scene/container/free_space.hpp"

namespace parison::forming {

/// What upright glass holds: liquid poured in until it runs over, around whatever stands up inside.
struct Hollow {
  double rim;           ///< where it runs over, m along the axis
  double capacity;      ///< to the rim, m3
  core::Table content;  ///< of the depth below the rim, m: the volume below it, m3

  /// Volume to a depth below the rim, m3; nothing from the bottom on.
  std::optional<double> to_depth(double depth) const;
};

/// The hollow of glass that stands along the axis (`up` 1) or against it (-1). Nothing where none holds more than a
/// thousandth of the glass, as where the glass is open below.
std::optional<Hollow> hollow_of(const std::vector<Slice>& glass, int up);

}  // namespace parison::forming
