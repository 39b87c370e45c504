// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "forming/report/checks/checks.hpp"
#include "forming/run/run.hpp"
#include "forming/scene_text.hpp"

namespace parison::forming {
namespace {

/// A cylinder of container glass, 20 mm in radius, pressed to a share of its height in half a second.
std::string cylinder(double height, double share, double celsius) {
  const std::string head = R"(case = "cylinder"
geometry = "axisymmetric"
interface = [{ tools = ["base", "ram"], law = "constant", h = "2000 W/m2/K" }]
)";
  const std::string plates = R"([[tool]]
name = "base"
material = "iron"
temperature = "450 degC"
friction = "stick"
boundary = [{ name = "face", path = "(80, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -20) mm", condition = "symmetry" },
  { name = "rest", path = "(80, -20) (80, 0) mm", condition = "insulated" }]
[[tool]]
name = "ram"
material = "iron"
temperature = "450 degC"
friction = "stick"
boundary = [{ name = "face", path = "(0, 0) (80, 0) mm", condition = "contact" },
  { name = "rest", path = "(80, 20) (0, 20) mm", condition = "insulated" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
)";
  return head + container_glass("1.3 W/m/K") + iron +
         fmt::format(R"([glass]
material = "glass"
temperature = "{2} degC"
boundary = [{{ name = "surface", path = "(0, 0) (20, 0) (20, {0}) (0, {0}) mm", condition = "contact" }},
  {{ name = "axis", path = "(0, 0) mm", condition = "symmetry" }}]
[[stage]]
name = "press"
duration = "0.5 s"
tools = ["base", "ram"]
motion.ram = {{ offset = [["0 s", "{0} mm"], ["0.5 s", "{1} mm"]] }}
)",
                     height, share * height, celsius) +
         replaced("name = \"ram\"", fmt::format("name = \"ram\"\nposition = \"{} mm\"", height), plates);
}

/// Whether such a run failed was a matter of round-off: one start temperature tells nothing, many do.
TEST(StickingPlates, a_cylinder_is_pressed_to_its_end_from_any_start_temperature_and_the_hotter_the_easier) {
  for (const auto& [height, share] : {std::pair{20.0, 0.5}, std::pair{30.0, 0.4}}) {
    double work_before = 0;
    for (int i = 0; i < 20; ++i) {
      const double celsius = 1230 - 17.3 * i;
      const RunOutcome outcome = run(scene_of(cylinder(height, share, celsius)), {}, {});
      ASSERT_TRUE(outcome.facts.completed) << height << " mm, " << celsius << " degC: " << outcome.facts.reason;
      EXPECT_EQ(complaints(outcome.facts.checks), std::vector<std::string>{}) << celsius;
      EXPECT_GT(outcome.state.totals.work.tools, work_before) << celsius;
      work_before = outcome.state.totals.work.tools;
    }
  }
}

}  // namespace
}  // namespace parison::forming
