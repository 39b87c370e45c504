// SPDX-License-Identifier: GPL-3.0-or-later
// Tools that reach resting glass inside a step: the moment, and the squeeze from it on.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/run/run.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/first_touch.hpp"

namespace parison::forming {
namespace {

constexpr double viscosity = 1e4, height = 0.01, radius = 0.02, force = 100;  // SI

/// A disc of 20 mm by 10 mm rests on a table; the face of a plunger is 3 mm above it. All slip.
Scene landing(const std::string& motion, const std::string& accuracy = "draft", const std::string& more = "") {
  return scene_of(fmt::format(R"(case = "landing"
geometry = "axisymmetric"
stage = [{{ name = "s", duration = "0.2 s", tools = ["table", "plunger"], motion.plunger = {{ {} }} }}]
{}
[material.m]
density = "2500 kg/m3"
viscosity = {{ law = "constant", value = "1e4 Pa.s" }}
[glass]
material = "m"
boundary = [{{ name = "bottom", path = "(0, 0) (20, 0) mm", condition = "contact" }},
 {{ name = "side", path = "(20, 10) mm", condition = "contact" }},
 {{ name = "top", path = "(0, 10) mm", condition = "contact" }},
 {{ name = "axis", path = "(0, 0) mm", condition = "symmetry" }}]
[[tool]]
name = "table"
friction = "slip"
boundary = [{{ name = "top", path = "(40, 0) (0, 0) mm", condition = "contact" }},
 {{ name = "axis", path = "(0, -10) mm", condition = "symmetry" }}, {{ name = "rest", path = "(40, -10) (40, 0) mm", condition = "insulated" }}]
[[tool]]
name = "plunger"
friction = "slip"
boundary = [{{ name = "face", path = "(0, 13) (30, 13) mm", condition = "contact" }},
 {{ name = "rest", path = ["(30, 33) mm","(0, 33) mm"], condition = "insulated" }}, {{ name = "axis", path = "(0, 13) mm", condition = "symmetry" }}]
)",
                              motion, more),
                  accuracy);
}

const std::string let_go =
    R"(force = "-100 N", speed_limit = [["0 s", "1e-6 m/s"], ["0.1 s", "1e-6 m/s"], ["0.1001 s", "0.1 m/s"]])";

TEST(FirstTouch, it_is_the_moment_at_which_the_gap_is_closed) {
  const auto moment = [](const std::string& motion, double ahead) {
    const Scene scene = landing(motion);
    return time_to_first_touch(scene, start_stage(scene, initial_state(scene), 0), ahead);
  };
  const std::string steady = R"(offset = [["0 s", "0 mm"], ["0.2 s", "-8 mm"]])";
  EXPECT_NEAR(moment(steady, 0.2), 0.075, 1e-6);
  EXPECT_TRUE(std::isinf(moment(steady, 0.07)));
  EXPECT_NEAR(moment(R"(offset = [["0 s", "0 mm"], ["0.1 s", "-2 mm"], ["0.2 s", "-6 mm"]])", 0.2), 0.125, 1e-6);
  EXPECT_NEAR(moment(R"(force = "-1 N", speed_limit = "0.1 m/s")", 0.2), 0.03, 1e-6);
  EXPECT_TRUE(std::isinf(moment(R"(force = "1 N", speed_limit = "0.1 m/s")", 0.2)));
}

TEST(FirstTouch, a_tool_that_would_pass_through_the_glass_meets_it) {
  const Scene scene = landing(R"(force = "-1 N", speed_limit = "1 m/s")");
  EXPECT_NEAR(time_to_first_touch(scene, start_stage(scene, initial_state(scene), 0), 0.2), 0.003, 1e-7);
}

TEST(FirstTouch, contact_that_spreads_along_a_surface_is_none) {
  const Scene scene = landing(R"(offset = [["0 s", "0 mm"], ["0.2 s", "-8 mm"]])");
  State state = start_stage(scene, initial_state(scene), 0);
  EXPECT_FALSE(std::isinf(time_to_first_touch(scene, state, 0.1)));
  for (const Index node : contact_nodes(state.glass.mesh))  // the outer half of the top is held
    if (const Point& x = state.glass.mesh.nodes[node]; x[1] > 0.0099 && x[0] > 0.5 * radius)
      state.glass.contact_tool[node] = 1;
  EXPECT_TRUE(std::isinf(time_to_first_touch(scene, state, 0.1)));
}

/// Height of the squeezed disc at the end, m.
double end_height(const Scene& scene, RunOutcome* outcome = nullptr) {
  RunOutcome result = run(scene);
  EXPECT_TRUE(result.facts.completed) << result.facts.reason;
  double top = 0;
  for (const Point& x : result.state.glass.mesh.nodes) top = std::max(top, x[1]);
  if (outcome) *outcome = std::move(result);
  return top;
}

TEST(FirstTouch, a_plunger_let_go_squeezes_resting_glass_from_the_touch_on) {
  const double volume = M_PI * radius * radius * height, free_flight = 0.1 + 0.5e-4 + 0.03;
  const double wanted = 1 / (1 / height + force * (0.2 - free_flight) / (3 * viscosity * volume));
  for (const auto& [accuracy, allowed] : {std::pair("draft", 0.01), std::pair("standard", 0.003)}) {
    RunOutcome outcome;
    const double found = end_height(landing(let_go, accuracy), &outcome);
    EXPECT_NEAR(found, wanted, allowed * (height - wanted)) << accuracy;
    EXPECT_NEAR(outcome.state.totals.work.tools, force * (height - wanted), allowed * force * (height - wanted));
    EXPECT_LT(outcome.state.totals.work.impact_loss, 1e-3 * outcome.state.totals.work.tools);
  }
}

TEST(Checks, work_lost_in_impact_is_told) {
  const auto told = [](const std::string& numerics) {
    const Scene scene = landing(let_go, "draft", numerics);
    RunOutcome outcome;
    end_height(scene, &outcome);
    const Checks found = checks(scene, outcome.state, outcome.facts);
    const auto at = std::find_if(found.begin(), found.end(), [](const Check& c) { return c.name == "impact"; });
    return at != found.end() && at->value > at->limit;
  };
  EXPECT_FALSE(told(""));
  EXPECT_TRUE(told(R"(numerics = { min_step = "0.09 s", initial_step = "0.1 s", max_step = "0.1 s" })"));
}

}  // namespace
}  // namespace parison::forming
