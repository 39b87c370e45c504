// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>

#include "../../pot_scene.hpp"
#include "../../scene_text.hpp"
#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/study/sweep/sweep_plan.hpp"
#include "forming/study/sweep/sweep_table.hpp"

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

const std::string head = "case = \"pot\"\naccuracy = \"draft coarser 2\"\n";
const std::string temperatures =
    "[[variable]]\nkey = \"tool.pot.temperature\"\nvalues = [\"470 degC\", \"480 degC\"]\n";
const std::string rests = "[[variable]]\nkey = \"stage.rest.duration\"\nfrom = \"0.1 s\"\nto = \"0.2 s\"\nnumber = 3\n";

class SweepTest : public ::testing::Test {
 protected:
  const std::string folder = tests::absent_folder();
  void SetUp() override {
    fs::create_directories(folder);
    core::write_text(in("case.toml"), two_stages());
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string in(const std::string& name) const { return folder + '/' + name; }
  Sweep sweep(const std::string& text) const {
    core::write_text(in("sweep.toml"), text);
    Sweep read = read_sweep(in("sweep.toml"));
    read.case_path = folder;
    return read;
  }
  SweepPlan plan(const std::string& text) const { return plan_sweep(sweep(text), in("out")); }
  /// What a sweep is refused with, after its file's name.
  std::string refusal(const std::string& text) const {
    try {
      plan(text);
      return "";
    } catch (const core::CaseError& error) {
      const std::string said = error.what(), file = in("sweep.toml") + ':';
      return said.rfind(file, 0) == 0 ? said.substr(file.size()) : said;
    }
  }
  void expect_refused(const std::string& text, const std::string& sentence) const {
    EXPECT_NE(refusal(text).find(sentence), std::string::npos) << refusal(text);
  }
};

bool never() {
  return false;
}

TEST_F(SweepTest, a_grid_has_a_row_for_each_combination_and_a_list_one_for_each_place) {
  const SweepPlan grid = plan(head + temperatures + rests);
  ASSERT_EQ(grid.runs.size(), 6u);
  EXPECT_EQ(grid.runs[4].name, "run_0005");
  EXPECT_EQ(grid.runs[4].overrides,
            (std::vector<std::string>{"tool.pot.temperature=480 degC", "stage.rest.duration=0.15 s"}));
  const auto list = sweep_values(sweep(head + "design = \"list\"\n" + temperatures + replaced("3", "2", rests)));
  EXPECT_EQ(list, (std::vector<std::vector<std::string>>{{"470 degC", "0.1 s"}, {"480 degC", "0.2 s"}}));
}

TEST_F(SweepTest, drawn_values_lie_between_the_bounds_and_are_the_same_again) {
  const std::string bounds = replaced("number = 3\n", "", rests);
  for (const char* design : {"latin_hypercube", "sobol"}) {
    const std::string text = head + "design = \"" + design + "\"\nruns = 20\nseed = 4\n" + temperatures + bounds;
    const auto rows = sweep_values(sweep(text));
    ASSERT_EQ(rows.size(), 20u);
    EXPECT_EQ(rows, sweep_values(sweep(text)));
    int hotter = 0;
    for (const auto& row : rows) {
      hotter += row[0] == "480 degC";
      const double duration = std::stod(row[1]);
      EXPECT_TRUE(duration >= 0.1 && duration < 0.2) << row[1];
    }
    EXPECT_NEAR(hotter, 10, 2) << design;
  }
}

TEST_F(SweepTest, a_run_takes_over_the_stages_that_its_values_cannot_have_influenced) {
  const SweepPlan planned = plan(head + temperatures + rests);
  for (const std::size_t first : {0u, 3u}) {
    EXPECT_FALSE(planned.runs[first].start) << first;
    for (const std::size_t row : {first + 1, first + 2}) {
      ASSERT_TRUE(planned.runs[row].start) << row;
      EXPECT_EQ(planned.runs[row].start->run, first);
      EXPECT_EQ(planned.runs[row].start->stage, "press");
    }
  }
  for (const SweepRun& run : plan(head + temperatures).runs) EXPECT_FALSE(run.start);
}

TEST_F(SweepTest, a_shared_start_gives_what_a_run_of_its_own_gives_to_the_last_bit) {
  const SweepPlan planned = plan(head + rests);
  for (const SweepRun& run : planned.runs) make_run(planned, run, never);
  SweepPlan alone = planned;
  alone.output = in("alone");
  alone.runs[2].start.reset();
  make_run(alone, alone.runs[2], never);
  const std::string shared = planned.folder(planned.runs[2]), whole = alone.folder(alone.runs[2]);
  EXPECT_EQ(core::read_text(shared + "/history.csv"), core::read_text(whole + "/history.csv"));
  EXPECT_NE(core::read_text(shared + "/history.csv"),
            core::read_text(planned.folder(planned.runs[1]) + "/history.csv"));

  // The table has each run with its values and results, and a run that was not made without.
  std::vector<SweepState> states;
  for (const SweepRun& run : planned.runs) states.push_back(state_of(planned, run));
  EXPECT_EQ(states[2].status, SweepState::Status::done);
  fs::remove_all(planned.folder(planned.runs[1]));
  states[1] = state_of(planned, planned.runs[1]);
  EXPECT_EQ(states[1].status, SweepState::Status::waiting);
  write_results(planned, read_results(planned, states));
  const std::string table = core::read_text(in("out/results.csv"));
  EXPECT_EQ(table.find("run,stage.rest.duration_s,status,"), 0u) << table;
  EXPECT_NE(table.find("heat_pot_J"), std::string::npos) << table;
  EXPECT_NE(table.find("\nrun_0003,0.2,done,"), std::string::npos) << table;
  EXPECT_NE(table.find("\nrun_0002,0.15,not run,nan,"), std::string::npos) << table;
  const auto file = core::open_hdf5(in("out/results.h5"));
  EXPECT_EQ(file.open("variables").open("stage.rest.duration").read_doubles("value"),
            (std::vector<double>{0.1, 0.15, 0.2}));
  const auto heat = file.open("quantities").open("heat_pot").read_doubles("value");
  EXPECT_TRUE(std::isnan(heat[1]));
  EXPECT_GT(heat[2], heat[0]);

  // What is kept of a run on request still says that it is done, and gives the same table.
  for (const std::size_t row : {0u, 2u}) keep_only(Keep::summary, planned.folder(planned.runs[row]));
  EXPECT_FALSE(fs::exists(shared + "/checkpoint.h5"));
  EXPECT_EQ(state_of(planned, planned.runs[2]).status, SweepState::Status::done);
  write_results(planned, read_results(planned, states));
  EXPECT_EQ(core::read_text(in("out/results.csv")), table);
}

TEST_F(SweepTest, rows_may_be_added_to_a_sweep_and_none_may_become_another) {
  const std::string more = replaced("\"480 degC\"", "\"480 degC\", \"490 degC\"", temperatures);
  fs::create_directories(in("out"));
  write_manifest(plan(head + temperatures));
  write_manifest(plan(head + more));
  const auto refused = [&](const std::string& text, const std::string& sentence) {
    try {
      write_manifest(plan(text));
      ADD_FAILURE() << sentence;
    } catch (const core::CaseError& error) {
      EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
    }
  };
  refused(head + temperatures, "a sweep of 3 runs was found there");
  refused(head + replaced("470", "471", more), "other values in row 1");
  refused(replaced("coarser 2", "coarser 1.5", head) + more, "a sweep at draft coarser 2 accuracy");
}

TEST_F(SweepTest, a_row_that_is_refused_is_named_with_its_values) {
  expect_refused(head + replaced("pot", "pan", temperatures),
                 " row 1 (tool.pan.temperature=470 degC): tool.pan.temperature: no entry \"pan\" was found");
  expect_refused(head + "[[variable]]\nkey = \"tool.plunger.position\"\nvalues = [\"0 mm\", \"-2 mm\"]\n",
                 " row 2 (tool.plunger.position=-2 mm): ");
}

TEST_F(SweepTest, every_mistake_in_a_sweep_file_has_its_sentence) {
  expect_refused(head, "no variable was found");
  expect_refused(replaced("accuracy", "acuracy", head) + temperatures, "unknown key (did you mean \"accuracy\"?)");
  expect_refused(head + "design = \"gird\"\n" + temperatures, "did you mean \"grid\"?");
  expect_refused(head + temperatures + temperatures, "the key tool.pot.temperature was found twice");
  expect_refused(head + replaced("to = \"0.2 s\"", "to = \"0.05 s\"", rests), "allowed is more than from, 0.1 s");
  expect_refused(head + replaced("to = \"0.2 s\"", "to = \"200 ms\"", rests), "allowed is that of from, \"s\"");
  expect_refused(head + replaced("number = 3", "number = 1", rests), "allowed are 2 or more");
  expect_refused(head + replaced("number = 3\n", "", rests), "number");
  expect_refused(head + replaced("from = \"0.1 s\"", "from = \"short\"", rests), "allowed is a number with its unit");
  expect_refused(head + "design = \"sobol\"\nruns = 4\n" + rests, "number only of levels");
  expect_refused(head + "design = \"sobol\"\n" + temperatures, "runs");
  expect_refused(head + "runs = 3\n" + temperatures, "allowed only with the designs latin_hypercube and sobol");
  expect_refused(head + "design = \"sobol\"\nruns = 4\nseed = -1\n" + temperatures, "allowed is a whole number from 0");
  expect_refused(head + "design = \"list\"\n" + temperatures + rests,
                 "as many as of tool.pot.temperature in a list, 2");
  expect_refused(head + "[[variable]]\nkey = \"air.h\"\n", "allowed are values, or from and to");
  expect_refused(head + "[[variable]]\nkey = \"air.h\"\nvalues = []\n", "an empty list was found");
  expect_refused(head + "[[variable]]\nkey = \"air.h\"\nvalues = [[1, 2]]\n", "allowed are texts, numbers");
  expect_refused(head + "keep = \"some\"\n" + temperatures, "allowed are all, summary");
  expect_refused(replaced("draft coarser 2", "0.5%", head) + temperatures, "allowed are draft, standard, fine");
  std::string many = head;
  for (const char* key : {"a", "b", "c", "d"})
    many += std::string("[[variable]]\nkey = \"") + key + "\"\nfrom = 0\nto = 1\nnumber = 100\n";
  expect_refused(many, "allowed are up to 100000");
}

}  // namespace
}  // namespace parison::forming
