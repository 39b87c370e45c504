// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/shell_stress.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"
#include "forming/state/sample.hpp"
#include "forming/step/cooling/cooling_step.hpp"

namespace parison::forming {
namespace {

using core::Point;
using core::Vector3;

constexpr std::size_t triangle_nodes = 6;

/// Shape functions of a shell: of eight nodes with a and b from -1 to 1, of six in a triangle from 0 on.
std::vector<double> shell_shape(std::size_t nodes, double a, double b) {
  if (nodes == triangle_nodes) {
    const auto shape = core::triangle_shape(a, b);
    return {shape.begin(), shape.end()};
  }
  const auto corner = [&](double i, double j) { return 0.25 * (1 + i * a) * (1 + j * b) * (i * a + j * b - 1); };
  return {corner(-1, -1),
          corner(1, -1),
          corner(1, 1),
          corner(-1, 1),
          0.5 * (1 - a * a) * (1 - b),
          0.5 * (1 - b * b) * (1 + a),
          0.5 * (1 - a * a) * (1 + b),
          0.5 * (1 - b * b) * (1 - a)};
}

/// A shell element as the solid that it stands for.
class ThickShell {
 public:
  ThickShell(const Shell& shell, const std::vector<long>& element) : shell_(shell), element_(element) {}
  /// Place at `c` from -1 inside to 1 outside, mm.
  Vector3 at(double a, double b, double c) const {
    const auto [middle, thickness] = in_middle(a, b);
    // Along each coordinate the functions are parabolas, whose chords are parallel to the tangent.
    const Vector3 along = in_middle(a + 1, b).first - in_middle(a - 1, b).first,
                  across = in_middle(a, b + 1).first - in_middle(a, b - 1).first;
    return middle + 0.5 * c * thickness * along.cross(across).normalized();
  }

 private:
  std::pair<Vector3, double> in_middle(double a, double b) const {
    const auto shape = shell_shape(element_.size(), a, b);
    Vector3 place = Vector3::Zero();
    double thickness = 0;
    for (std::size_t k = 0; k < shape.size(); ++k) {
      const ShellNode& node = shell_.nodes[static_cast<std::size_t>(element_[k]) - 1];
      place += shape[k] * node.at;
      thickness += shape[k] * node.thickness;
    }
    return {place, thickness};
  }

  const Shell& shell_;
  const std::vector<long>& element_;
};

/// Places of the integration points of an element in their order, mm.
std::vector<Vector3> points_of(const Shell& shell, const std::vector<long>& element) {
  const double outer = std::sqrt(0.6);  // of Gauss's three points
  const ThickShell thick(shell, element);
  std::vector<Vector3> places;
  for (const double c : {-outer, 0.0, outer})
    if (element.size() == triangle_nodes)
      for (const auto& [a, b] : {std::pair{1.0 / 6, 1.0 / 6}, {2.0 / 3, 1.0 / 6}, {1.0 / 6, 2.0 / 3}})
        places.push_back(thick.at(a, b, c));
    else
      for (const double b : {-outer, 0.0, outer})
        for (const double a : {-outer, 0.0, outer}) places.push_back(thick.at(a, b, c));
  return places;
}

/// Stress rr, zz, hoop, rz at a place as xx, yy, zz, xy, xz, yz.
std::string turned(const Eigen::Vector4d& stress, const Vector3& at) {
  const double radius = at.head<2>().norm(), x = radius > 0 ? at[0] / radius : 1, y = radius > 0 ? at[1] / radius : 0;
  const auto& [radial, axial, hoop, shear] = std::array{stress[0], stress[1], stress[2], stress[3]};
  return fmt::format("{:.5g}, {:.5g}, {:.5g}, {:.5g}, {:.5g}, {:.5g}", x * x * radial + y * y * hoop,
                     y * y * radial + x * x * hoop, axial, x * y * (radial - hoop), x * shear, y * shear);
}

}  // namespace

SectionStress section_stress(const GlassState& glass) {
  const Eigen::VectorXd nodal = nodal_stress(glass);
  if (nodal.size() == 0) return {};
  return [mesh = glass.mesh, nodal](const std::vector<Point>& places) { return sample(mesh, nodal, 4, places); };
}

std::string initial_stress(const Shell& shell, const SectionStress& stress) {
  constexpr double megapascal = 1e6;
  std::vector<Point> section;
  for (const auto& element : shell.elements)
    for (const Vector3& at : points_of(shell, element))
      section.emplace_back(core::millimetre * Point(at.head<2>().norm(), at[2]));
  const Eigen::MatrixXd found = stress(section) / megapascal;
  std::string text = "*INITIAL CONDITIONS, TYPE=STRESS\n";
  core::Index row = 0;
  for (std::size_t e = 0; e < shell.elements.size(); ++e) {
    int number = 0;
    for (const Vector3& at : points_of(shell, shell.elements[e]))
      text += fmt::format("{}, {}, {}\n", e + 1, ++number, turned(found.row(row++).transpose(), at));
  }
  return text;
}

}  // namespace parison::forming
