#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Curved entities of a DXF file; private to the reading of drawings.
#include <vector>

#include "core/mesh/profile.hpp"
#include "forming/scene/read/drawing/dxf/dxf_file.hpp"

namespace parison::forming {

/// How far a curve goes round from one angle to another, above zero and up to a `turn`, which is in the same unit:
/// whole turns do not count, but no way at all is a whole turn, as is one that rounded decimals make a hair longer.
/// Refuses more than ten turns.
double sweep_of(const DxfFile& file, const DxfEntity& entity, double from, double to, double turn);

/// The arcs that stand for an ELLIPSE or a SPLINE, m; `unit` of a drawing unit in m.
std::vector<core::Segment> dxf_ellipse(const DxfFile& file, const DxfEntity& entity, double unit);
std::vector<core::Segment> dxf_spline(const DxfFile& file, const DxfEntity& entity, double unit);

}  // namespace parison::forming
