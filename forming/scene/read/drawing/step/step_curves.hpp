#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// What the CAD kernel finds in a STEP file; private to the files that read a scene.
#include <array>
#include <string>

namespace parison::forming {

using Space = std::array<double, 3>;

/// How a solid is to be cut.
struct StepCut {
  std::string axis;  ///< "x", "-y" and so on; empty: along the surfaces of revolution with the largest area
  double turn = 0;   ///< of the half plane about the axis, rad
};

/// What the CAD kernel finds in a file, as text: a line "refuse ...", or a line for each curve, in m:
/// "line" and two places; "arc" and three places; "spline", its degree, the number of control points, for each its
/// place and weight, and the knots. A solid comes as its section in the plane of x and z, x the distance from its axis,
/// with a line "note ..." about that axis. In the module of gmsh.
extern "C" void parison_find_curves(const std::string& path, const StepCut& cut, std::string& text);

/// The surface of the solids in a file as triangles: a line "refuse ...", or a line for each, "triangle" and its three
/// corners, m, in the frame of the cut, counterclockwise seen from outside. In the module of gmsh.
extern "C" void parison_find_triangles(const std::string& path, const StepCut& cut, std::string& text);

}  // namespace parison::forming
