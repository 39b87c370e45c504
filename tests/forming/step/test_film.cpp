// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "../scene_text.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/step/contact/film.hpp"

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
boundary = [
  { name = "surface", condition = "contact", path = "(0, 0) (4, 0) (4, 0.8) (0, 0.8) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[[tool]]
name = "plate"
friction = "stick"
boundary = [
  { name = "top", path = "(20, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -5) mm", condition = "symmetry" },
  { name = "rest", path = "(20, -5) (20, 0) mm", condition = "insulated" } ]
[[tool]]
name = "plunger"
friction = "stick"
position = "0.8 mm"
boundary = [
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
  return run_in_folder(scene, results.string(), {});
}

/// Cells that a line along the axis at this radius goes through.
int cells_across(const core::Mesh& mesh, double radius) {
  return static_cast<int>(std::count_if(mesh.cells().begin(), mesh.cells().end(), [&](const auto& cell) {
    double low = 1, high = 0;
    for (int k = 0; k < 3; ++k) {
      low = std::min(low, mesh.nodes[cell[k]][0]);
      high = std::max(high, mesh.nodes[cell[k]][0]);
    }
    return low < radius && high > radius;
  }));
}

/// The numbers of history.csv by their columns, a map for each step.
std::vector<std::map<std::string, double>> steps_of(const Scene& scene) {
  std::ifstream file(fs::path(scene.directory) / "results" / "history.csv");
  std::vector<std::string> names;
  std::vector<std::map<std::string, double>> steps;
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    std::vector<std::string> fields;
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    if (names.empty()) {
      names = fields;
      continue;
    }
    steps.emplace_back();
    for (std::size_t i = 0; i < fields.size(); ++i) steps.back()[names[i]] = std::strtod(fields[i].c_str(), nullptr);
  }
  return steps;
}

/// Mean over the time in which the disc is thinner than `below`, m, of its force against that of a thin film that
/// sticks to both tools, and of its height over its radius. Nodes that land at the rim one by one make the force of
/// single steps uneven.
std::pair<double, double> thin_film_ratio(const Scene& scene, double below) {
  const double volume = M_PI * std::pow(4e-3, 2) * 0.8e-3, speed = 1e-3;
  double time = 0, ratio = 0, slenderness = 0;
  for (const auto& row : steps_of(scene)) {
    const double dt = row.at("dt_s"), height = 1e-3 * row.at("plunger_position_mm");
    if (height > below) continue;
    const double radius = std::sqrt(volume / (M_PI * height));
    const double theory = 1.5 * M_PI * 1e3 * std::pow(radius, 4) * speed / std::pow(height, 3);
    time += dt;
    ratio -= dt * row.at("plunger_force_N") / theory;
    slenderness += dt * height / radius;
  }
  return {ratio / time, slenderness / time};
}

TEST(Film, a_disc_squeezed_to_300_micrometres_pushes_back_as_theory_says_and_ends_the_run_there) {
  Scene scene;
  const RunOutcome outcome = pressed(squeeze, scene);
  const State& state = outcome.state;
  EXPECT_FALSE(outcome.facts.completed);
  EXPECT_NE(outcome.facts.reason.find("the glass between "), std::string::npos) << outcome.facts.reason;
  EXPECT_NE(outcome.facts.reason.find(" mm thick near ("), std::string::npos) << outcome.facts.reason;
  EXPECT_NE(outcome.facts.reason.find("allowed are films of at least 0.3 mm, film.min_thickness of the glass; where "
                                      "so thin a film is meant, film.then = \"freeze\" lets it flow no more"),
            std::string::npos)
      << outcome.facts.reason;
  const double height = state.tools[1].offset;
  const double radius = std::sqrt(core::volume(state.glass.mesh, scene.geometry) / (M_PI * height));
  EXPECT_GT(state.time, 0.5);
  EXPECT_LT(height, 0.3e-3);
  EXPECT_GT(height, 0.28e-3);
  for (double at = 0.05; at < 0.95; at += 0.043) EXPECT_GE(cells_across(state.glass.mesh, at * radius), 7) << at;
  EXPECT_GE(state.totals.remeshing.min_quality, 0.3);
  const auto [ratio, slenderness] = thin_film_ratio(scene, 0.4e-3);
  std::printf(
      "film from 0.4 to %.4f mm: force %.4f times that of thin film theory, height over radius %.4f, %d cells\n",
      1e3 * height, ratio, slenderness, state.glass.mesh.cell_count());
  // The theory knows no rim, which is about as wide as the film is high.
  EXPECT_LT(ratio, 1 - 0.5 * slenderness);
  EXPECT_GT(ratio, 1 - 1.5 * slenderness);
}

TEST(Film, a_frozen_film_stops_the_tool_that_presses_on_it_and_is_not_crushed_by_one_that_does_not_give_way) {
  const std::string frozen = with_film(R"({ min_thickness = "0.5 mm", then = "freeze" })");
  Scene scene;
  const RunOutcome given = pressed(frozen, scene);
  EXPECT_NE(given.facts.reason.find("frozen below 0.5 mm"), std::string::npos) << given.facts.reason;
  const RunOutcome driven =
      pressed(replaced("offset = [[\"0 s\", \"0.8 mm\"], [\"0.5 s\", \"0.3 mm\"], [\"0.6 s\", \"0.2 mm\"]]",
                       "force = \"-100 N\", speed_limit = \"10 mm/s\"", frozen),
              scene);
  EXPECT_TRUE(driven.facts.completed) << driven.facts.reason;
  const ToolState& plunger = driven.state.tools[1];
  EXPECT_LT(plunger.offset, 0.5e-3);
  EXPECT_GT(plunger.offset, 0.42e-3);
  EXPECT_LT(std::abs(plunger.velocity), 1e-6);
  EXPECT_NEAR(plunger.force, -100, 0.1);
  EXPECT_EQ(film_failure(scene, driven.state), "");
}

TEST(Film, an_unknown_end_of_a_film_is_refused) {
  const std::string said = complaint_about(with_film(R"({ then = "melt" })"));
  EXPECT_NE(said.find("film.then"), std::string::npos) << said;
  EXPECT_NE(said.find("stop"), std::string::npos) << said;
}

}  // namespace
}  // namespace parison::forming
