// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "figure.hpp"
#include "forming/pot_scene.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/report/files/history.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene_text.hpp"
#include "forming/step/heat/heat_step.hpp"

namespace parison::forming {
namespace {

/// The gob pressed in the pot, whose outer faces are cooled, with a model of radiation and tools that answer light.
std::string lit_pot(const std::string& radiation, bool enclosure) {
  const std::string iron_lines = "conductivity = \"46 W/m/K\"\n", glass_lines = "conductivity = \"3 W/m/K\"\n";
  std::string text = replaced(iron_lines, iron_lines + "emissivity = 0.8\n", pot);
  text = replaced(glass_lines, "conductivity = \"1.3 W/m/K\"\nradiation = { " + radiation + " }\n", text);
  const std::string insulated = R"({ name = "outer", condition = "insulated")";
  for (int tool = 0; tool < 2; ++tool)
    text = replaced(insulated, R"({ name = "outer", condition.cooled = { h = "200 W/m2/K", temperature = "50 degC" })",
                    text);
  return (enclosure ? "enclosure = true\n" : "") + text;
}

struct Model {
  std::string name, radiation;
  bool enclosure;
};

const std::string bands =
    R"(bands = [{ up_to = "2.75 um", absorption = "35 1/m" }, { up_to = "4.3 um", absorption = "345 1/m" }])";
const std::vector<Model> models{
    {"Rosseland", R"(refractive_index = 1.518, absorption = "150 1/m", thin_wall = true)", false},
    {"P1", R"(model = "p1", refractive_index = 1.518, )" + bands, false},
    {"transfer", R"(model = "transfer", refractive_index = 1.518, )" + bands, false},
    {"transfer, absorption by temperature",
     R"(model = "transfer", refractive_index = 1.518, bands = [
       { up_to = "2.75 um", absorption = [["700 degC", "20 1/m"], ["1200 degC", "60 1/m"]] },
       { up_to = "4.3 um", absorption = "345 1/m" }])",
     false},
    {"transfer, enclosure", R"(model = "transfer", refractive_index = 1.518, )" + bands, true}};

TEST(PressedHeat, is_balanced_in_glass_and_tools_through_flow_contact_light_and_new_meshes) {
  Index meshes = 0;
  for (const Model& model : models) {
    const Scene scene = scene_of(lit_pot(model.radiation, model.enclosure) + "quality_floor = 0.6\n");
    const RunOutcome outcome = run_in_folder(scene, tests::absent_folder(), {});
    ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    const State& state = outcome.state;
    meshes += remeshes(state);
    tests::Figure open("pressed pot by " + model.name + ", heat of glass and tools over that lost: open by");
    open.add(glass_facts(scene, state).energy_imbalance);
    double received = 0;
    for (Index tool = 0; tool < 2; ++tool) {
      open.add(energy_imbalance(scene, state, tool));
      received += state.tools[tool].heat_received;
      EXPECT_GT(state.tools[tool].heat_received, 100);
      const std::vector<double>& given = state.tools[tool].heat_through;
      EXPECT_GT(std::accumulate(given.begin(), given.end(), 0.0), 0) << "no heat went into the cooling";
    }
    open.add(std::abs(received / state.totals.to_tools - 1));
    open.at_most(1e-9);
  }
  EXPECT_GT(meshes, static_cast<Index>(models.size())) << "no new mesh but those of the stage's start";
}

TEST(PressedHeat, flows_on_at_the_same_rates_after_a_new_mesh) {
  for (const Model& model : models) {
    const Scene scene =
        scene_of(replaced("duration = \"0.4 s\"", "duration = \"0.05 s\"", lit_pot(model.radiation, model.enclosure)));
    const RunOutcome outcome = run_in_folder(scene, tests::absent_folder(), {});
    ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    const RemeshedState remeshed = remesh_state(scene, outcome.state, RemeshReason::quality);
    ASSERT_TRUE(remeshed.ok) << remeshed.reason;
    const HeatRates before = heat_rates(scene, outcome.state), after = heat_rates(scene, remeshed.state);
    const double all = before.to_air + before.light_to_air + before.conducted.sum() + before.radiated.sum();
    EXPECT_GT(before.conducted.minCoeff(), 0.1 * all);
    tests::Figure changed("pressed pot by " + model.name + ", a new mesh changes the heat rate to a partner by, of all",
                          "%");
    changed.add(100 * std::abs(after.to_air - before.to_air) / all);
    changed.add(100 * std::abs(after.light_to_air - before.light_to_air) / all);
    changed.add(100 * ((after.conducted - before.conducted) / all).abs().maxCoeff());
    changed.add(100 * ((after.radiated - before.radiated) / all).abs().maxCoeff());
    changed.at_most(0.3);
    for (Eigen::Index tool = 0; tool < 2; ++tool)
      EXPECT_NEAR(after.conducted[tool] / before.conducted[tool], 1, 1e-2) << model.name;
  }
}

}  // namespace
}  // namespace parison::forming
