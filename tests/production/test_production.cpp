// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/scene_text.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/study/production/cycle_files.hpp"
#include "forming/study/production/fixed_point.hpp"
#include "forming/study/production/periodic_state.hpp"
#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {
namespace {

/// A slab of glass that lies on an iron plate for a second; the plate is cooled from below.
const std::string slab = R"(case = "slab"
geometry = "planar"
air = { temperature = "50 degC", h = "20 W/m2/K", ambient = "50 degC" }
interface = [{ tools = ["plate"], law = "constant", h = "3000 W/m2/K" }]
stage = [{ name = "contact", duration = "1 s", tools = ["plate"] }, { name = "free", duration = "1 s", tools = [] }]
[material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "3 W/m/K"
)" + iron + R"([glass]
material = "glass"
temperature = "1000 degC"
boundary = [{ name = "bottom", path = "(0, 0) (5, 0) mm", condition = "contact" },
            { name = "right", path = "(5, 10) mm", condition = "symmetry" },
            { name = "top", path = "(0, 10) mm", condition = "contact" },
            { name = "left", path = "(0, 0) mm", condition = "symmetry" }]
[[tool]]
name = "plate"
material = "iron"
temperature = "300 degC"
boundary = [{ name = "face", path = "(5, 0) (0, 0) mm", condition = "contact" },
            { name = "left", path = "(0, -20) mm", condition = "symmetry" },
            { name = "back", path = "(5, -20) mm", condition.cooled = { h = "400 W/m2/K", temperature = "50 degC" } },
            { name = "right", path = "(5, 0) mm", condition = "symmetry" }]
)";

const StopRequest never;
const Progress silent = [](const std::string&) {};

/// Changed text of the scene.
std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

PeriodicState periodic(const Scene& scene, const std::string& folder, double tolerance = 0.5) {
  PeriodicRequest request;
  request.tolerance = tolerance;
  request.directory = (tests::folder_of_test("result") / folder).string();
  PeriodicState state = find_periodic_state(scene, machine_cycle(scene, 8.0), request, never, silent);
  write_periodic_state(scene, request, state);
  return state;
}

std::string refusal(const std::string& text, const std::optional<double>& seconds) {
  try {
    machine_cycle(scene_of(text), seconds);
  } catch (const core::CaseError& error) {
    return error.what();
  }
  return "";
}

TEST(FixedPoint, is_found_sooner_with_acceleration_where_plain_iteration_creeps) {
  const Eigen::VectorXd rate = Eigen::VectorXd::LinSpaced(5, 0.5, 0.98), start = Eigen::VectorXd::Zero(5);
  const VectorMap map = [&](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(rate.cwiseProduct(x) + Eigen::VectorXd::Ones(5));
  };
  const auto size = [](const Eigen::VectorXd& change) { return change.lpNorm<Eigen::Infinity>(); };
  const auto fast = find_fixed_point(start, map, {1e-8, 5, 2000, size});
  const auto plain = find_fixed_point(start, map, {1e-8, 0, 2000, size});
  ASSERT_TRUE(fast.converged && plain.converged);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(fast.value[i], 1 / (1 - rate[i]), 1e-5);
  EXPECT_LT(10 * fast.evaluations, plain.evaluations);
}

TEST(FixedPoint, search_ends_where_the_map_cannot_be_evaluated) {
  int calls = 0;
  const VectorMap map = [&](const Eigen::VectorXd& x) -> std::optional<Eigen::VectorXd> {
    if (++calls == 3) return std::nullopt;
    return Eigen::VectorXd(2 * x);
  };
  const auto found =
      find_fixed_point(Eigen::VectorXd::Ones(2), map, {1e-8, 0, 100, [](const auto& x) { return x.norm(); }});
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.evaluations, 2);
}

TEST(PeriodicState, is_that_of_hundreds_of_plain_cycles) {
  const Scene scene = scene_of(slab);
  const PeriodicState state = periodic(scene, "cycle", 0.1);
  ASSERT_EQ(state.failure, "");
  EXPECT_TRUE(state.is_confirmed(0.1));
  EXPECT_LE(state.search.size(), 5u);
  const State initial = initial_state(scene);
  Eigen::VectorXd plain = tool_temperatures(initial);
  int cycles = 0;
  for (double change = 1; change > 1e-3 && cycles < 400; ++cycles) {
    const CycleRun run = run_cycle(with_tools_at(scene, initial, plain), state.cycle, "", never);
    ASSERT_EQ(run.failure, "");
    change = (run.end - plain).lpNorm<Eigen::Infinity>();
    plain = run.end;
  }
  EXPECT_GT(cycles, 50);
  EXPECT_LT(surface_change(initial, state.settled.start - plain), 0.1);
  RecordProperty("plain_cycles", cycles);
  RecordProperty("forming_runs", static_cast<int>(state.search.size()));
}

TEST(PeriodicState, gives_off_as_much_heat_as_it_receives) {
  const PeriodicState state = periodic(scene_of(slab), "cycle", 0.05);
  ASSERT_EQ(state.failure, "");
  const CycleHeat& heat = state.settled.heat.front();
  double out = 0;
  for (const double part : heat.through) out += part;
  ASSERT_GT(heat.received, 0);
  EXPECT_NEAR(out, heat.received, 2e-3 * heat.received);
}

TEST(PeriodicState, a_case_can_start_from_its_tools) {
  const Scene scene = scene_of(slab);
  const PeriodicState state = periodic(scene, "cycle");
  ASSERT_EQ(state.failure, "");
  const auto tools = tests::folder_of_test("result") / "cycle/tools";
  const Scene warm =
      scene_of(with(slab, "temperature = \"300 degC\"", "temperature = { from = \"" + tools.string() + "\" }"));
  EXPECT_LT((tool_temperatures(initial_state(warm)) - state.settled.start).lpNorm<Eigen::Infinity>(), 0.01);
}

TEST(PeriodicState, temperatures_follow_the_whole_machine_cycle) {
  const PeriodicState state = periodic(scene_of(slab), "cycle");
  ASSERT_EQ(state.failure, "");
  const auto& samples = state.settled.samples;
  EXPECT_EQ(samples.front().time, 0);
  EXPECT_EQ(samples.back().time, 8);
  EXPECT_EQ(samples.back().stage, "idle");
  double hottest = 0;
  for (const CycleSample& sample : samples) hottest = std::max(hottest, sample.tools[0].surface_mean);
  EXPECT_GT(hottest, samples.front().tools[0].surface_mean + 10);
  EXPECT_NEAR(samples.back().tools[0].surface_mean, samples.front().tools[0].surface_mean, 0.5);
}

TEST(MachineCycle, takes_its_time_from_the_timing_of_the_case) {
  const std::string timed =
      with(slab, "[material.glass]",
           "[timing]\ncuts = \"60 1/min\"\nsections = 6\nevent = { gob = \"0 deg\" }\n[material.glass]");
  EXPECT_DOUBLE_EQ(machine_cycle(scene_of(timed), std::nullopt).seconds, 6);
  EXPECT_DOUBLE_EQ(machine_cycle(scene_of(timed), 9.0).seconds, 9);
}

TEST(MachineCycle, without_a_time_is_refused) {
  EXPECT_NE(refusal(slab, std::nullopt).find("nothing says how long a machine cycle takes"), std::string::npos);
}

TEST(MachineCycle, shorter_than_the_use_of_a_tool_is_refused) {
  EXPECT_EQ(refusal(slab, 1.0), "");
  EXPECT_NE(refusal(slab, 0.9).find("uses the tool \"plate\" for 1 s"), std::string::npos);
}

TEST(MachineCycle, in_which_the_next_gob_comes_before_a_tool_is_free_is_refused) {
  const std::string late = with(slab, R"(stage = [)", R"(stage = [{ name = "wait", duration = "2 s", tools = [] }, )");
  EXPECT_EQ(refusal(late, 3.0), "");
  EXPECT_NE(refusal(late, 2.5).find("in use until 3 s"), std::string::npos);
}

TEST(MachineCycle, of_a_tool_that_nothing_cools_is_refused) {
  const std::string insulated = with(
      with(slab, R"(condition.cooled = { h = "400 W/m2/K", temperature = "50 degC" })", R"(condition = "insulated")"),
      R"(h = "20 W/m2/K")", R"(h = "0 W/m2/K")");
  EXPECT_NE(refusal(insulated, 8.0).find("the tool \"plate\" has no cooling"), std::string::npos);
}

}  // namespace
}  // namespace parison::forming
