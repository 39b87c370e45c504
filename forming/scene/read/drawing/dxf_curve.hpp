#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Curved entities of a DXF file; private to the reading of drawings.
#include <vector>

#include "core/mesh/profile.hpp"
#include "forming/scene/read/drawing/dxf_file.hpp"

namespace parison::forming {

/// The arcs that stand for an ELLIPSE or a SPLINE, m; `unit` of a drawing unit in m.
std::vector<core::Segment> dxf_ellipse(const DxfFile& file, const DxfEntity& entity, double unit);
std::vector<core::Segment> dxf_spline(const DxfFile& file, const DxfEntity& entity, double unit);

}  // namespace parison::forming
