#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// A solid cut by the CAD kernel; included in the module of gmsh alone.
#include <TopoDS_Shape.hxx>
#include <string>

#include "forming/scene/read/drawing/step/step_curves.hpp"

namespace parison::forming {

/// The section of solids by a half plane from their axis, moved into the plane of x (distance from the axis) and z
/// (along the axis, from the foot of the origin). `text` gets a line "note ..." about the axis, or "refuse ..." where
/// there is no section.
TopoDS_Shape section_of_solid(const TopoDS_Shape& solids, const StepCut& cut, std::string& text);

}  // namespace parison::forming
