#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// A solid cut by the CAD kernel; included in the module of gmsh alone.
#include <TopoDS_Shape.hxx>
#include <gp_Ax3.hxx>
#include <optional>
#include <string>

#include "forming/scene/read/drawing/step/step_curves.hpp"

namespace parison::forming {

/// The frame in which solids are cut: z along their axis, x into the half plane, the origin the foot of that of the
/// file. `text` gets a line "refuse ..." where there is none.
std::optional<gp_Ax3> frame_of_cut(const TopoDS_Shape& solids, const StepCut& cut, std::string& text);

/// The section of solids by a half plane from their axis, moved into the plane of x (distance from the axis) and z
/// (along the axis, from the foot of the origin). `text` gets a line "note ..." about the axis, or "refuse ..." where
/// there is no section.
TopoDS_Shape section_of_solid(const TopoDS_Shape& solids, const StepCut& cut, std::string& text);

}  // namespace parison::forming
