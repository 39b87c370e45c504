// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict, and that each check tells of its own number.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>

#include "../../scene_text.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/run/run.hpp"

namespace parison::forming {
namespace {

Check some_check(double value) {
  return {"drift", value, 0.01, 0.1, "%", "the glass lost so much; do something"};
}

TEST(Checks, a_number_is_inside_beyond_or_far_beyond_and_no_number_is_the_worst) {
  EXPECT_EQ(some_check(0.01).verdict(), Verdict::inside);
  EXPECT_EQ(some_check(0.02).verdict(), Verdict::beyond);
  EXPECT_EQ(some_check(0.2).verdict(), Verdict::not_trustworthy);
  EXPECT_EQ(some_check(std::numeric_limits<double>::quiet_NaN()).verdict(), Verdict::not_trustworthy);
  EXPECT_FALSE(trustworthy({some_check(0), some_check(0.2)}));
  EXPECT_TRUE(trustworthy({some_check(0), some_check(0.02)}));
}

TEST(Checks, the_verdict_of_a_run_that_stopped_early_says_so) {
  Summary summary{};
  summary.run.checks = {some_check(0)};
  summary.run.completed = true;
  EXPECT_EQ(verdict_line(summary), "  verdict               all 1 checks inside their limits\n");
  summary.run.completed = false;
  EXPECT_EQ(verdict_line(summary),
            "  verdict               stopped before its end; until then all 1 checks inside their limits\n");
}

TEST(Checks, the_verdict_counts_or_names_them_and_a_complaint_has_number_limit_and_advice) {
  EXPECT_EQ(verdict_sentence({some_check(0), some_check(0)}), "all 2 checks inside their limits");
  EXPECT_EQ(verdict_sentence({some_check(0), some_check(0.02)}), "drift beyond the limit; of 2 checks");
  EXPECT_EQ(verdict_sentence({some_check(0.2)}), "not trustworthy: drift far beyond the limit; of 1 checks");
  EXPECT_TRUE(complaints({some_check(0)}).empty());
  ASSERT_EQ(complaints({some_check(0.02)}).size(), 1u);
  EXPECT_EQ(complaints({some_check(0.02)})[0], "drift is 2 %, the limit is 1 %: the glass lost so much; do something");
}

/// A number that a check watches in the results of a run, and a way to spoil it.
struct Spoilt {
  const char* check;
  std::function<void(State&, RunFacts&, double)> spoil;  ///< by a factor of some size
};

const std::vector<Spoilt> spoilt_numbers = {
    {"energy_imbalance", [](State& state, RunFacts&, double x) { state.totals.to_air += x * state.totals.to_tools; }},
    {"interface_flux", [](State&, RunFacts& facts, double x) { facts.diagnostics.max_flux_mismatch = x; }},
    {"thermal_skin", [](State&, RunFacts& facts,
                        double x) { facts.diagnostics.skins[0].wrong = x * facts.diagnostics.skins[0].exchanged; }},
    {"overshoot", [](State&, RunFacts& facts, double x) { facts.diagnostics.bounds[0].overshoot = x * 1e3; }},
    {"overshoot", [](State&, RunFacts& facts, double x) { facts.diagnostics.bounds[2].overshoot = x * 1e3; }},
    {"hot_glass", [](State& state, RunFacts& facts,
                     double x) { facts.diagnostics.hot_glass.work = x * state.totals.work.dissipation; }},
    {"undershoot", [](State&, RunFacts& facts, double x) { facts.diagnostics.bounds[0].undershoot = x * 1e3; }},
    {"undershoot", [](State&, RunFacts& facts, double x) { facts.diagnostics.bounds[1].undershoot = x * 1e3; }},
    {"conductance_table", [](State&, RunFacts& facts, double) { facts.diagnostics.clamped_lookups = 1; }},
    {"work_balance", [](State&, RunFacts& facts,
                        double x) { facts.stages.back().work.tools += x * facts.stages.back().work.dissipation; }},
    {"impact",
     [](State& state, RunFacts&, double x) { state.totals.work.impact_loss = x * state.totals.work.dissipation; }},
    {"volume_drift", [](State&, RunFacts& facts, double x) { facts.diagnostics.max_drift = x; }},
    {"penetration", [](State&, RunFacts& facts, double x) { facts.diagnostics.in_tools.node.share = x; }},
    {"edge_penetration", [](State&, RunFacts& facts, double x) { facts.diagnostics.in_tools.edge.share = x; }},
    {"axis", [](State&, RunFacts& facts, double x) { facts.diagnostics.off_axis = x * 0.01; }},
    {"flow_resolution",
     [](State&, RunFacts& facts, double x) { facts.diagnostics.work.unresolved = x * facts.diagnostics.work.sampled; }},
    {"failed_meshes", [](State& state, RunFacts&, double) { state.totals.remeshing.failed = 2; }},
    {"mesh_coarsening", [](State& state, RunFacts&, double x) { state.totals.remeshing.coarsening_factor = 1 + x; }},
    {"locked_contacts", [](State&, RunFacts& facts,
                           double) { facts.diagnostics.steps.locked_contacts = facts.diagnostics.steps.contacts; }},
    {"step_collapse",
     [](State& state, RunFacts& facts, double) { facts.diagnostics.steps.short_steps = state.totals.steps; }},
    {"inertia", [](State&, RunFacts& facts, double x) { facts.diagnostics.work.max_reynolds = 10 * x; }},
    {"coupling", [](State& state, RunFacts& facts,
                    double x) { facts.diagnostics.work.unforeseen = x * state.totals.work.dissipation; }},
    {"viscosity_cap", [](State& state, RunFacts& facts,
                         double x) { facts.diagnostics.work.capped = x * state.totals.work.dissipation; }},
};

TEST(Checks, each_tells_of_its_own_number_and_of_no_other_also_where_it_is_no_number) {
  const Scene scene = scene_of(small_scene);
  const RunOutcome whole = run(scene, {}, {});
  ASSERT_TRUE(whole.facts.completed) << whole.facts.reason;
  const Checks untouched = checks(scene, whole.state, whole.facts);
  ASSERT_EQ(complaints(untouched), std::vector<std::string>{});
  std::set<std::string> told;
  for (const auto& [name, spoil] : spoilt_numbers)
    for (const double size : {0.5, std::numeric_limits<double>::quiet_NaN()}) {
      RunOutcome outcome = whole;
      spoil(outcome.state, outcome.facts, size);
      const auto sentences = complaints(checks(scene, outcome.state, outcome.facts));
      ASSERT_EQ(sentences.size(), 1u) << name << " by " << size;
      EXPECT_EQ(sentences[0].rfind(std::string(name) + " is ", 0), 0u) << sentences[0];
      told.insert(name);
    }
  for (const Check& check : untouched) EXPECT_TRUE(told.count(check.name)) << check.name << " was not spoilt";
}

TEST(Checks, glass_that_a_cup_holds_at_rest_raises_none) {
  const std::string text = R"(case = "rest"
geometry = "axisymmetric"
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "100 Pa.s" }
[glass]
material = "liquid"
boundary = [{ name = "bottom", path = "(0, 0) (20, 0) mm", condition = "contact" },
  { name = "side", path = "(20, 20) mm", condition = "contact" },
  { name = "top", path = "(0, 20) mm", condition = "air" }, { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
[[tool]]
name = "cup"
friction = "slip"
boundary = [{ name = "outside", path = "(0, -10) (30, -10) (30, 40) (20, 40) mm", condition = "insulated" },
  { name = "inside", path = "(20, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -10) mm", condition = "symmetry" }]
[[stage]]
name = "rest"
duration = "1 s"
tools = ["cup"]
)";
  for (const char* load : {"gravity = \"-9.81 m/s2\"\n", "pressure.top = \"1 bar\"\n", "pressure.top = \"1 Pa\"\n"}) {
    const auto outcome = run_in_folder(scene_of(text + load), tests::absent_folder());
    EXPECT_TRUE(outcome.facts.completed) << load << outcome.facts.reason;
    EXPECT_EQ(complaints(outcome.facts.checks), std::vector<std::string>{}) << load;
    EXPECT_GT(outcome.facts.checks.size(), 8u);
  }
}

}  // namespace
}  // namespace parison::forming
