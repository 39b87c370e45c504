// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "forming/step/film.hpp"
#include "forming/run/run.hpp"
#include "scene_text.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

/// A disc of viscous glass, 4 mm radius and 0.8 mm high, squeezed between two plates to which it sticks.
const std::string squeeze = R"(case = "squeeze"
geometry = "axisymmetric"
output.interval = "1 s"
[[stage]]
name = "press"
duration = "0.6 s"
tools = ["plate", "plunger"]
motion.plunger = { offset = [["0 s", "0.8 mm"], ["0.5 s", "0.3 mm"], ["0.6 s", "0.2 mm"]] }
[material.glass]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
[glass]
material = "glass"
piece = [
  { name = "surface", condition = "contact", path = "(0, 0) (4, 0) (4, 0.8) (0, 0.8) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[[tool]]
name = "plate"
friction = "stick"
piece = [
  { name = "top", path = "(20, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -5) mm", condition = "symmetry" },
  { name = "rest", path = "(20, -5) (20, 0) mm", condition = "insulated" } ]
[[tool]]
name = "plunger"
friction = "stick"
position = "0.8 mm"
piece = [
  { name = "face", path = "(0, 0) (20, 0) mm", condition = "contact" },
  { name = "rest", path = "(20, 5) (0, 5) mm", condition = "insulated" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" } ]
)";

std::string with_film(const std::string& film) {
  return replaced("material = \"glass\"\n", "material = \"glass\"\nfilm = " + film + "\n", squeeze);
}

RunOutcome pressed(const std::string& text, Scene& scene) {
  scene = scene_of(text);
  const fs::path results = fs::path(scene.directory) / "results";
  fs::remove_all(results);
  return run(scene, results.string(), {});
}

/// Cells that a line along the axis at this radius goes through.
int cells_across(const core::Mesh& mesh, double radius) {
  return static_cast<int>(std::count_if(mesh.cells.begin(), mesh.cells.end(), [&](const auto& cell) {
    double low = 1, high = 0;
    for (int k = 0; k < 3; ++k) {
      low = std::min(low, mesh.nodes[cell[k]][0]);
      high = std::max(high, mesh.nodes[cell[k]][0]);
    }
    return low < radius && high > radius;
  }));
}

TEST(Film, a_disc_squeezed_to_300_micrometres_pushes_back_as_theory_says_and_ends_the_run_there) {
  Scene scene;
  const RunOutcome outcome = pressed(squeeze, scene);
  const State& state = outcome.state;
  EXPECT_FALSE(outcome.facts.completed);
  EXPECT_NE(outcome.facts.reason.find("the glass between "), std::string::npos) << outcome.facts.reason;
  EXPECT_NE(outcome.facts.reason.find(" mm thick near ("), std::string::npos) << outcome.facts.reason;
  EXPECT_NE(outcome.facts.reason.find("allowed are films of 0.3 mm and more"), std::string::npos) << outcome.facts.reason;
  const double height = state.bodies[2].offset, speed = -state.bodies[2].velocity;
  const double middle = height + 0.5 * speed * state.last_step;  // the force of a step is that of its middle
  const double radius = std::sqrt(core::volume(state.bodies[0].mesh, scene.geometry) / (M_PI * middle));
  EXPECT_GT(state.time, 0.5);
  EXPECT_LT(height, 0.3e-3);
  EXPECT_GT(height, 0.28e-3);
  for (double at = 0.05; at < 0.95; at += 0.043) EXPECT_GE(cells_across(state.bodies[0].mesh, at * radius), 7) << at;
  EXPECT_GE(state.totals.remeshing.worst_quality, 0.3);
  const double theory = 1.5 * M_PI * 1e3 * std::pow(radius, 4) * speed / std::pow(middle, 3);
  std::printf("film of %.4f mm, radius %.3f mm: force %.1f N, thin film theory %.1f N, %d cells\n", 1e3 * height, 1e3 * radius,
              -state.bodies[2].force, theory, state.bodies[0].mesh.cell_count());
  EXPECT_NEAR(-state.bodies[2].force / theory, 1, 0.05);
}

TEST(Film, a_frozen_film_stops_the_tool_that_presses_on_it_and_is_not_crushed_by_one_that_does_not_give_way) {
  const std::string frozen = with_film(R"({ thinnest = "0.5 mm", then = "freeze" })");
  Scene scene;
  const RunOutcome given = pressed(frozen, scene);
  EXPECT_NE(given.facts.reason.find("frozen below 0.5 mm"), std::string::npos) << given.facts.reason;
  const RunOutcome driven =
      pressed(replaced("offset = [[\"0 s\", \"0.8 mm\"], [\"0.5 s\", \"0.3 mm\"], [\"0.6 s\", \"0.2 mm\"]]",
                       "force = \"-100 N\", speed_limit = \"10 mm/s\"", frozen),
              scene);
  EXPECT_TRUE(driven.facts.completed) << driven.facts.reason;
  const BodyState& plunger = driven.state.bodies[2];
  EXPECT_LT(plunger.offset, 0.5e-3);
  EXPECT_GT(plunger.offset, 0.42e-3);
  EXPECT_LT(std::abs(plunger.velocity), 1e-6);
  EXPECT_NEAR(plunger.force, -100, 0.1);
  EXPECT_EQ(film_obstacle(scene, driven.state), "");
}

TEST(Film, an_unknown_end_of_a_film_is_refused) {
  const std::string said = complaint_about(with_film(R"({ then = "melt" })"));
  EXPECT_NE(said.find("film.then"), std::string::npos) << said;
  EXPECT_NE(said.find("stop"), std::string::npos) << said;
}

}  // namespace
}  // namespace parison::forming
