// SPDX-License-Identifier: GPL-3.0-or-later
// Moulds that are not round, swept about the axis for heat.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/process/run_error.hpp"
#include "forming/scene/scene.hpp"
#include "forming/solid/swept_tool.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming::test {
namespace {

using core::Vector3;

/// The blow mould of the square jar with other values of the case.
SolidTool mould_with(const std::vector<std::string>& values) {
  const Scene scene =
      read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/square_jar/case.toml", "draft coarser 3", values);
  return swept_tool(scene, initial_state(scene), static_cast<Index>(scene.tools.size()) - 1);
}

double least_volume(const SolidTool& tool) {
  return core::point_volumes(tool.mesh.nodes, core::cell_list(tool.mesh, core::prism_table())).minCoeff();
}

TEST(SweptTool, sharp_corners_that_reach_through_the_cooled_side_as_drawn_keep_half_of_its_wall) {
  const SolidTool mould = mould_with({"dimension.corner_radius=2 mm", "tool.4.boundary.2.path=(40, 122) (40, 12) mm"});
  EXPECT_GT(least_volume(mould), 0);
  double farthest = 0;  // in the plane through the corners
  for (const Vector3& at : mould.mesh.nodes)
    if (std::abs(at[0] - at[1]) < 1e-6 && std::abs(at[2] - 0.06) < 0.03)
      farthest = std::max(farthest, at.head<2>().norm());
  const double corner = std::sqrt(2) * 28e-3 + 2e-3;
  EXPECT_GT(farthest, corner + 0.45 * 10e-3);
}

TEST(SweptTool, cooled_sides_far_from_the_corners_stay_round) {
  for (const Vector3& at : mould_with({}).mesh.nodes) EXPECT_LT(at.head<2>().norm(), 62e-3 * (1 + 1e-6));
}

TEST(SweptTool, a_shoulder_that_is_nearly_flat_on_a_wide_side_folds_no_cell) {
  EXPECT_GT(
      least_volume(mould_with({"dimension.half_width=58 mm", "tool.4.boundary.2.path=(83, 122) (83, 12) mm",
                               "tool.4.section={ half_depth = [[\"12 mm\", \"31.5 mm\"], [\"24 mm\", \"32 mm\"]] }"})),
      0);
}

TEST(SweptTool, sections_that_no_mesh_can_follow_are_told_with_the_place) {
  try {
    mould_with(
        {"tool.4.section={ half_depth = [[\"40 mm\", \"30 mm\"], [\"40.2 mm\", \"6 mm\"], [\"40.4 mm\", \"30 mm\"]] "
         "}"});
    FAIL();
  } catch (const core::RunError& error) {
    EXPECT_NE(std::string(error.what()).find("\"blow_mould\" fold near"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace parison::forming::test
