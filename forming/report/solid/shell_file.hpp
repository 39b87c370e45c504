#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>
#include <vector>

#include "core/solid/hex_mesh.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// A node in the middle of the wall.
struct ShellNode {
  core::Vector3 at;  ///< mm, z along the axis
  double thickness;  ///< mm
  double outer;      ///< z of the outer side of the wall, mm
};

/// The middle of a wall as shells.
struct Shell {
  std::vector<ShellNode> nodes;
  /// Numbers of nodes from 1 on: corners, against the clock as seen from outside, then the middle after each corner.
  std::vector<std::vector<long>> elements;
};

/// Stress of a section at places in it, m: a row for each with rr, zz, hoop and rz, Pa, tension positive.
using SectionStress = std::function<Eigen::MatrixXd(const std::vector<core::Point>&)>;

/// What the glass of a shell is, and how it stands.
struct ShellGlass {
  double young;                 ///< Pa
  double poisson;               ///< Poisson's ratio
  double density;               ///< at room temperature, kg/m3
  int up;                       ///< 1 where the container stands along +z, -1 against it
  std::string remark;           ///< lines of the file: where the constants are from
  SectionStress residual = {};  ///< of a round container that was cooled; empty: none
};
/// Of the glass of a scene; constants that it does not have are those of the bundled flint.
ShellGlass shell_glass(const Scene& scene);

/// The shell as an input file for CalculiX or Abaqus, mm: shells S8R and S6 with the thickness at their nodes, sets,
/// material, and a step for each load of shell_loads.hpp. With residual stress shells are S8, whose three points
/// through the wall carry it, and a step without a load goes before.
std::string shell_text(const Shell& shell, const ShellGlass& glass);

}  // namespace parison::forming
