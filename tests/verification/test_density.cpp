// SPDX-License-Identifier: GPL-3.0-or-later
// Glass whose density follows its temperature: sizes, openings and velocities that are known exactly, and its mass.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "core/mesh/element.hpp"
#include "figure.hpp"
#include "forming/pot_scene.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/files/history.hpp"
#include "forming/run/run.hpp"
#include "forming/scene_text.hpp"
#include "forming/state/fingerprint.hpp"
#include "forming/step/balance/volume_conservation.hpp"
#include "forming/step/flow/predictor.hpp"
#include "stepping.hpp"

namespace parison::forming {
namespace {

constexpr double solid = 9e-6, liquid = 32e-6, transformation = 823.15;

/// Length at a temperature, K, over that at 20 degC.
double length_at(double T) {
  return std::exp(solid * (std::min(T, transformation) - 293.15) + liquid * std::max(0.0, T - transformation));
}

std::string expanding_glass(const std::string& conductivity, const std::string& viscosity) {
  return R"(geometry = "axisymmetric"
[material.expanding]
heat_capacity = "1300 J/kg/K"
expansion = { cold_density = "2520 kg/m3", solid = "9e-6 1/K", liquid = "32e-6 1/K", transformation = "550 degC" }
conductivity = ")" +
         conductivity + "\"\nviscosity = " + viscosity + "\n";
}
const std::string container = R"({ law = "vft", A = -2.309, B = "3922 K", T0 = "291 degC" })";

/// Mass by the fields as a result file has them, kg.
double mass_of(const Scene& scene, const State& state) {
  return scene.glass.density() * relative_mass(scene, state.glass.mesh, state.glass.temperature);
}

/// Half a ball, 10 mm radius, that cools in air; the plane is one of symmetry.
Scene ball(const std::string& h, const std::string& duration, const std::string& size = "1 mm",
           const std::string& numerics = "") {
  return scene_of("case = \"ball\"\n" + expanding_glass("1.3 W/m/K", container) + R"([glass]
material = "expanding"
temperature = "1150 degC"
mesh = { size = ")" + size +
                      R"(" }
boundary = [
  { name = "plane", condition = "symmetry", path = "(0, 0) (10, 0) mm" },
  { name = "surface", condition = "air", path = "arc centre (0, 0) mm radius 10 mm from 0 deg to 90 deg" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[air]
temperature = "20 degC"
ambient = "20 degC"
h = ")" + h + R"("
[[stage]]
name = "cool"
duration = ")" + duration +
                      "\"\n" + numerics,
                  "standard");
}

TEST(Density, a_ball_that_cools_from_1150_to_20_degC_has_its_size_and_at_each_step_its_mass) {
  const Scene scene = ball("100 W/m2/K", "1200 s");
  const State start = initial_state(scene);
  double worst_mass = 0, colder = 0;
  RunFacts facts;
  facts.diagnostics = first_diagnostics(scene, start);
  const auto look = [&](const State&, const State& after) {
    worst_mass = std::max(worst_mass, std::abs(mass_of(scene, after) / start.glass.mass - 1));
    const auto& T = after.glass.temperature;
    colder = std::max(colder, T.maxCoeff() - T.minCoeff());
  };
  const State state = steps_to(scene, start, 1200, look, &facts.diagnostics);
  EXPECT_LT(state.glass.temperature.maxCoeff(), 293.25);
  EXPECT_GT(colder, 100) << "the skin is much colder than the middle in between";
  tests::Figure size("ball that cools from 1150 to 20 degC, standard: radius off by"), mass("the same: mass off by");
  const Index surface = core::find_boundary(state.glass.mesh, "surface");
  for (const auto& edge : state.glass.mesh.boundary_edges())
    if (edge.boundary_id == surface)
      for (const Index node : edge.nodes)
        size.add(std::abs(state.glass.mesh.nodes[node].norm() * length_at(1423.15) / 0.01 - 1));
  mass.add(worst_mass);
  std::printf("ball: mass off by %.2e in %d steps\n", worst_mass, state.totals.steps);
  size.at_most(1e-4);
  mass.at_most(1e-12);
  // Nothing loads the ball: what its skin does to its middle is not lost in glass that should be stiffer.
  EXPECT_GT(facts.diagnostics.work.capped, 0);
  for (const Check& check : checks(scene, state, facts))
    if (check.name == std::string("viscosity_cap")) EXPECT_EQ(check.value, 0);
}

/// Temperatures at the end of a step, K.
using EndTemperature = std::function<Eigen::VectorXd(const State& before, const State& after)>;

/// By how much the velocity of a cooling ball is off, of the largest, at the worst node and time from 10 s on, for
/// steps that end with such temperatures; `but_for_dilatation`: but for the even dilatation that makes the mass exact.
double velocity_error(const Scene& scene, const EndTemperature& end_temperature, bool but_for_dilatation = false) {
  double at = 0, error = 0;
  steps_to(scene, initial_state(scene), 20, [&](const State& before, const State& after) {
    at = after.time;
    if (at < 10) return;
    // v r^2 is the integral of e r^2, here from the temperatures along the plane.
    const double dt = after.time - before.time;
    const Eigen::VectorXd end = end_temperature(before, after);
    const auto expansion = [&](Index node) {
      return 3 * std::log(length_at(end[node]) / length_at(before.glass.temperature[node])) / dt;
    };
    const auto middle = [&](Index node) {
      return 0.5 * (before.glass.mesh.nodes[node][0] + after.glass.mesh.nodes[node][0]);
    };
    std::map<double, std::array<Index, 3>> edges;
    for (const auto& edge : before.glass.mesh.boundary_edges())
      if (edge.boundary_id == core::find_boundary(before.glass.mesh, "plane"))
        edges[middle(edge.nodes[0])] = edge.nodes;
    double integral = 0;
    std::vector<std::array<double, 3>> found;  // r, velocity, what it should be
    for (const auto& [first, nodes] : edges) {
      const double length = middle(nodes[1]) - middle(nodes[0]);
      for (const auto& rule : core::edge_rule(4)) {
        const auto shape = core::edge_shape(rule.s);
        double r = 0, e = 0;
        for (int i = 0; i < 3; ++i) r += shape[i] * middle(nodes[i]), e += shape[i] * expansion(nodes[i]);
        integral += rule.weight * length * e * r * r;
      }
      const double v = after.glass.velocity[core::dim * nodes[1]], r = middle(nodes[1]);
      found.push_back({r, v, integral / (r * r)});
    }
    const auto& [radius, at_surface, there] = found.back();
    const double dilatation = but_for_dilatation ? (at_surface - there) / radius : 0;
    double worst = 0, largest = 0;
    for (const auto& [r, v, wanted] : found) {
      largest = std::max(largest, std::abs(v));
      worst = std::max(worst, std::abs(v - wanted - dilatation * r));
    }
    error = std::max(error, worst / largest);
  });
  EXPECT_GT(at, 10);
  return error;
}

TEST(Density, a_cooling_ball_moves_as_the_heat_it_has_lost_inside_each_radius) {
  tests::Figure error("ball in cooling, standard: velocity off by, of the largest");
  error.add(velocity_error(ball("100 W/m2/K", "20 s"),
                           [](const State&, const State& after) { return after.glass.temperature; }));
  error.at_most(5e-3);
}

TEST(Density, a_cooling_ball_moves_exactly_where_the_flow_foresees_the_temperatures_of_the_step) {
  // They are predicted from the step before; against these cells alone are left as the cause.
  const auto with_cells = [](const std::string& size) {
    const Scene scene = ball("100 W/m2/K", "20 s", size);
    const auto foreseen = [&](const State& before, const State& after) {
      return predicted_temperature(scene, before, after.time - before.time);
    };
    return velocity_error(scene, foreseen, true);
  };
  const double coarse = with_cells("1 mm"), fine = with_cells("0.5 mm");
  tests::Figure error("the same against the temperatures that the flow foresees, cells of 0.5 mm: velocity off by");
  error.add(fine);
  error.at_most(1e-4);
  tests::Figure order("the same: order of the velocity in space");
  order.add(std::log2(coarse / fine));
  order.at_least(2.5);
}

/// A plug of 10 mm radius and height of one temperature at a time, which cools in a tool: a mould, or a ring at its
/// side.
Scene plug(const std::string& viscosity, const std::string& friction, const std::string& tool) {
  return scene_of("case = \"plug\"\n" +
                      expanding_glass("1e5 W/m/K", "{ law = \"constant\", value = \"" + viscosity + "\" }") + iron +
                      R"([glass]
material = "expanding"
temperature = "1150 degC"
boundary = [
  { name = "bottom", condition = "contact", path = "(0, 0) (10, 0) mm" },
  { name = "side", condition = "contact", path = "(10, 10) mm" },
  { name = "top", condition = "air", path = "(0, 10) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[[tool]]
name = "mould"
material = "iron"
temperature = "400 degC"
friction = ")" + friction +
                      R"("
boundary = [ )" + tool +
                      R"(,
  { name = "outer", condition = "insulated", path = "(20, -8) (20, 20) (10, 20) mm" } ]
[[interface]]
tools = ["mould"]
law = "constant"
h = "1e-3 W/m2/K"
[air]
temperature = "20 degC"
ambient = "20 degC"
h = "500 W/m2/K"
[[stage]]
name = "hold"
duration = "20 s"
gravity = "-9.81 m/s2"
tools = ["mould"]
)",
                  "standard");
}

const std::string mould = R"({ name = "inner", condition = "contact", path = "(10, 20) (10, 0) (0, 0) mm" },
  { name = "axis", condition = "symmetry", path = "(0, -8) mm" })",
                  ring = R"({ name = "inner", condition = "contact", path = "(10, 20) (10, -8) mm" })";

/// Adds by how much the opening between the side of such a plug and its tool is off, as a share of what it shrinks.
void add_opening_error(const Scene& scene, tests::Figure& error) {
  const State start = initial_state(scene), state = steps_to(scene, start, 20);
  EXPECT_NEAR(mass_of(scene, state), start.glass.mass, 1e-12 * start.glass.mass);
  const double T = core::volume_mean(state.glass.mesh, scene.geometry, state.glass.temperature);
  const double opening = 0.01 * (1 - length_at(T) / length_at(1423.15));
  EXPECT_GT(opening, 1e-4);
  const Index side = core::find_boundary(state.glass.mesh, "side");
  for (const auto& edge : state.glass.mesh.boundary_edges())
    if (edge.boundary_id == side)
      for (const Index node : edge.nodes) error.add(std::abs((0.01 - state.glass.mesh.nodes[node][0]) / opening - 1));
  std::printf("plug: at %.1f degC, opening %.4f mm, %d steps\n", T - 273.15, 1e3 * opening, state.totals.steps);
}

TEST(Density, a_plug_opens_from_a_rigid_mould_by_what_it_shrinks) {
  tests::Figure error("plug that cools in a rigid mould, standard: its opening off by");
  add_opening_error(plug("1e9 Pa.s", "slip", mould), error);
  error.at_most(1e-4);
}

TEST(Density, a_cold_plug_comes_off_a_ring_that_grips_by_what_it_shrinks) {
  tests::Figure error("cold plug that cools in a ring that grips, standard: its opening off by");
  add_opening_error(plug("1e12 Pa.s", "grip", ring), error);
  error.at_most(1e-4);
}

TEST(Density, a_cold_plug_comes_off_a_corner_of_a_mould_that_grips_by_what_it_shrinks) {
  tests::Figure error("cold plug that cools in a mould that grips at side and bottom, standard: its opening off by");
  add_opening_error(plug("1e12 Pa.s", "grip", mould), error);
  error.at_most(1e-4);
}

/// Sees how far the mass is off after each step and each new mesh.
class MassWitness : public RunObserver {
 public:
  double worst = 0, start = 0;
  RunOutcome kept;
  void stage_begins(const RunView& run) override { look(run); }
  void step_begins(const RunView& run) override { look(run); }
  void step_taken(const RunView& run, const State&, const StepReport&) override { look(run); }
  void checkpoint_possible(const RunView& run, bool) override {
    if (run.state.totals.steps == 8) kept = {run.state, run.facts};
  }

 private:
  void look(const RunView& run) {
    const double mass = mass_of(run.scene, run.state);
    if (start == 0) start = mass;
    worst = std::max(worst, std::abs(mass / start - 1));
  }
};

TEST(Density, a_pressed_gob_keeps_its_mass_through_new_meshes_and_a_run_taken_up_again) {
  const std::string glass = "[material.glass]\ndensity = \"2400 kg/m3\"\n";
  std::string text = replaced(glass,
                              "[material.glass]\nexpansion = { cold_density = \"2520 kg/m3\", solid = \"9e-6 "
                              "1/K\", liquid = \"32e-6 1/K\", transformation = \"550 degC\" }\n",
                              replaced("duration = \"0.4 s\"", "duration = \"0.1 s\"", pot + "quality_floor = 0.6\n"));
  text = replaced("[material.glass]",
                  "[[stage]]\nname = \"rest\"\nduration = \"0.1 s\"\ngravity = \"-9.81 m/s2\"\ntools = [\"pot\"]\n"
                  "[material.glass]",
                  text);
  const Scene scene = scene_of(text);
  MassWitness witness;
  const RunOutcome whole = run(scene, {&witness});
  ASSERT_TRUE(whole.facts.completed) << whole.facts.reason;
  const auto& remeshing = whole.state.totals.remeshing;
  EXPECT_GE(remeshes(whole.state), 3);
  tests::Figure mass("gob pressed in a pot, new meshes and a second stage: mass off by");
  tests::Figure heat("the same: heat changed by one new mesh, of all that it loses");
  std::printf("pot: mass off by %.2e, %d steps, %d meshes, heat %.2e, imbalance %.2e, work %.2e\n", witness.worst,
              whole.state.totals.steps, remeshes(whole.state), remeshing.max_heat,
              glass_facts(scene, whole.state).energy_imbalance, whole.state.totals.work.expansion);
  mass.add(witness.worst);
  mass.at_most(1e-12);
  heat.add(remeshing.max_heat / (whole.state.totals.to_tools + whole.state.totals.to_air));
  heat.at_most(1e-9);
  EXPECT_LT(std::abs(glass_facts(scene, whole.state).energy_imbalance), 1e-9);
  EXPECT_NEAR(glass_facts(scene, whole.state).mass, witness.start, 1e-12 * witness.start);
  ASSERT_EQ(witness.kept.state.totals.steps, 8);
  EXPECT_EQ(fingerprint(resume(scene, std::move(witness.kept)).state), fingerprint(whole.state));
}

}  // namespace
}  // namespace parison::forming
