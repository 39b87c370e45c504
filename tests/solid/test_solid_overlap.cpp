// SPDX-License-Identifier: GPL-3.0-or-later
// Glass in space that is longer or wider than the mould that comes.
#include <gtest/gtest.h>

#include <cmath>

#include "forming/scene/container/container_plan.hpp"
#include "forming/solid/solid_step.hpp"
#include "solid/hex_block.hpp"

namespace parison::forming::test {
namespace {

using core::Index;
using core::Vector3;

/// A block of glass between two corners, m, and the blow mould of the square jar: half as wide as 30 mm, 95 mm long.
struct Hanging {
  Scene scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/square_jar/case.toml", "draft", {});
  State clock;
  SolidState solid;

  Hanging(const Vector3& from, const Vector3& to) {
    clock.tools.resize(scene.tools.size());
    solid.glass.mesh =
        tests::hex_block(1, 1, 1, [&](const Vector3& x) -> Vector3 { return from + (to - from).cwiseProduct(x); });
    solid.faces = core::test::boundary_faces(solid.glass.mesh);
    for (std::size_t t = 0; t < scene.tools.size(); ++t) {
      const Tool& tool = scene.tools[t];
      if (tool.name != "blow_mould") continue;
      solid.tools.emplace_back();
      solid.tools.back().tool = static_cast<Index>(t);
      solid.tools.back().surface = std::make_shared<contact::SectionSurface>(tool.profile, contact_boundaries(tool),
                                                                             tool.section, tool.position);
    }
  }
  SolidOverlap overlap(const std::string& stage) const {
    for (std::size_t s = 0; s < scene.stages.size(); ++s)
      if (scene.stages[s].name == stage)
        return deepest_overlap(scene, clock, solid, static_cast<Index>(s), SolidTools::coming);
    return {};
  }
};

TEST(SolidOverlap, says_whether_glass_is_too_long_or_too_wide_for_the_mould_that_comes) {
  const Hanging longer({0, 0, 0.06}, {0.01, 0.01, 0.1});
  EXPECT_TRUE(longer.overlap("run").is_end);
  EXPECT_NEAR(longer.overlap("run").depth, 7e-3, 1e-3);  // the middle of the base is 93 mm from the finish
  const Hanging wider({0, 0, 0.05}, {0.034, 0.01, 0.06});
  EXPECT_FALSE(wider.overlap("run").is_end);
  EXPECT_NEAR(wider.overlap("run").depth, 4e-3, 1e-4);
  EXPECT_NEAR(wider.overlap("run").at[0], 0.034, 1e-9);
  EXPECT_EQ(Hanging({0, 0, 0.05}, {0.029, 0.01, 0.06}).overlap("run").tool, -1);
}

TEST(SolidOverlap, tools_that_stay_are_not_asked) {
  EXPECT_EQ(Hanging({0, 0, 0.05}, {0.034, 0.01, 0.06}).overlap("blow").tool, -1);
}

}  // namespace
}  // namespace parison::forming::test
