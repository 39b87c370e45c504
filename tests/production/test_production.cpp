// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/scene_text.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/study/production/cycle_files.hpp"
#include "forming/study/production/heat_cycles.hpp"
#include "forming/study/production/machine_cycle.hpp"
#include "forming/study/production/periodic_state.hpp"
#include "forming/study/production/settled_estimates.hpp"
#include "forming/study/production/tool_fields.hpp"
#include "forming/study/production/wanted_cooling.hpp"

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
  write_periodic_state(scene, request, state, state.failure);
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
  const auto fast = find_fixed_point(start, map, {1e-8, 5, 0, 2000, size});
  const auto plain = find_fixed_point(start, map, {1e-8, 0, 0, 2000, size});
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
      find_fixed_point(Eigen::VectorXd::Ones(2), map, {1e-8, 0, 0, 100, [](const auto& x) { return x.norm(); }});
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.evaluations, 2);
}

/// A run that starts at one temperature, the same in all tools, changes by a tenth of what it has to go, and settles to
/// another.
void add_run(SettledEstimates& estimates, const State& tools, double start, double settled) {
  const auto size = tool_temperatures(tools).size();
  const auto all = [&](double value) { return Eigen::VectorXd::Constant(size, value).eval(); };
  estimates.add(all(start), all(start + 0.1 * (settled - start)), all(settled));
}

TEST(SettledEstimates, of_a_falling_series_is_the_last_one) {
  const State tools = initial_state(scene_of(slab));
  SettledEstimates estimates(tools, 0.5);
  for (double start = 100; start > 0.01; start *= 0.1) add_run(estimates, tools, start, 0.1 * start);
  EXPECT_FALSE(estimates.only_scatter());
  EXPECT_NEAR(estimates.mean()[0], 0.01 * 0.1, 0.01 * 0.1);
  EXPECT_LT(estimates.uncertainty(), 0.05);
  EXPECT_GT(estimates.uncertainty(), estimates.mean()[0]);
}

TEST(SettledEstimates, of_runs_that_only_scatter_is_their_mean_within_students_t) {
  const State tools = initial_state(scene_of(slab));
  SettledEstimates estimates(tools, 0.5);
  add_run(estimates, tools, 100, 9);
  add_run(estimates, tools, 9, 0.4);
  EXPECT_FALSE(estimates.only_scatter());
  add_run(estimates, tools, 0.4, -0.8);
  add_run(estimates, tools, -0.2, 1);
  EXPECT_TRUE(estimates.only_scatter());
  EXPECT_NEAR(estimates.mean()[0], 0.1, 1e-12) << "of the two last runs, whose distances are 1.2 K; not of that before";
  constexpr double t = 6.3138;  // Student's, one degree of freedom, 90 %
  EXPECT_NEAR(estimates.uncertainty(), t * 0.9, 1e-3);
  add_run(estimates, tools, 0.1, 1.0);
  EXPECT_NEAR(estimates.mean()[0], 0.4, 1e-12);
  EXPECT_NEAR(estimates.uncertainty(), 2.91999 * std::sqrt((1.44 + 0.36 + 0.36) / 2 / 3), 1e-3);
}

TEST(SettledEstimates, one_run_that_happens_to_settle_close_to_its_start_does_not_outweigh_the_others) {
  const State tools = initial_state(scene_of(slab));
  SettledEstimates estimates(tools, 0.5);
  for (const double settled : {0.6, -0.7, 0.01, 0.8}) add_run(estimates, tools, 0, settled);
  EXPECT_NEAR(estimates.mean()[0], 0.1775, 1e-12);
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

TEST(HeatCycles, of_a_thin_tool_settle_with_other_cooling_as_production_does) {
  Scene scene = scene_of(with(with(slab, "(0, -20)", "(0, -3)"), "(5, -20)", "(5, -3)"));
  const MachineCycle cycle = machine_cycle(scene, 8.0);
  const State initial = initial_state(scene);
  const auto settled = [&](const std::string& folder) {
    const PeriodicState state = periodic(scene, folder, 0.1);
    EXPECT_EQ(state.failure, "");
    return state.settled.start;
  };
  const Eigen::VectorXd before = settled("before");
  ASSERT_GT(before.size(), 0);
  HeatCycles cycles(scene, cycle, initial);
  ASSERT_TRUE(cycles.learn(run_cycle(with_tools_at(scene, initial, before), cycle, "", never)));
  for (const double h : {100.0, 1600.0}) {
    set_cooling(scene, {"plate", "back", h});
    const auto found = cycles.settled(before, 0.01);
    ASSERT_TRUE(found);
    const Eigen::VectorXd there = settled(h < 400 ? "warmer" : "colder");
    ASSERT_EQ(there.size(), before.size());
    EXPECT_GT(surface_change(initial, there - before), 100);
    EXPECT_LT(surface_change(initial, *found - there), 0.1 * surface_change(initial, there - before)) << h;
    RecordProperty("error_" + std::to_string(static_cast<int>(h)),
                   std::to_string(surface_change(initial, *found - there)));
  }
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

TEST(MachineCycle, that_no_machine_has_is_refused_and_an_unusual_one_is_told) {
  EXPECT_NE(refusal(slab, 1e6).find("--cycle-time: a machine cycle of 1e+06 s was found, where a container takes 2 s"),
            std::string::npos)
      << refusal(slab, 1e6);
  const std::string hours =
      with(slab, "[material.glass]", "[timing]\ncuts = \"0.01 1/min\"\nevent = { gob = \"0 deg\" }\n[material.glass]");
  EXPECT_NE(refusal(hours, std::nullopt).find("timing.cuts: a machine cycle of 6000 s was found"), std::string::npos);
  const Scene scene = scene_of(slab);
  EXPECT_THROW(machine_cycle(scene, 0.019, {{"plate", 100}}), core::CaseError);
  EXPECT_NO_THROW(machine_cycle(scene, 0.021, {{"plate", 100}}));
  const auto notes = [&](double seconds) { return notes_on_cycle(scene, machine_cycle(scene, seconds)); };
  EXPECT_TRUE(notes(100).empty());
  ASSERT_EQ(notes(300).size(), 1u);
  EXPECT_EQ(notes(300)[0].rfind("unusual, is it meant? --cycle-time: a machine cycle of 300 s", 0), 0u);
}

/// The same slab, which comes to the plate two seconds after the start of its container and loses nothing until then.
const std::string late = with(
    slab, R"(stage = [)",
    R"(stage = [{ name = "wait", duration = "2 s", tools = [], air = { temperature = "50 degC", h = "0 W/m2/K", ambient = "50 degC" } }, )");

TEST(MachineCycle, lets_a_tool_serve_the_container_before_while_the_next_one_starts) {
  EXPECT_EQ(refusal(late, 3.0), "");
  EXPECT_EQ(refusal(late, 2.5), "");
  EXPECT_NE(refusal(late, 0.9).find("uses the tool \"plate\" for 1 s"), std::string::npos);
  const Scene scene = scene_of(late);
  EXPECT_FALSE(scene_in_cycle(scene, machine_cycle(scene, 3.0)).tools[0].waits);
  EXPECT_TRUE(scene_in_cycle(scene, machine_cycle(scene, 2.5)).tools[0].waits);
}

TEST(PeriodicState, of_a_tool_that_overlaps_is_that_of_the_same_tool_from_its_own_first_use) {
  const auto of = [](const std::string& text, const std::string& folder) {
    PeriodicRequest request;
    request.tolerance = 0.02;
    request.directory = (tests::folder_of_test("result") / folder).string();
    const Scene scene = scene_of(text);
    const MachineCycle cycle = machine_cycle(scene, 2.5);
    return find_periodic_state(scene, cycle, request, never, silent);
  };
  const PeriodicState at_once = of(slab, "at_once"), waiting = of(late, "waiting");
  ASSERT_EQ(at_once.failure, "");
  ASSERT_EQ(waiting.failure, "");
  EXPECT_TRUE(waiting.is_confirmed(0.02));
  EXPECT_LT((waiting.settled.start - at_once.settled.start).lpNorm<Eigen::Infinity>(), 0.1);
  EXPECT_GT((waiting.settled.start - waiting.first.start).lpNorm<Eigen::Infinity>(), 50);
  EXPECT_NEAR(waiting.settled.heat[0].received, at_once.settled.heat[0].received,
              1e-3 * at_once.settled.heat[0].received);
  // The machine cycle begins half a second into the use by the container before.
  const auto& samples = waiting.settled.samples;
  EXPECT_EQ(samples.front().time, 0);
  EXPECT_EQ(samples.back().time, 2.5);
  EXPECT_NEAR(samples.front().tools[0].surface_mean, samples.back().tools[0].surface_mean, 0.05);
  double coldest = 1e9;
  for (const CycleSample& sample : samples) coldest = std::min(coldest, sample.tools[0].surface_mean);
  EXPECT_GT(samples.front().tools[0].surface_mean, coldest + 10);
}

TEST(MachineCycle, of_a_tool_of_which_sets_take_turns_is_so_many_times_as_long) {
  const Scene scene = scene_of(slab);
  const MachineCycle cycle = machine_cycle(scene, 0.9, {{"plate", 2}});
  EXPECT_DOUBLE_EQ(cycle.seconds_of(0), 1.8);
  EXPECT_FALSE(cycle.overlaps(0));
  EXPECT_THROW(machine_cycle(scene, 0.9, {{"plato", 2}}), core::CaseError);
  PeriodicRequest request;
  request.directory = (tests::folder_of_test("result") / "sets").string();
  request.tolerance = 0.05;
  const PeriodicState sets =
      find_periodic_state(scene, machine_cycle(scene, 4.0, {{"plate", 2}}), request, never, silent);
  const PeriodicState one = periodic(scene, "one", 0.05);
  ASSERT_EQ(sets.failure, "");
  EXPECT_LT((sets.settled.start - one.settled.start).lpNorm<Eigen::Infinity>(), 0.1);
}

/// The slab whose plate is swabbed.
std::string swabbed(int every) {
  return with(slab, "name = \"plate\"",
              "name = \"plate\"\nswab = { every = " + std::to_string(every) + ", heat = \"200 kJ/m2\" }");
}

TEST(Swab, takes_its_heat_from_the_surface_of_the_tool) {
  const Scene scene = scene_of(swabbed(4));
  const State initial = initial_state(scene);
  const SwabImprint swab = swab_imprint(scene, initial);
  ASSERT_EQ(swab.failure, "");
  const double area = 5e-3;  // of a metre of the section's depth, m2
  EXPECT_NEAR(swab.heat[0], 200e3 * area, 1e-6 * 200e3 * area);
  State cold = initial;
  set_tool_temperatures(tool_temperatures(initial) + swab.change, cold);
  const ToolSurface surface(initial.tools[0].mesh, scene.geometry);
  const double fall = surface.temperatures(initial.tools[0], 0).mean - surface.temperatures(cold.tools[0], 0).mean;
  const thermal::Material& iron_of_plate = *scene.tools[0].thermal;
  const double capacity = iron_of_plate.density * iron_of_plate.heat_capacity.y.front() * 20e-3 * area;
  EXPECT_NEAR(fall * capacity, swab.heat[0], 1e-3 * swab.heat[0]);
}

TEST(PeriodicState, with_swabs_gives_off_what_it_receives_less_what_they_take) {
  const PeriodicState state = periodic(scene_of(swabbed(4)), "cycle", 0.05);
  ASSERT_EQ(state.failure, "");
  EXPECT_TRUE(state.is_confirmed(0.05));
  const CycleHeat& heat = state.settled.heat.front();
  double out = 0;
  for (const double part : heat.through) out += part;
  EXPECT_NEAR(out + state.swab_heat[0] / 4, heat.received, 2e-3 * heat.received);
  // From one swab to the next the surface comes back, and over the four cycles it has the mean that was settled to.
  ASSERT_EQ(state.since_swab.size(), 4u);
  double mean = 0;
  for (const StartUpCycle& cycle : state.since_swab) mean += 0.25 * cycle.mean[0];
  const Scene scene = scene_of(slab);
  State tools = tools_of(initial_state(scene));
  set_tool_temperatures(state.settled.start, tools);
  const double settled = ToolSurface(tools.tools[0].mesh, scene.geometry).temperatures(tools.tools[0], 0).surface_mean;
  EXPECT_NEAR(mean, settled, 0.1);
  EXPECT_LT(state.since_swab.front().mean[0], settled - 5);
  EXPECT_GT(state.since_swab.back().mean[0], settled + 1);
  ASSERT_TRUE(state.just_swabbed);
  EXPECT_GT(state.just_swabbed->heat[0].received, heat.received);
}

TEST(PeriodicState, with_swabs_is_that_of_plain_cycles_with_a_swab_in_every_fourth) {
  const Scene scene = scene_of(swabbed(4));
  const PeriodicState state = periodic(scene, "cycle", 0.05);
  ASSERT_EQ(state.failure, "");
  const State initial = initial_state(scene);
  const SwabImprint swab = swab_imprint(scene, initial);
  const ToolSurface surface(initial.tools[0].mesh, scene.geometry);
  State tools = tools_of(initial);
  Eigen::VectorXd plain = state.settled.start;
  for (int k = 0; k < 60; ++k) {
    if (k % 4 == 0) plain += swab.change;
    if (k >= 56) {
      set_tool_temperatures(plain, tools);
      EXPECT_NEAR(state.since_swab[static_cast<std::size_t>(k - 56)].mean[0],
                  surface.temperatures(tools.tools[0], 0).surface_mean, 0.3)
          << k;
    }
    const CycleRun run = run_cycle(with_tools_at(scene, initial, plain), state.cycle, "", never);
    ASSERT_EQ(run.failure, "");
    plain = run.end;
  }
}

TEST(MachineCycle, whose_cooling_is_hotter_than_the_glass_is_refused) {
  const std::string hot =
      with(slab, R"(h = "400 W/m2/K", temperature = "50 degC")", R"(h = "400 W/m2/K", temperature = "1300 degC")");
  EXPECT_NE(
      refusal(hot, 8.0).find("what cools the tool \"plate\" has 1300 degC and more, but the glass starts at 1000"),
      std::string::npos);
  const std::string partly =
      with(hot, R"(path = "(5, 0) mm", condition = "symmetry" }]
)",
           R"(path = "(5, 0) mm", condition.cooled = { h = "400 W/m2/K", temperature = "50 degC" } }]
)");
  const Scene scene = scene_of(partly);
  const auto notes = notes_on_cycle(scene, machine_cycle(scene, 8.0));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes.front().find("the boundary \"back\" of the tool \"plate\" is `cooled` by what is hotter"),
            std::string::npos);
}

TEST(MachineCycle, of_a_tool_that_nothing_cools_is_refused) {
  const std::string insulated = with(
      with(slab, R"(condition.cooled = { h = "400 W/m2/K", temperature = "50 degC" })", R"(condition = "insulated")"),
      R"(h = "20 W/m2/K")", R"(h = "0 W/m2/K")");
  EXPECT_NE(refusal(insulated, 8.0).find("the tool \"plate\" has no cooling"), std::string::npos);
}

PeriodicState with_wanted(const Scene& scene, double wanted, const std::string& folder) {
  PeriodicRequest request;
  request.tolerance = 0.1;
  request.directory = (tests::folder_of_test("result") / folder).string();
  request.wanted = {{"plate", wanted}};
  const MachineCycle cycle = machine_cycle(scene, 8.0);
  check_wanted(scene, cycle, request.wanted);
  return find_periodic_state(scene, cycle, request, never, silent);
}

TEST(WantedCooling, is_that_with_which_the_surface_settles_to_the_wanted_temperature) {
  const Scene scene = scene_of(slab);
  const double kelvin = 273.15;
  const double before = range_of(periodic(scene, "case", 0.1).settled.samples, 0).mean;
  const double wanted = 480 + kelvin;
  ASSERT_GT(std::abs(wanted - before), 50);
  const PeriodicState state = with_wanted(scene, wanted, "wanted");
  ASSERT_EQ(state.failure, "");
  EXPECT_TRUE(state.is_confirmed(0.1));
  EXPECT_NEAR(range_of(state.settled.samples, 0).mean, wanted, 1);
  ASSERT_EQ(state.cooling.size(), 1u);
  EXPECT_EQ(state.cooling[0].key(), "tool.plate.boundary.back.condition.cooled.h");
  EXPECT_LE(state.search.size(), 6u);
  // The case with this cooling, started where it was, settles to the same without a word about wanted temperatures.
  Scene cooled = scene;
  set_cooling(cooled, state.cooling[0]);
  EXPECT_NEAR(range_of(periodic(cooled, "again", 0.1).settled.samples, 0).mean, wanted, 1);
}

TEST(WantedCooling, that_no_cooling_gives_is_told_in_a_sentence) {
  const Scene scene = scene_of(slab);
  EXPECT_NE(with_wanted(scene, 970 + 273.15, "hot")
                .failure.find("--want plate: 970 degC cannot be reached by any cooling: as good as insulated"),
            std::string::npos);
  EXPECT_NE(with_wanted(scene, 60 + 273.15, "cold")
                .failure.find("--want plate: 60 degC cannot be reached by any cooling: even with h = "),
            std::string::npos);
}

TEST(WantedCooling, of_what_has_none_to_change_is_refused_before_any_run) {
  const auto refused = [](const std::string& text, const std::vector<WantedTool>& wanted,
                          double seconds = 8) -> std::string {
    const Scene scene = scene_of(text);
    try {
      check_wanted(scene, machine_cycle(scene, seconds), wanted);
    } catch (const core::CaseError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refused(slab, {{"plate", 700}}), "");
  EXPECT_NE(refused(slab, {{"plato", 700}}).find("--want: \"plato\" was found (did you mean \"plate\"?)"),
            std::string::npos);
  EXPECT_NE(refused(slab, {{"plate", 700}, {"plate", 710}}).find("found twice"), std::string::npos);
  EXPECT_NE(refused(slab, {{"plate", 300}}).find("which no cooling gives"), std::string::npos);
  EXPECT_NE(refused(slab, {{"plate", 1300}}).find("which no cooling gives"), std::string::npos);
  EXPECT_EQ(refused(slab, {{"plate", 900}}), "");
  // By hand: 5e-3 m2 at 20 W/m2/K and 627 - 50 K lose 208 kJ in 3599 s; 0.12 kg of 1300 J/kg/K have 148 kJ above 50
  // degC.
  EXPECT_NE(refused(slab, {{"plate", 900}}, 3600).find("the glass of a container has 148 kJ"), std::string::npos);
  const std::string long_use =
      with(slab, R"(name = "contact", duration = "1 s")", R"(name = "contact", duration = "6 s")");
  EXPECT_EQ(refused(long_use, {{"plate", 400}}), "");
  const std::string over_time =
      with(slab, R"(h = "400 W/m2/K")", R"(h = [["0 s", "400 W/m2/K"], ["1 s", "300 W/m2/K"]])");
  EXPECT_NE(refused(over_time, {{"plate", 700}}).find("an h over time"), std::string::npos);
  const std::string given = with(slab, R"(condition.cooled = { h = "400 W/m2/K", temperature = "50 degC" })",
                                 R"(condition.temperature = "50 degC")");
  EXPECT_NE(refused(given, {{"plate", 700}}).find("a tool without a cooled boundary"), std::string::npos);
}

TEST(TemperatureTable, of_a_settled_tool_gives_a_case_its_temperatures) {
  const Scene scene = scene_of(slab);
  const PeriodicState state = periodic(scene, "cycle", 0.1);
  ASSERT_EQ(state.failure, "");
  const auto table = tests::folder_of_test("result") / "cycle/tools/plate.csv";
  const Scene warm =
      scene_of(with(slab, "temperature = \"300 degC\"", "temperature = { csv = \"" + table.string() + "\" }"));
  EXPECT_LT((tool_temperatures(initial_state(warm)) - state.settled.start).lpNorm<Eigen::Infinity>(), 0.5);
}

TEST(SurfaceRange, colder_than_production_is_told) {
  const Scene scene = scene_of(slab);
  const PeriodicState state = periodic(scene, "cycle", 0.1);
  ASSERT_LT(range_of(state.settled.samples, 0).mean, 400 + 273.15);
  ASSERT_EQ(too_cold(scene, state.settled.samples).size(), 1u);
  EXPECT_NE(too_cold(scene, state.settled.samples)[0].find("the surface of \"plate\" settles at "), std::string::npos);
  EXPECT_TRUE(too_cold(scene, with_wanted(scene, 480 + 273.15, "wanted").settled.samples).empty());
}

}  // namespace
}  // namespace parison::forming
