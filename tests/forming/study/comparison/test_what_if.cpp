// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "../../pot_scene.hpp"
#include "../../scene_text.hpp"
#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/study/comparison/comparison.hpp"
#include "forming/study/comparison/same_case.hpp"
#include "forming/study/comparison/what_if/finished_base.hpp"
#include "forming/study/comparison/what_if/tool_overlap.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

/// The pot, and a stage of rest without the plunger.
std::string two_stages() {
  const std::string text = replaced("duration = \"0.4 s\"", "duration = \"0.1 s\"", pot);
  return replaced("[material.glass]",
                  "[[stage]]\nname = \"rest\"\nduration = \"0.1 s\"\ngravity = \"-9.81 m/s2\"\ntools = [\"pot\"]\n"
                  "[material.glass]",
                  text);
}

constexpr const char* coarse = "draft coarser 2";
const std::string longer = "stage.rest.duration=0.15 s", colder = "tool.pot.temperature=470 degC";

class WhatIfTest : public ::testing::Test {
 protected:
  const std::string folder = tests::absent_folder();
  std::string accuracy = coarse;
  void SetUp() override {
    fs::create_directories(folder);
    core::write_text(folder + "/case.toml", two_stages());
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string in(const std::string& name) const { return folder + '/' + name; }
  Scene scene(const std::vector<std::string>& overrides = {}) const { return read_scene(folder, accuracy, overrides); }
  WhatIf asked(const std::vector<WhatIfVariant>& variants) const { return {folder, coarse, in("out"), {}, variants}; }
  /// What planning these variants is refused with.
  std::string refusal(const std::vector<WhatIfVariant>& variants) const {
    try {
      plan_runs(asked(variants));
      return "";
    } catch (const core::CaseError& error) {
      return error.what();
    }
  }
  RunOutcome run_whole(const std::string& name, const std::vector<std::string>& overrides = {}) const {
    const Scene made = scene(overrides);
    const RunOutcome outcome = run_in_folder(made, in(name));
    write_summary(in(name), made, outcome);
    return outcome;
  }
};

const PlannedRun& named(const std::vector<PlannedRun>& runs, const std::string& label) {
  return *std::find_if(runs.begin(), runs.end(), [&](const PlannedRun& run) { return run.label == label; });
}

TEST_F(WhatIfTest, a_variant_begins_after_the_last_stage_that_its_change_cannot_have_influenced) {
  EXPECT_EQ(last_common_stage(scene(), scene({longer})), std::optional<std::string>("press"));
  EXPECT_EQ(last_common_stage(scene(), scene({colder})), std::nullopt);
  EXPECT_EQ(last_common_stage(scene(), scene({"stage.press.duration=0.09 s"})), std::nullopt);
  EXPECT_EQ(last_common_stage(scene(), scene({longer, colder})), std::nullopt);
  const auto runs = plan_runs(asked({{"longer", {longer}}, {"colder", {colder}}}));
  EXPECT_EQ(runs.front().label, "base");
  EXPECT_EQ(runs.size(), 3u * 3 + 2 * 2);  // three runs each, a twin of each coarser one from each of two points
  EXPECT_EQ(named(runs, "longer").branch->stage, "press");
  EXPECT_EQ(named(runs, "longer, 3 times coarser").branch->directory, in("out/base/coarser_run"));
  EXPECT_FALSE(named(runs, "colder").branch);
  EXPECT_TRUE(named(runs, "twin of base, 3 times coarser, after press").branch->warmer_tools);
}

TEST_F(WhatIfTest, twice_means_a_twin_of_the_base_and_of_each_variant_from_where_they_part) {
  WhatIf twice = asked({{"longer", {longer}}, {"colder", {colder}}});
  twice.twice = true;
  const auto runs = plan_runs(twice);
  // Each run and its nearest coarser one, three times; twins of both of the base, from two points, and of each variant.
  EXPECT_EQ(runs.size(), 3u * 2 + 2 * 2 + 2 * 2);
  const PlannedRun& twin = named(runs, "twin of longer, 2 times coarser, after press");
  EXPECT_EQ(twin.directory, in("out/longer/partner_run/twin_after_press"));
  EXPECT_EQ(twin.branch->directory, in("out/base/partner_run"));
  EXPECT_TRUE(twin.branch->warmer_tools);
  EXPECT_EQ(twin.overrides, std::vector<std::string>{longer});
  const PlannedRun& warmer = named(runs, "twin of colder");
  EXPECT_FALSE(warmer.branch);
  EXPECT_EQ(warmer.inside, in("out/colder"));
  EXPECT_EQ(read_scene(folder, coarse, warmer.overrides).tools[0].initial_temperature, 470 + 273.15 + twin_warmer);
}

TEST_F(WhatIfTest, a_run_that_is_there_is_the_base_with_what_it_has) {
  run_whole("made");
  WhatIf from = asked({{"longer", {longer}}});
  from.base_results = in("made");
  const FinishedBase base = read_finished_base(in("made"));
  EXPECT_EQ(base.case_path, in("made/case"));
  EXPECT_EQ(base.accuracy, coarse);
  const auto runs = plan_runs(from);
  EXPECT_EQ(runs.front().copy_of, in("made"));
  EXPECT_EQ(named(runs, "base, 3 times coarser").copy_of, "");
  copy_results(runs.front());
  EXPECT_EQ(core::read_text(in("out/base/history.csv")), core::read_text(in("made/history.csv")));
  EXPECT_TRUE(has_completed_here(in("out/base")));
}

TEST_F(WhatIfTest, runs_that_are_there_get_their_coarser_runs_and_the_first_of_them_twins) {
  run_whole("first");
  run_whole("second", {colder});
  const auto runs = plan_partner_runs(folder, {in("first"), in("second")});
  EXPECT_EQ(runs.size(), 2u * 2 + 2);
  const PlannedRun& coarser = named(runs, "results/second, 2 times coarser");
  EXPECT_EQ(coarser.directory, in("second/partner_run"));
  EXPECT_EQ(coarser.inside, in("second"));
  EXPECT_EQ(coarser.accuracy, "draft coarser 4");
  EXPECT_EQ(coarser.overrides, std::vector<std::string>{colder});
  EXPECT_EQ(named(runs, "twin of results/first, 3 times coarser").directory, in("first/coarser_run/twin"));
}

TEST_F(WhatIfTest, a_run_from_a_branch_is_the_changed_case_run_whole_to_the_last_bit) {
  const RunOutcome base = run_whole("base");
  const Scene changed = scene({longer});
  make_branch({"longer", in("longer"), coarse, changed.overrides, BranchPoint{in("base"), "press"}, ""}, folder);
  const RunOutcome branch = resume_in_folder(changed, in("longer"));
  write_summary(in("longer"), changed, branch);
  const RunOutcome whole = run_whole("whole", {longer});
  ASSERT_TRUE(branch.facts.completed) << branch.facts.reason;
  EXPECT_EQ(fingerprint(branch.state), fingerprint(whole.state));
  EXPECT_NE(fingerprint(branch.state), fingerprint(base.state));
  EXPECT_EQ(core::read_text(in("longer/history.csv")), core::read_text(in("whole/history.csv")));

  const Comparison comparison = compare_folders(in("base"), {in("longer")});
  EXPECT_EQ(comparison.others[0].result->in_common, 1u);
  EXPECT_EQ(settings_line(comparison.others[0].settings), "stage.rest.duration: 0.1 s -> 0.15 s");
}

/// The two stages, the second one in a sleeve that stands in the air, cooled, until then.
std::string with_sleeve() {
  std::string text = replaced("\"plunger\"]\nlaw", "\"plunger\", \"sleeve\"]\nlaw", two_stages());
  text = replaced("tools = [\"pot\"]", "tools = [\"sleeve\"]", text);
  text = replaced("case = \"pot\"", "case = \"pot\"\ndimension.depth = \"8 mm\"", text);
  return replaced("[numerics]", R"case([[tool]]
name = "sleeve"
material = "iron"
temperature = "480 degC"
friction = "stick"
boundary = [
  { name = "inner", condition = "contact", path = "(12, 20) (12, 0) (0, 0) mm" },
  { name = "axis", condition = "symmetry", path = "(0 mm, -depth)" },
  { name = "outer", condition.cooled = { h = "800 W/m2/K", temperature = "50 degC" }, path = "(20 mm, -depth) (20, 20) (12, 20) mm" } ]
[numerics])case",
                  text);
}

TEST_F(WhatIfTest, a_tool_that_was_not_used_yet_may_be_another_one) {
  accuracy = "draft";  // coarser, what the glass touches when it stands in the sleeve alone is a matter of nanometres
  core::write_text(folder + "/case.toml", with_sleeve());
  const RunOutcome base = run_whole("base");
  ASSERT_TRUE(base.facts.completed) << base.facts.reason;
  const auto common = [&](const std::vector<std::string>& overrides) {
    return last_common_stage(scene(), scene(overrides));
  };
  EXPECT_EQ(common({"tool.sleeve.temperature=430 degC"}), std::optional<std::string>("press"));
  EXPECT_EQ(common({"dimension.depth=12 mm"}), std::optional<std::string>("press"));
  EXPECT_EQ(common({"tool.sleeve.temperature=430 degC", colder}), std::nullopt);

  // A thicker and colder one stands there as it would in a run from the start.
  const std::vector<std::string> other{"dimension.depth=12 mm", "tool.sleeve.temperature=430 degC"};
  const Scene changed = scene(other);
  make_branch({"other", in("other"), accuracy, other, BranchPoint{in("base"), "press"}, ""}, folder);
  const RunOutcome branch = resume_in_folder(changed, in("other")), whole = run_whole("whole", other);
  ASSERT_TRUE(branch.facts.completed) << branch.facts.reason;
  const ToolState &sleeve = branch.state.tools[2], &expected = whole.state.tools[2], &before = base.state.tools[2];
  ASSERT_EQ(sleeve.mesh.nodes, expected.mesh.nodes);
  EXPECT_LT((sleeve.temperature - expected.temperature).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_NEAR(sleeve.heat_through[2], expected.heat_through[2], 1e-3 * expected.heat_through[2]);
  EXPECT_NEAR(sleeve.heat_received, expected.heat_received, 2e-3 * expected.heat_received);
  EXPECT_GT(sleeve.heat_received, 1.02 * before.heat_received);
  EXPECT_NEAR(branch.facts.diagnostics.extremes.tools[2].temperature,
              whole.facts.diagnostics.extremes.tools[2].temperature, 0.05);
  for (const Check& check : branch.facts.checks)
    if (check.name == "energy_imbalance") EXPECT_EQ(check.verdict(), Verdict::inside);
}

TEST_F(WhatIfTest, what_a_run_has_of_quantities_is_known_before_it_with_the_units) {
  run_whole("made");
  const std::vector<Quantity> possible = possible_quantities(scene());
  const Quantities made = read_finished_run(in("made")).quantities;
  EXPECT_GT(made.values.size(), 8u);
  for (const Quantity& quantity : made.values) {
    EXPECT_EQ(unknown_quantity(quantity.name, possible), "");
    for (const Quantity& one : possible)
      if (one.name == quantity.name) EXPECT_EQ(one.unit, quantity.unit) << one.name;
  }
  for (const Quantity& one : possible) {
    if (one.name.rfind("glass_", 0) == 0) EXPECT_DOUBLE_EQ(one.scale, made.find(one.name)->scale) << one.name;
    if (one.name.rfind("extent_", 0) == 0) {
      EXPECT_LT(one.scale, made.find(one.name)->scale) << one.name;
      EXPECT_GT(one.scale, 0.3 * made.find(one.name)->scale) << one.name;
    }
  }
  EXPECT_NE(unknown_quantity("heat_pott", possible).find("did you mean \"heat_pot\"?"), std::string::npos);
}

TEST_F(WhatIfTest, a_twin_has_tools_a_little_warmer_and_nothing_else) {
  run_whole("base");
  make_branch({"twin", in("base/twin_after_press"), coarse, {}, BranchPoint{in("base"), "press", true}, in("base")},
              folder);
  const auto at = [&](const std::string& path) { return read_checkpoint(path, scene()).outcome.state; };
  const State before = at(find_stage_end(in("base"), "press")), twin = at(find_checkpoint(in("base/twin_after_press")));
  EXPECT_NEAR((twin.tools[0].temperature - before.tools[0].temperature).minCoeff(), twin_warmer, 1e-9);
  EXPECT_EQ(twin.glass.temperature, before.glass.temperature);
  const RunOutcome outcome = resume_in_folder(scene(), in("base/twin_after_press"));
  write_summary(in("base/twin_after_press"), scene(), outcome);
  const FinishedRun base = read_finished_run(in("base"));
  ASSERT_EQ(base.twins.size(), 1u);
  EXPECT_EQ(base.twins[0].stages, 1u);
  const double heat = base.quantities.find("heat_pot")->value, moved = base.twins[0].quantities.find("heat_pot")->value;
  EXPECT_NE(moved, heat);
  EXPECT_NEAR(moved / heat, 1, 1e-2);
}

TEST_F(WhatIfTest, what_is_wrong_with_a_variant_is_said_with_its_name_before_anything_runs) {
  EXPECT_NE(refusal({{"good", {longer}}, {"bad", {"stage.rest.duratoin=1 s"}}})
                .find("variant bad (stage.rest.duratoin=1 s): --set: stage.rest.duratoin: unknown key (did you mean "
                      "\"duration\"?)"),
            std::string::npos);
  EXPECT_NE(refusal({{"deep", {"tool.plunger.position=-2 mm"}}}).find("variant deep (tool.plunger.position=-2 mm): "),
            std::string::npos);
  EXPECT_NE(refusal({}).find("no variant was found"), std::string::npos);
  EXPECT_NE(refusal({{"empty", {}}}).find("nothing that it changes"), std::string::npos);
  EXPECT_NE(refusal({{"a/b", {longer}}}).find("allowed are letters"), std::string::npos);
  EXPECT_NE(refusal({{"base", {longer}}}).find("the name of the case without changes"), std::string::npos);
  EXPECT_NE(refusal({{"a", {longer}}, {"a", {longer}}}).find("found twice"), std::string::npos);
  const auto refused = [&](const std::vector<std::string>& overrides, const std::string& sentence) {
    const std::string found = refusal({{"two", overrides}});
    EXPECT_EQ(found.rfind("variant two (", 0), 0u) << found;
    EXPECT_NE(found.find("): " + sentence), std::string::npos) << found;
  };
  refused({longer, colder, longer}, "stage.rest.duration was found twice");
  refused({longer, colder, "stage.1.duration=0.2 s"},
          "stage.1.duration was found after stage.rest.duration, which it replaces");
  refused({colder, " tool . 0 . temperature =470 degC"}, "tool . 0 . temperature was found after tool.pot.temperature");
  refused({longer, "stage=[]"}, "stage was found after stage.rest.duration, which it replaces");
  const std::string of_pot = "interface.pot.h0=600 W/m2/K", of_plunger = "interface.plunger.h0=700 W/m2/K";
  refused({of_pot, of_plunger, "interface.1.h0=5 W/m2/K"}, "interface.1.h0 was found after interface.pot.h0");
  EXPECT_EQ(refusal({{"both", {of_pot, of_plunger, longer, "stage.press.duration=0.11 s"}}}), "");
  EXPECT_NE(refusal({{"a", {longer}}, {"a", {colder}}}).find("found twice"), std::string::npos);
  EXPECT_EQ(refusal({variant_of(longer)}), "");
  EXPECT_EQ(variant_of(longer).name, "stage.rest.duration_0.15_s");
  EXPECT_FALSE(fs::exists(in("out")));
}

TEST_F(WhatIfTest, a_variant_that_has_the_values_of_the_base_is_told) {
  const auto told = [&](const std::vector<std::string>& overrides) {
    return nothing_changed(asked({}), {"same", overrides});
  };
  EXPECT_EQ(told({"tool.pot.temperature=480 degC"}),
            "variant same changes nothing: the base has tool.pot.temperature=480 degC already");
  EXPECT_NE(told({"tool.pot.temperature=753.15 K", "stage.rest.duration=100 ms"}), "");
  EXPECT_EQ(told({"tool.pot.temperature=480 degC", longer}), "");
  EXPECT_EQ(told({"tool.pot.temperature=480 K"}), "");
}

TEST_F(WhatIfTest, tools_that_a_variant_makes_overlap_are_refused_and_those_that_overlap_in_the_base_are_not) {
  const std::string jar = std::string(PARISON_SOURCE_DIR) + "/cases/jar";
  const auto overlap = [](const std::string& path, const std::vector<std::string>& overrides) {
    return new_tool_overlap(read_scene(path, "draft"), read_scene(path, "draft", overrides));
  };
  const std::string found = overlap(jar, {"tool.ring.position=-10 mm"});
  EXPECT_NE(found.find("tools \"ring\" and \"plate\" overlap by 10 mm"), std::string::npos) << found;
  EXPECT_NE(overlap(jar, {R"(stage.hold.tools=["ring", "plate", "blow_mould", "blank"])"}).find("in stage hold"),
            std::string::npos);  // tools that overlap as drawn, but never work together in the base
  EXPECT_EQ(overlap(jar, {"tool.blank.temperature=440 degC"}), "");
  EXPECT_EQ(overlap(jar, {"tool.plunger.position=19 mm"}), "");                    // slides through the plate
  const std::string tumbler = std::string(PARISON_SOURCE_DIR) + "/cases/tumbler";  // its ring lies 3 mm in the mould
  EXPECT_EQ(overlap(tumbler, {"tool.ring.position=-1 mm"}), "");
  const std::string deeper = overlap(tumbler, {"tool.ring.position=-5 mm"});
  EXPECT_NE(deeper.find("in stage settle, where those of the base do by 3 mm"), std::string::npos) << deeper;
}

TEST_F(WhatIfTest, a_given_motion_that_drives_tools_through_each_other_is_refused_before_anything_runs) {
  const auto overlap = [](const std::string& path, const std::vector<std::string>& overrides) {
    const std::string whole = std::string(PARISON_SOURCE_DIR) + '/' + path;
    return new_tool_overlap(read_scene(whole, "draft"), read_scene(whole, "draft", overrides));
  };
  const std::string cup = "tests/bars/scenes/cup.toml", motion = "stage.press.motion.plunger.offset=";
  const std::string found = overlap(cup, {motion + R"([["0 s", "34 mm"], ["0.4 s", "-2 mm"], ["0.5 s", "6 mm"]])"});
  EXPECT_NE(found.find("tools \"plunger\" and \"mould\" overlap by 2 mm"), std::string::npos) << found;
  EXPECT_NE(found.find("in stage press, where the motion of \"plunger\" has it at -2 mm after 0.4 s"),
            std::string::npos)
      << found;
  EXPECT_EQ(overlap(cup, {motion + R"([["0 s", "34 mm"], ["0.4 s", "4 mm"]])"}), "");
  EXPECT_EQ(overlap(cup, {"stage.press.duration=0.7 s"}), "");

  // What slides a little into another tool in the base does not excuse what goes right through it.
  const auto moved = [&](const std::string& end) {
    return motion + "[[\"0 s\", \"34 mm\"], [\"0.4 s\", \"" + end + "\"]]";
  };
  const Scene slides = read_scene(std::string(PARISON_SOURCE_DIR) + '/' + cup, "draft", {moved("-1 mm")});
  const auto from_there = [&](const std::string& end) {
    return new_tool_overlap(slides, read_scene(slides.file, "draft", {moved(end)}));
  };
  EXPECT_EQ(from_there("-1.2 mm"), "");
  const std::string through = from_there("-4 mm");
  EXPECT_NE(through.find("overlap by 4 mm"), std::string::npos) << through;
  EXPECT_NE(through.find("those of the base do by 1 mm; allowed is a motion"), std::string::npos) << through;
}

TEST_F(WhatIfTest, results_of_another_case_are_refused_and_those_of_other_settings_are_not) {
  const auto copy = [&](const std::string& name, const std::string& text, const std::vector<std::string>& overrides) {
    fs::create_directories(in(name) + "/case");
    core::write_text(in(name) + "/case/case.toml", text);
    FinishedRun run;
    run.directory = in(name);
    run.accuracy = coarse;
    run.overrides = overrides;
    return run;
  };
  const auto refused = [&](const FinishedRun& other, const std::string& sentence) {
    try {
      settings_that_differ(copy("first", two_stages(), {}), other);
      ADD_FAILURE() << sentence;
    } catch (const core::CaseError& error) {
      EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
    }
  };
  const auto renamed = settings_that_differ(
      copy("first", two_stages(), {}), copy("named", replaced("case = \"pot\"", "case = \"mug\"", two_stages()), {}));
  ASSERT_EQ(renamed.size(), 1u);  // another name alone is told as what differs
  EXPECT_EQ(renamed[0].key + ": " + renamed[0].before + " -> " + renamed[0].now, "case: pot -> mug");
  refused(copy("stages", pot, {}), "stages press was found");
  FinishedRun bare;
  bare.directory = in("nowhere");
  refused(bare, "no copy of its case was found");

  const auto settings =
      settings_that_differ(copy("first", two_stages(), {}), copy("other", two_stages(), {colder, longer}));
  ASSERT_EQ(settings.size(), 2u);
  EXPECT_EQ(settings_line(settings),
            "stage.rest.duration: 0.1 s -> 0.15 s; tool.pot.temperature: 480 degC -> 470 degC");
  EXPECT_EQ(settings_line({}), "the same settings");
  const std::string as_before = "tool.pot.temperature=480 degC";
  EXPECT_TRUE(settings_that_differ(copy("first", two_stages(), {}), copy("other", two_stages(), {as_before})).empty());
  EXPECT_EQ(
      settings_line(settings_that_differ(copy("first", two_stages(), {}), copy("other", two_stages() + "\n", {}))),
      "a drawing or the text of the case");
}

}  // namespace
}  // namespace parison::forming
