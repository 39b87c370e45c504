// SPDX-License-Identifier: GPL-3.0-or-later
// Temperatures at the start that differ from place to place: formulas, tables, the end of another result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "../scene_text.hpp"
#include "forming/diagnostics/extremes.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/run/run.hpp"
#include "forming/scene/describe/unusual.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/sample.hpp"
#include "thermal/problem.hpp"

namespace parison::forming {
namespace {

/// The small scene whose glass or plate begins with a field.
std::string with_glass(const std::string& value) {
  return replaced("temperature = \"1000 degC\"", "temperature = " + value);
}
std::string with_plate(const std::string& value, const std::string& text = small_scene) {
  return replaced("material = \"iron\"\ntemperature = \"400 degC\"", "material = \"iron\"\ntemperature = " + value,
                  text);
}

double heat_of(const Scene& scene, Index body, const core::Mesh& mesh, const Eigen::VectorXd& temperature) {
  const Body& data = body_of(scene, body);
  const thermal::BodyView view{&mesh, &mesh, data.thermal->density, &*data.thermal, {}, {}};
  return thermal::heat_content(view, scene.geometry, temperature);
}

TEST(StartTemperature, a_formula_of_r_and_z_gives_each_node_its_value_and_the_glass_its_exact_heat) {
  const Scene scene = scene_of(with_glass("{ formula = \"1000 degC - 200 K*(r/20 mm)*(r/20 mm) + 30 K*z/(10 mm)\" }"));
  const State state = initial_state(scene);
  for (Index n = 0; n < state.glass.mesh.node_count(); ++n) {
    const Point& x = state.glass.mesh.nodes[n];
    EXPECT_NEAR(state.glass.temperature[n], 1273.15 - 200 * std::pow(x[0] / 0.02, 2) + 30 * x[1] / 0.01, 1e-9);
  }
  const double volume = M_PI * 4e-6, mean = 1000 - 100 + 15;
  EXPECT_NEAR(state.glass.initial_heat / (2400 * 1300 * volume * mean), 1, 1e-9);
  EXPECT_NEAR(scene.glass.initial_temperature, mean + 273.15, 3);
  EXPECT_NEAR(temperature_range(scene).max_temperature, 1303.15, 0.1);
}

TEST(StartTemperature, a_formula_may_use_the_dimensions_of_the_case) {
  const auto text = replaced("geometry =", "dimension = { R = \"20 mm\", T_skin = \"900 degC\" }\ngeometry =",
                             with_glass("{ formula = \"max(T_skin, T_skin + 100 K*(1 - r/R))\" }"));
  const Scene scene = scene_of(text);
  EXPECT_NEAR(scene.glass.start_field->max, 1273.15, 1e-9);
  EXPECT_NEAR(scene.glass.start_field->min, 1173.15, 1e-9);
}

TEST(StartTemperature, a_field_is_warmer_by_its_plus_everywhere) {
  const std::string formula = "formula = \"1000 degC - 200 K*(r/20 mm)*(r/20 mm)\"";
  const State plain = initial_state(scene_of(with_glass("{ " + formula + " }")));
  const State warmer = initial_state(scene_of(with_glass("{ " + formula + ", plus = \"12 K\" }")));
  EXPECT_LT((warmer.glass.temperature.array() - plain.glass.temperature.array() - 12).abs().maxCoeff(), 1e-9);
  EXPECT_THROW(scene_of(with_glass("{ " + formula + ", plus = \"-1200 K\" }")), core::CaseError);
}

/// A case with a table beside it.
Scene scene_with_table(const std::string& text, const std::string& table,
                       const std::vector<std::string>& overrides = {}) {
  const std::string folder = write_scene(text);
  std::ofstream(folder + "/T.csv") << table;
  return read_scene(folder, "draft", overrides);
}

TEST(StartTemperature, a_table_is_linear_between_its_points_and_constant_beyond) {
  const std::string grid = "z_mm,T_degC,r_mm\n-10,300,0\n-10,320,30\n0,400,0\n\n0,440,30\n";
  const Scene scene = scene_with_table(with_plate("{ csv = \"T.csv\" }"), grid);
  const State state = initial_state(scene);
  const ToolState& plate = state.tools[0];
  for (Index n = 0; n < plate.mesh.node_count(); ++n) {
    const Point x = plate.mesh.nodes[n] / 1e-3;
    const double s = x[0] / 30, t = 1 + x[1] / 10;
    EXPECT_NEAR(plate.temperature[n] - 273.15, (1 - t) * (300 + 20 * s) + t * (400 + 40 * s), 1e-9);
  }
  EXPECT_NEAR(first_extremes(scene, state).tools[0].temperature, 713.15, 1e-9);
  const Scene along = scene_with_table(with_plate("{ csv = \"T.csv\" }"), "z_mm,T_degC\n-5,300\n-2,330\n");
  const auto& T = along.tools[0].start_field->at;
  EXPECT_NEAR(T({0, -9e-3}), 573.15, 1e-9);
  EXPECT_NEAR(T({0.02, -3e-3}), 593.15, 1e-9);
  EXPECT_NEAR(T({0, 0}), 603.15, 1e-9);
  const Scene warmer = scene_with_table(with_plate("{ csv = \"T.csv\" }"), "z_mm,T_degC\n-5,300\n-2,330\n",
                                        {"tool.plate.temperature.plus=5 K"});
  EXPECT_NEAR(warmer.tools[0].start_field->at({0, 0}), 608.15, 1e-9);
}

TEST(StartTemperature, a_table_of_another_place_is_refused_and_one_of_a_part_is_told) {
  const auto said_of = [](const std::string& table) {
    const std::string folder = write_scene(with_plate("{ csv = \"T.csv\" }"));
    std::ofstream(folder + "/T.csv") << table;
    try {
      return describe_unusual(read_scene(folder, "draft"));
    } catch (const core::CaseError& error) {
      return std::string(error.what());
    }
  };
  const std::string metres = said_of("r_mm,z_mm,T_degC\n0,-0.01,300\n0,0,400\n0.03,-0.01,300\n0.03,0,400\n");
  EXPECT_NE(metres.find("a table with r from 0 to 0.03 mm z from -0.01 to 0 mm was found and the body lies from (0, "
                        "-10) to (30, 0) mm, allowed is a table that covers the body or a part of it"),
            std::string::npos)
      << metres;
  EXPECT_NE(said_of("z_mm,T_degC\n2,300\n9,400\n").find("allowed is a table that covers"), std::string::npos);
  const std::string half = said_of("z_mm,T_degC\n-5,300\n0,330\n");
  EXPECT_NE(half.find("50 % of \"plate\" lies beyond the temperatures of T.csv, where the nearest of them count"),
            std::string::npos)
      << half;
  EXPECT_EQ(said_of("z_mm,T_degC\n-10,300\n0,330\n").find("lies beyond"), std::string::npos);
}

/// Integral of a function of the place over the disc of the small scene, by its own fine grid.
double over_disc(const std::function<double(double, double)>& value) {
  constexpr int across = 2000, up = 1000;
  double sum = 0;
  for (int i = 0; i < across; ++i)
    for (int k = 0; k < up; ++k) {
      const double r = (i + 0.5) * 0.02 / across, z = (k + 0.5) * 0.01 / up;
      sum += 2 * M_PI * r * value(r, z) * (0.02 / across) * (0.01 / up);
    }
  return sum;
}

TEST(StartTemperature, a_skin_thinner_than_the_cells_and_a_step_have_their_heat) {
  const std::string still = replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }\n", "");
  const std::string rest =
      still.substr(0, still.find("[[stage]]\nname = \"press\"")) + still.substr(still.find("[[probe]]"));
  for (const std::string& text : {small_scene, rest}) {
    const std::string skin = replaced(
        "boundary = [\n  { name = \"surface\"",
        "skin = { temperature = \"700 degC\", depth = \"0.1 mm\" }\nboundary = [\n  { name = \"surface\"", text);
    const double given = 2400 * 1300 * over_disc([](double r, double z) {
                           return 300 * std::exp(-std::min({0.02 - r, z, 0.01 - z}) / 1e-4);
                         });
    const double core = 2400 * 1300 * M_PI * 4e-6 * 1000,
                 found = core - initial_state(scene_of(skin)).glass.initial_heat;
    EXPECT_NEAR(found / given, 1, 0.03) << "of the skin";
  }
  const std::string step = "r_mm,T_degC\n0,1000\n9.99,1000\n10,200\n20,200\n";
  const Scene scene =
      scene_with_table(replaced("temperature = \"1000 degC\"", "temperature = { csv = \"T.csv\" }", rest), step);
  const double given = 2400 * 1300 * M_PI * 0.01 * (1e-4 * 1000 + 3e-4 * 200);
  EXPECT_NEAR(initial_state(scene).glass.initial_heat / given, 1, 2e-3);
}

/// The first stage of the small scene, in which nothing moves, run into a folder.
struct FirstResult {
  std::string folder = (tests::folder_of_test("result") / "first").string();
  Scene scene;
  State end;

  FirstResult() {
    const auto text = small_scene.substr(0, small_scene.find("[[stage]]\nname = \"press\"")) +
                      small_scene.substr(small_scene.find("[[probe]]"));
    scene = scene_of(text);
    const RunOutcome outcome = run_in_folder(scene, folder, {}, [] { return false; });
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    end = outcome.state;
  }
};

TEST(StartTemperature, the_end_of_another_result_is_handed_over_with_its_heat_to_other_meshes) {
  const FirstResult first;
  const std::string from = "{ from = \"" + first.folder + "\" }";
  const Scene scene = read_scene(write_scene(with_plate(from, with_glass(from))), "standard");
  const State state = initial_state(scene);
  ASSERT_NE(state.glass.mesh.node_count(), first.end.glass.mesh.node_count());
  for (const Index body : {0, 1}) {
    const core::Mesh &old_mesh = mesh_of(first.end, body), &mesh = mesh_of(state, body);
    const Eigen::VectorXd &old_T = temperature_of(first.end, body), &T = temperature_of(state, body);
    const double before = heat_of(first.scene, body, old_mesh, old_T), after = heat_of(scene, body, mesh, T);
    std::printf("%s: heat before %.10g J, after %.10g J\n", body_of(scene, body).name.c_str(), before, after);
    EXPECT_NEAR(after / before, 1, 1e-9);
    EXPECT_GT(old_T.maxCoeff() - old_T.minCoeff(), 20) << "a field";
    EXPECT_GE(T.minCoeff(), old_T.minCoeff() - 1e-9);
    EXPECT_LE(T.maxCoeff(), old_T.maxCoeff() + 1e-9);
    std::vector<Point> places;
    for (const auto& cell : old_mesh.cells())
      places.push_back((old_mesh.nodes[cell[0]] + old_mesh.nodes[cell[1]] + old_mesh.nodes[cell[2]]) / 3);
    const double off =
        (sample(old_mesh, old_T, 1, places) - sample(mesh, T, 1, places)).norm() / std::sqrt(double(places.size()));
    EXPECT_LT(off, 0.02 * (old_T.maxCoeff() - old_T.minCoeff())) << "mean over the places";
  }
  EXPECT_NEAR(state.tools[1].temperature.maxCoeff(), 673.15, 1e-9) << "the plunger begins as given";
}

TEST(StartTemperature, a_run_from_a_field_keeps_its_heat_balance) {
  const FirstResult first;
  const std::string from = "{ from = \"" + first.folder + "\" }";
  const RunOutcome outcome =
      run(scene_of(with_plate("{ from = \"" + first.folder + "\", body = \"plate\" }", with_glass(from))), {});
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  const auto& checks = outcome.facts.checks;
  const auto balance =
      std::find_if(checks.begin(), checks.end(), [](const auto& c) { return c.name == "energy_imbalance"; });
  ASSERT_NE(balance, checks.end());
  EXPECT_LT(balance->value, 1e-3);
}

std::string said(const std::string& text) {
  const std::string complaint = complaint_about(text);
  return complaint.substr(complaint.find(' ') + 1);
}

std::string said_of_table(const std::string& table) {
  const std::string folder = write_scene(with_plate("{ csv = \"T.csv\" }"));
  std::ofstream(folder + "/T.csv") << table;
  try {
    read_scene(folder, "draft");
  } catch (const core::CaseError& error) {
    const std::string message = error.what();
    return message.substr(message.find(": ") + 2);
  }
  return "";
}

TEST(StartTemperature, mistakes_have_their_sentences) {
  const std::string key = "glass.temperature";
  EXPECT_EQ(said(with_glass("{ formula = \"1000 degC - 5 K/mm*x\" }")).substr(0, 80),
            (key + ".formula: \"1000 degC - 5 K/mm*x\" is no quantity: there is no dimension \"x\"").substr(0, 80));
  EXPECT_EQ(said(with_glass("{ formula = \"r\" }")),
            key + ".formula: \"r\" is a length, allowed is a temperature such as \"1150 degC\" at (0, 0) mm");
  EXPECT_EQ(said(with_glass("{ formula = \"300 K - 30 K*r/(1 mm)\" }")).rfind(key + ".formula: ", 0), 0u);
  EXPECT_NE(said(with_glass("{ formula = \"300 K - 30 K*r/(1 mm)\" }")).find("mm, allowed are temperatures above zero"),
            std::string::npos);
  EXPECT_EQ(said(with_glass("{ formula = \"1000 degC\", csv = \"T.csv\" }")),
            key + ": allowed is one of formula, csv and from");
  EXPECT_EQ(said(with_glass("{ formula = \"1000 degC\", body = \"plate\" }")),
            key + ".body: a body was found, allowed only together with \"from\"");
  EXPECT_EQ(
      said(replaced("boundary = [\n  { name = \"surface\"",
                    "skin = { temperature = \"900 degC\", depth = \"2 mm\" }\nboundary = [\n  { name = \"surface\"",
                    with_glass("{ formula = \"1000 degC\" }"))),
      "glass.skin: a skin and a field of temperatures were found, allowed is one of them");
  EXPECT_NE(said(with_glass("{ from = \"nowhere\" }")).find("nowhere/checkpoint.h5"), std::string::npos);
  EXPECT_EQ(said_of_table("r_mm,z_mm\n0,0\n"),
            "tool.temperature.csv: the heading \"r_mm,z_mm\" was found, allowed is a heading such as r_mm,z_mm,T_degC, "
            "with r, z or both");
  EXPECT_EQ(said_of_table("r_mm,T_degC\n0,hot\n"),
            "tool.temperature.csv: \"hot degC\" does not start with a number, allowed is a temperature such as \"1150 "
            "degC\"");
  EXPECT_EQ(said_of_table("r_mm,z_mm,T_degC\n0,0,400\n1,1,400\n"),
            "tool.temperature.csv: 2 rows with 2 different r and 2 different z were found, allowed is each pair of "
            "them once");
  EXPECT_EQ(said_of_table("r_mm,T_degC\n0,400\n0,500\n"),
            "tool.temperature.csv: 2 rows with 1 different r and 1 different z were found, allowed is each pair of "
            "them once");
}

TEST(StartTemperature, a_result_of_another_body_or_shape_is_refused) {
  const FirstResult first;
  const auto with = [&](const std::string& body) {
    return said(with_plate("{ from = \"" + first.folder + "\", body = \"" + body + "\" }"));
  };
  EXPECT_EQ(with("plat"),
            "tool.temperature.body: that result has no body \"plat\" (did you mean \"plate\"?), allowed are glass, "
            "plate, plunger");
  EXPECT_EQ(
      with("plunger"),
      "tool.temperature.from: the body lies from (0, 0) to (15, 20) mm at the end of that result but from (0, -10) to "
      "(30, 0) mm here, allowed is one that lies in the same place within 2 % of its size");
}

}  // namespace
}  // namespace parison::forming
