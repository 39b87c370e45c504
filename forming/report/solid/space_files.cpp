// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/space_files.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "core/math/numbers.hpp"
#include "core/process/gmsh_module.hpp"
#include "core/process/run_error.hpp"
#include "core/solid/hex_geometry.hpp"
#include "forming/report/solid/kernel_work.hpp"
#include "forming/report/solid/triangles.hpp"
#include "forming/report/solid/wall_sheets.hpp"
#include "forming/report/solid/whole_turn.hpp"
#include "forming/report/wall/solid_wall.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

Vector3 at_place(const core::HexFaceNodes& nodes, double a, double b) {
  const auto along = core::line_shape(a), across = core::line_shape(b);
  Vector3 sum = Vector3::Zero();
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) sum += along[i] * across[j] * nodes.col(i + 3 * j);
  return sum;
}

/// The middle of the wall under a face of the inner side: places and thicknesses of its nine nodes, and the z of its
/// outer side over them, m.
struct MiddleFace {
  core::HexFace face;
  core::HexFaceNodes at;
  Eigen::Matrix<double, 9, 1> thickness, outer;
  bool outwards;  ///< whether the face's first direction times its second points out of the container
};

std::vector<MiddleFace> middle_faces(const SolidState& solid) {
  std::map<Index, Index> outer_of;
  for (const auto& column : solid.columns) outer_of[column.front()] = column.back();
  std::map<Index, double> thickness;
  for (const SolidWallPoint& point : solid_wall(solid).points) thickness[point.outer] = point.thickness;
  const auto& x = solid.glass.mesh.nodes;
  std::vector<MiddleFace> result;
  for (const core::HexFace& face : faces_of(solid, SolidSide::inner)) {
    MiddleFace middle{face, {}, {}, {}, true};
    const auto nodes = core::face_node_numbers(solid.glass.mesh, face);
    for (int n = 0; n < 9; ++n) {
      const Index outer = outer_of.at(nodes[n]);
      middle.at.col(n) = 0.5 * (x[nodes[n]] + x[outer]);
      middle.thickness[n] = thickness.at(outer);
      middle.outer[n] = x[outer][2];
    }
    const Vector3 across = x[outer_of.at(nodes[4])] - x[nodes[4]];
    middle.outwards = (middle.at.col(5) - middle.at.col(3)).cross(middle.at.col(7) - middle.at.col(1)).dot(across) > 0;
    result.push_back(middle);
  }
  return result;
}

double volume_of(const MiddleFace& middle) {
  constexpr int points = 3;
  double volume = 0;
  for (const auto& point : core::map_hex_face(middle.at, middle.face, points))
    volume += point.area * point.shape.dot(middle.thickness);
  return volume;
}

/// Numbers nodes by their places.
class ShellNodes {
 public:
  long number(const ShellNode& node, Shell& shell) {
    const auto [found, is_new] =
        numbers_.try_emplace({node.at[0], node.at[1], node.at[2]}, static_cast<long>(numbers_.size()) + 1);
    if (is_new) shell.nodes.push_back(node);
    return found->second;
  }

 private:
  std::map<std::array<double, 3>, long> numbers_;
};

/// The shell of which the nodes of the face are given in the order of hex_face_nodes.
std::vector<long> shell_of(const std::array<long, 9>& node, bool is_reversed) {
  std::array<int, 8> around{0, 1, 2, 5, 8, 7, 6, 3};  // corners and middles in turn
  if (is_reversed) std::reverse(around.begin() + 1, around.end());
  std::vector<long> corners, middles;
  for (std::size_t k = 0; k < 8; k += 2) {
    const long corner = node[around[k]], next = node[around[(k + 2) % 8]];
    if (corner == next) continue;  // an edge on the axis
    corners.push_back(corner);
    middles.push_back(node[around[k + 1]]);
  }
  corners.insert(corners.end(), middles.begin(), middles.end());
  return corners;
}

}  // namespace

SmoothSolid write_step(const std::string& path, const SolidState& solid) {
  static auto& sew = core::gmsh_function<decltype(parison_sew_solid)>("parison_sew_solid");
  const std::vector<SplinePatch> patches = wall_patches(solid);
  const std::string told =
      told_by_kernel(path, [&](std::string& text) { sew(core::unfinished_name(path), patches, text); });
  double volume = 0, from_nodes = 0, from_faces = 0;
  if (std::sscanf(told.c_str(), "%lf %lf %lf", &volume, &from_nodes, &from_faces) != 3 || !(volume > 0))
    throw core::RunError(fmt::format("{}: the CAD kernel made no solid of the glass: {}", path, told));
  core::take_made(path);
  return {cubic_millimetre * volume, core::millimetre * from_nodes, core::millimetre * from_faces};
}

double write_stl(const std::string& path, const SolidState& solid) {
  constexpr int pieces = 6;  // along a face
  const Copies copies(solid);
  Triangles triangles;
  for (const core::HexFace& face : solid.faces) {
    const core::HexFaceNodes nodes = core::face_nodes(solid.glass.mesh, face);
    const bool outwards = (face.axis == 1) != (face.end == 1);
    for (int copy = 0; copy < copies.count(); ++copy)
      for (int i = 0; i < pieces; ++i)
        for (int j = 0; j < pieces; ++j) {
          const auto corner = [&](int a, int b) {
            return copies.millimetres(at_place(nodes, double(i + a) / pieces, double(j + b) / pieces), copy);
          };
          const Vector3 from = corner(0, 0), to = corner(1, 1);
          Vector3 right = corner(1, 0), left = corner(0, 1);
          if (outwards == Copies::is_mirrored(copy)) std::swap(right, left);
          triangles.add(from, right, to);
          triangles.add(from, to, left);
        }
  }
  core::replace_file(path, triangles.file());
  return core::millimetre * core::millimetre * core::millimetre * triangles.volume();
}

ShellMesh write_shell(const std::string& path, const SolidState& solid, const ShellGlass& glass) {
  const Copies copies(solid);
  Shell shell;
  ShellNodes nodes;
  double volume = 0;
  for (const MiddleFace& middle : middle_faces(solid)) {
    volume += copies.count() * volume_of(middle);
    for (int copy = 0; copy < copies.count(); ++copy) {
      std::array<long, 9> number{};
      for (int n = 0; n < 9; ++n)  // a shell has no node in its middle
        if (n != 4)
          number[n] = nodes.number({copies.millimetres(middle.at.col(n), copy), middle.thickness[n] / core::millimetre,
                                    middle.outer[n] / core::millimetre},
                                   shell);
      shell.elements.push_back(shell_of(number, middle.outwards == Copies::is_mirrored(copy)));
    }
  }
  core::replace_file(path, shell_text(shell, glass));
  return {static_cast<long>(shell.elements.size()), static_cast<long>(shell.nodes.size()), volume};
}

}  // namespace parison::forming
