#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// What the CAD kernel finds in a STEP file; private to the files that read a scene.
#include <array>
#include <string>

namespace parison::forming {

using Space = std::array<double, 3>;

/// A curve as the CAD kernel has it, at three values of its parameter; of a part of a spline and the like also the
/// derivatives at its ends, with respect to a parameter from 0 to 1.
struct StepCurve {
  enum class Kind { line, arc, part } kind;
  Space start, mid, end;
  Space start_rate{}, end_rate{};
};
inline constexpr std::array step_curve_kinds{"line", "arc", "part"};

/// What the CAD kernel finds in a file, as text: a line "refuse ..." or a line for each curve, its kind and fifteen
/// coordinates in m. In the module of gmsh; works in the session that is open.
extern "C" void parison_find_curves(const std::string& path, std::string& text);

}  // namespace parison::forming
