// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/cooling/wall_stress.hpp"

#include <fmt/format.h>

#include "core/math/numbers.hpp"
#include "forming/state/sample.hpp"
#include "forming/step/cooling/cooling_step.hpp"

namespace parison::forming {

namespace {

/// Parts of the way through the wall, two for each parabola of Simpson's rule.
constexpr Index parts = 16;

StressThroughWall through_wall(const Eigen::ArrayXd& stress) {
  double sum = 0;
  for (Index i = 0; i < parts; i += 2) sum += stress[i] + 4 * stress[i + 1] + stress[i + 2];
  const double mean = sum / (3 * parts);
  return {mean, stress[0] - mean, stress[parts / 2] - mean, stress[parts] - mean};
}

}  // namespace

std::vector<WallStress> wall_stress(const GlassState& glass, const std::vector<ThicknessRow>& rows) {
  std::vector<WallStress> wall;
  const Eigen::VectorXd nodal = nodal_stress(glass);
  if (nodal.size() == 0) return wall;
  std::vector<Point> places, normals;
  for (const ThicknessRow& row : rows) {
    if (!row.is_wall()) continue;
    wall.push_back({row.arc, row.thickness, row.position, {}, {}});
    normals.push_back((row.inner_position - row.position).normalized());
    for (Index i = 0; i <= parts; ++i)
      places.push_back(row.position + (row.inner_position - row.position) * double(i) / parts);
  }
  const Eigen::MatrixXd stress = sample(glass.mesh, nodal, 4, places);
  for (std::size_t k = 0; k < wall.size(); ++k) {
    const auto here = stress.middleRows((parts + 1) * static_cast<Index>(k), parts + 1).array();
    const double r = -normals[k][1], z = normals[k][0];  // along the wall
    wall[k].hoop = through_wall(here.col(2));
    wall[k].meridional = through_wall(r * r * here.col(0) + z * z * here.col(1) + 2 * r * z * here.col(3));
  }
  return wall;
}

std::string wall_stress_text(const std::vector<WallStress>& wall) {
  constexpr double megapascal = 1e6;
  std::string text = "arc_mm,r_outer_mm,z_outer_mm,thickness_mm";
  for (const char* direction : {"hoop", "meridional"})
    for (const char* part : {"mean", "outer", "middle", "inner"}) text += fmt::format(",{}_{}_MPa", direction, part);
  text += "\n";
  for (const WallStress& row : wall) {
    text += fmt::format("{:.8g},{:.8g},{:.8g},{:.8g}", row.arc / core::millimetre, row.outer[0] / core::millimetre,
                        row.outer[1] / core::millimetre, row.thickness / core::millimetre);
    for (const StressThroughWall& part : {row.hoop, row.meridional})
      for (const double stress : {part.mean, part.outer, part.middle, part.inner})
        text += fmt::format(",{:.5g}", stress / megapascal);
    text += "\n";
  }
  return text;
}

}  // namespace parison::forming
