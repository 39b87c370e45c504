#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tolerances.hpp"

/// Tolerances on lengths with which a case is read, as shares of the size of a body or of a drawing (core::size), so
/// that a case and its scaled copy are accepted or refused alike. The length in brackets is that of a gob of 66 mm, as
/// for core::tolerance.
namespace parison::forming::tolerance {

/// Points of an outline that count as one, and distance from the axis that counts as on it (0.1 um: what rounded
/// decimals and CAD programs leave).
inline constexpr double joined = 1.5e-6;
/// Coordinates of a drawing that count as zero, so that its curves meet the axis exactly (1 pm: round-off of the
/// conversion of units).
inline constexpr double drawing_round_off = 1.5e-11;
/// Distance of a point of the case file from the curves of a drawing on which it lies (10 um: coordinates that are
/// given to hundredths of a millimetre).
inline constexpr double on_drawing = 1.5e-4;
/// Distance that the arcs which stand for a spline or an ellipse may have from it (1 um).
inline constexpr double curve = 1.5e-5;
/// Distance of two ends in a drawing that is reported as a gap and not as two outlines (1 mm).
inline constexpr double drawing_gap = 1.5e-2;
/// Distance of a probe from its body that counts as on the outline (1 um).
inline constexpr double on_outline = 1.5e-5;
/// Overlap of a tool and the glass in the drawings that counts as contact (1 um: the sagitta of sampled arcs is half
/// as large).
inline constexpr double initial_overlap = 1.5e-5;
/// Width of a gap between tools that counts as closed where the volume of a cavity is taken (0.1 mm: clearances of
/// plungers and moulds).
inline constexpr double sealed = 1.5e-3;

}  // namespace parison::forming::tolerance
