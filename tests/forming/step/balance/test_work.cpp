// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "../../pot_scene.hpp"
#include "../../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/balance/work.hpp"

namespace parison::forming {
namespace {

/// The pot's gob, with surface tension and friction on the wall; after the press air lifts it from below the plunger.
Scene pot_and_air() {
  std::string text = replaced("emissivity = 0.89", "emissivity = 0.89\nsurface_tension = \"0.3 N/m\"", pot);
  text = replaced("[material.glass]",
                  "[[stage]]\nname = \"rest\"\nduration = \"0.1 s\"\ngravity = \"-9.81 m/s2\"\ntools = [\"pot\"]\n"
                  "pressure.surface = \"2 bar\"\n[material.glass]",
                  text);
  return scene_of(text);
}

TEST(Work, done_on_the_glass_is_lost_or_in_its_surface_at_the_end_of_every_stage) {
  const std::string results = tests::absent_folder();
  const auto outcome = run_in_folder(pot_and_air(), results);
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  ASSERT_EQ(outcome.facts.stages.size(), 2u);
  for (const StageRecord& stage : outcome.facts.stages) {
    const Work& work = stage.work;
    std::printf(
        "%s: tools %.4g J, gravity %.2g, air %.2g, dissipated %.4g, friction %.2g, impact %.4g, surface %.2g, "
        "corrections %.2g; off by %.1e\n",
        stage.name.c_str(), work.tools, work.gravity, work.air, work.dissipation, work.friction, work.impact_loss,
        work.surface, work.correction, work_imbalance(work));
    const double flow = work.dissipation + work.friction, lost = flow + work.impact_loss;
    // What the last step of the press loses by impact, 0.02 to 0.24 J, follows its length by chance and counts for
    // nothing.
    EXPECT_LT(std::abs(work_imbalance(work)) * lost, 0.12 * flow);
    EXPECT_LT(std::abs(work_imbalance(work) - work.correction / lost),
              1e-3);  // 3 kN on a full pot: correcting its volume costs work
  }
  const Work& all = outcome.state.totals.work;
  for (const double part :
       {all.tools, all.gravity, all.air, all.dissipation, all.friction, all.impact_loss, all.surface})
    EXPECT_NE(part, 0);
}

TEST(Work, an_error_counts_more_in_a_step_that_loses_little_down_to_a_tenth_of_the_whole) {
  const Scene scene = pot_and_air();
  const State start = initial_state(scene);
  Work before;
  before.tools = before.dissipation = 100;
  const auto error = [&](double loss) {
    Work after = before;
    after.tools += 1.01 * loss;
    after.dissipation += loss;
    return work_error(scene, start, before, after, 0) / (0.01 * loss);
  };
  EXPECT_NEAR(error(1), 1 / 101.01, 1e-12) << "the whole, where the step is a large part of it";
  EXPECT_NEAR(error(0.1), 1 / 40.0, 1e-9) << "400 times the own loss";
  EXPECT_NEAR(error(1e-3), 10 / 100.001, 1e-5) << "a tenth of the whole";
}

TEST(Work, what_an_impact_creates_is_an_error_of_the_step) {
  const Scene scene = pot_and_air();
  const State start = initial_state(scene);
  Work before;
  before.tools = before.dissipation = 100;
  Work after = before;
  after.dissipation += 1, after.impact_loss -= 1;  // in balance, by glass that lands in tension
  EXPECT_NEAR(work_error(scene, start, before, after, 0), 1 / 10.0, 1e-12) << "over a tenth of the whole";
  after.dissipation -= 2, after.impact_loss += 2;
  EXPECT_EQ(work_error(scene, start, before, after, 0), 0) << "what an impact loses is none";
}

TEST(SolverStatistics, of_the_steps_is_summed_and_every_step_has_its_limit) {
  const std::string results = tests::absent_folder();
  const auto outcome = run_in_folder(pot_and_air(), results);
  const SolverStatistics& statistics = outcome.facts.diagnostics.steps;
  const auto& by = statistics.limited_by;
  EXPECT_EQ(std::accumulate(by.begin(), by.end(), 0), outcome.state.totals.steps);
  EXPECT_EQ(by[static_cast<std::size_t>(StepLimit::initial)], 2);
  EXPECT_GE(statistics.flow_solves, statistics.flow_factorisations);
  EXPECT_GE(statistics.coupling_iterations, outcome.state.totals.steps + outcome.facts.diagnostics.steps.rejected);
  EXPECT_GT(statistics.contact_changes, 0);
  EXPECT_GE(statistics.contacts, outcome.state.totals.steps);
  EXPECT_LE(statistics.locked_contacts, statistics.contacts);
  std::istringstream rows(core::read_text(results + "/history.csv"));
  std::string row;
  std::getline(rows, row);
  long solves = 0;
  int landings = 0;
  while (std::getline(rows, row)) {
    std::vector<std::string> fields;
    std::istringstream in(row);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    solves += std::stol(fields[fields.size() - 4]);
    landings += fields.back() == "event";
  }
  EXPECT_EQ(landings, by[static_cast<std::size_t>(StepLimit::event)]);
  EXPECT_LE(solves, statistics.flow_solves);  // rejected steps write no row
  EXPECT_GT(solves, outcome.state.totals.steps);
}

}  // namespace
}  // namespace parison::forming
