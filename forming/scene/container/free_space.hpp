#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <optional>
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::forming {

/// A body that fills space, moved along the axis.
struct Solid {
  const core::Profile* profile;
  std::vector<bool> contact;  ///< by boundary: whether it may touch glass
  double shift = 0;           ///< m
};

/// A part of a line across the axis; there are two lines in each panel of the height, in order along the axis.
struct Slice {
  std::size_t line;
  double from, to;        ///< of the panel, m along the axis
  double inner, outer;    ///< radii, m
  double volume() const;  ///< of the half of the panel for which the line stands, turned about the axis, m3
};

/// A connected part of the space that no solid fills, turned about the axis.
struct FreeRegion {
  double volume = 0;                                     ///< m3, of what is bounded
  bool is_open = false;                                  ///< reaches outside, other than through a limit
  double low = 0, high = 0;                              ///< lowest and highest place, m
  bool from_low_limit = false, from_high_limit = false;  ///< reaches the lower (upper) limit
  std::vector<bool> touches;                             ///< by solid: with a contact boundary
  std::vector<Slice> slices;                             ///< what is bounded
};

/// The part of space that is looked at, m along the axis, and the width across and along it below which a gap
/// is closed.
struct SpaceLimits {
  std::optional<double> low, high;  ///< none: to the ends of the solids, beyond which all is open
  double sealed_gap = 0;
};

/// The regions between axisymmetric solids, found on lines across the axis. Nothing where the outlines are too fine for
/// it (more than some 300000 crossings with the lines).
std::optional<std::vector<FreeRegion>> free_regions(const std::vector<Solid>& solids, const SpaceLimits& limits);

/// What a solid fills, on lines across the axis; nothing where its outline is too fine, as above.
std::optional<std::vector<Slice>> slices_of(const Solid& solid);

/// Volume inside the contact boundaries of a solid, as if it had no bore, between two places along the axis, m3.
double contact_volume(const Solid& solid, double low, double high);

/// Distance that a solid can move along the axis (`sense` 1 or -1) until one of its contact boundaries meets that of
/// another one, which `met` names by its index; nothing where it never does.
struct Travel {
  double distance;  ///< m
  std::size_t met;
};
std::optional<Travel> free_travel(const Solid& moved, const std::vector<Solid>& others, double sense);

/// What ends a range of shifts: the place of a solid that the moved body meets there.
struct Stop {
  double shift;         ///< m along the axis, infinite where nothing is met
  std::size_t met = 0;  ///< index of the solid
  core::Point at = core::Point::Zero();
};

/// A range of shifts along the axis at which a body overlaps none of the solids.
struct FreeShifts {
  Stop low{-std::numeric_limits<double>::infinity()}, high{std::numeric_limits<double>::infinity()};
};

/// All such ranges of an axisymmetric body, in order; every boundary counts. Nothing where the outlines are too fine.
std::vector<FreeShifts> free_shifts(const Solid& moved, const std::vector<Solid>& solids);

}  // namespace parison::forming
