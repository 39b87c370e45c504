// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numeric>

#include "forming/run/run.hpp"
#include "forming/scene_parts.hpp"
#include "forming/scene_text.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/cavities/trapped_air.hpp"
#include "forming/step/step.hpp"

namespace parison::forming {
namespace {

/// A ring of glass between two plates inside a wall: air within and around it.
const std::string ring = R"(case = "ring"
geometry = "axisymmetric"
trapped_air = { law = "isothermal", temperature = "500 degC", ambient = "1 bar" }
)" + ring_of_glass + R"([[tool]]
name = "cup"
friction = "slip"
boundary = [
  { name = "face", condition = "contact", path = "(10, 12) (10, 0) (0, 0) mm" },
  { name = "axis", condition = "symmetry", path = "(0, -10) mm" },
  { name = "rest", condition = "insulated", path = "(20, -10) (20, 12) (10, 12) mm" } ]
[[tool]]
name = "lid"
friction = "slip"
position = "10 mm"
boundary = [
  { name = "face", condition = "contact", path = "(0, 0) (10, 0) mm" },
  { name = "rest", condition = "insulated", path = "(10, 20) (0, 20) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[[stage]]
name = "close"
duration = "1 s"
tools = ["cup", "lid"]
motion.lid = { offset = [["0 s", "10 mm"], ["1 s", "9 mm"]] }
)";

constexpr double inner = M_PI * 36e-6 * 10e-3, outer = M_PI * 36e-6 * 10e-3;  // m3, drawn

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The air at the start of the next step.
std::vector<double> amounts(const Scene& scene, const State& state) {
  const StepStart start = step_start(scene, state, 1e-3);
  return start.air_amount;
}

State one_step(const Scene& scene) {
  Workspace workspace;
  const auto result = coupled_step(scene, initial_state(scene), 1e-3, workspace);
  EXPECT_TRUE(result.converged) << result.reason;
  return result.state;
}

/// The tool in contact with the nodes of the ring's top.
void set_top_contact(State& state, Index tool) {
  const auto& mesh = state.glass.mesh;
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.boundaries()[edge.boundary_id].name == "top")
      for (const Index node : edge.nodes) state.glass.contact_tool[node] = tool;
}

TEST(TrappedAirState, cavities_start_with_ambient_air) {
  const Scene scene = scene_of(ring);
  const auto start = step_start(scene, initial_state(scene), 1e-3);
  ASSERT_EQ(start.air->pockets.size(), 2u);
  for (const auto& pocket : start.air->pockets) EXPECT_NEAR(pocket.energy, 1e5 * pocket.volume, 1e-12);
  EXPECT_NEAR(sum(start.air_amount), 1e5 * (inner + outer), 1e-8);
}

TEST(TrappedAirState, a_step_keeps_the_amounts) {
  const Scene scene = scene_of(ring);
  const auto before = amounts(scene, initial_state(scene)), after = amounts(scene, one_step(scene));
  ASSERT_EQ(after.size(), 2u);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(after[i] / before[i], 1, 1e-12);
}

TEST(TrappedAirState, amounts_add_up_where_cavities_join_and_are_divided_by_volume_where_they_part) {
  const Scene scene = scene_of(ring);
  State state = one_step(scene);
  state.cavity_air.amount[0] *= 3;
  state.cavity_air.energy[0] *= 3;
  const double whole = sum(state.cavity_air.amount);
  set_top_contact(state, -1);
  StepStart joined = step_start(scene, state, 1e-3);
  ASSERT_EQ(joined.air->pockets.size(), 1u);
  EXPECT_NEAR(joined.air_amount[0] / whole, 1, 1e-12);
  EXPECT_NEAR(joined.air->pockets[0].energy / whole, 1, 1e-12);

  // The state as a step with one cavity would leave it, then the contact is back.
  state.cavity_air.volume = {joined.air->pockets[0].volume};
  state.cavity_air.energy = state.cavity_air.amount = {whole};
  for (Index& cavity : state.cavity_air.marker_cavity) cavity = 0;
  set_top_contact(state, 1);
  const StepStart parted = step_start(scene, state, 1e-3);
  ASSERT_EQ(parted.air->pockets.size(), 2u);
  EXPECT_NEAR(sum(parted.air_amount) / whole, 1, 1e-12);
  EXPECT_NEAR(parted.air_amount[0] / parted.air_amount[1],
              parted.air->pockets[0].volume / parted.air->pockets[1].volume, 1e-12);
}

TEST(TrappedAirState, a_pressure_of_the_stage_opens_a_cavity_and_a_case_without_the_key_has_none) {
  const Scene scene = scene_of(ring + "pressure.inner = \"1 bar\"\n");
  const State state = initial_state(scene);
  const StepStart fed = step_start(scene, state, 1e-3);
  ASSERT_EQ(fed.air->pockets.size(), 1u);
  EXPECT_NEAR(fed.air->pockets[0].volume, outer, 1e-11);
  const Scene vented = scene_of(
      replaced("law = \"isothermal\", temperature = \"500 degC\", ambient = \"1 bar\"", "law = \"vented\"", ring));
  const State drawn = initial_state(vented);
  EXPECT_FALSE(step_start(vented, drawn, 1e-3).air);
}

TEST(TrappedAirState, half_a_closed_shell_between_axis_and_plane_is_compressed_to_equal_pressures) {
  // Half an atmosphere of overpressure from outside: at rest the air inside has two thirds of its volume.
  const std::string text = R"(case = "half_shell"
geometry = "axisymmetric"
trapped_air = { law = "isothermal", temperature = "500 degC", ambient = "1 bar" }
stage = [{ name = "press", duration = "1 s", pressure.outer = "0.5 bar" }]
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
[glass]
material = "liquid"
mesh = { mapped = [3, 16] }
boundary = [{ name = "equator", path = "(10, 0) (12, 0) mm", condition = "symmetry" },
  { name = "outer", path = "arc centre (0, 0) mm radius 12 mm from 0 deg to 90 deg", condition = "air" },
  { name = "axis", path = "(0, 10) mm", condition = "symmetry" },
  { name = "inner", path = "arc centre (0, 0) mm radius 10 mm from 90 deg to 0 deg", condition = "air" }]
)";
  const RunOutcome outcome = run(scene_of(text), {}, {});
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  const CavityAir& air = outcome.state.cavity_air;
  ASSERT_EQ(air.volume.size(), 1u);
  EXPECT_NEAR(air.amount[0] / (1e5 * 2 * M_PI / 3 * 1e-6), 1, 1e-3);
  EXPECT_NEAR(air.volume[0] / (2 * M_PI / 3 * 1e-6), 2.0 / 3, 2e-3);
  EXPECT_NEAR(air.energy[0] / air.volume[0], 1.5e5, 1e-3 * 1.5e5);
}

}  // namespace
}  // namespace parison::forming
