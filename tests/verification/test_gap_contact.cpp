// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "figure.hpp"
#include "forming/pot_scene.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene_text.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/heat/contact_opening.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "forming/step/heat/thermal_interface.hpp"
#include "forming/step/step.hpp"

namespace parison::forming {
namespace {

const std::string gap_law = R"(law = "gap"
touch_gap = "0.25 um"
open_gap = "40 um"
opening_time = "0.25 s"
closing = 1
accommodation = 0.9
)";

std::string gap_contact(const std::string& tools) {
  return "[[interface]]\ntools = [" + tools + "]\n" + gap_law;
}

/// A column of glass, 20 mm, on a column of iron as high: half-spaces for the time of a contact.
const std::string columns = R"(case = "columns"
geometry = "planar"
air = { temperature = "50 degC", h = "20 W/m2/K", ambient = "50 degC" }
[material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
emissivity = 0.89
)" + iron + "emissivity = 0.8\n" +
                            gap_contact("\"plate\"") + R"([glass]
material = "glass"
temperature = "1000 degC"
mesh = { mapped = [1, 60], ratio = [1, 200] }
boundary = [
  { name = "bottom", condition = "contact", path = "(0, 0) (2, 0) mm" },
  { name = "right", condition = "insulated", path = "(2, 20) mm" },
  { name = "top", condition = "insulated", path = "(0, 20) mm" },
  { name = "left", condition = "insulated", path = "(0, 0) mm" } ]
[[tool]]
name = "plate"
material = "iron"
temperature = "400 degC"
mesh = { mapped = [1, 60], ratio = [1, 200] }
boundary = [
  { name = "top", condition = "contact", path = "(2, 0) (0, 0) mm" },
  { name = "left", condition = "insulated", path = "(0, -40) mm" },
  { name = "under", condition = "insulated", path = "(2, -40) mm" },
  { name = "right", condition = "insulated", path = "(2, 0) mm" } ]
[[stage]]
name = "contact"
duration = "0.5 s"
tools = ["plate"]
)";

/// One side of the reference: cells that grow from the face, mean temperatures.
struct Side {
  double conductivity, capacity;
  std::vector<double> size, temperature;

  Side(double k, double rho_c, double start, int cells, double first, double growth)
      : conductivity(k), capacity(rho_c), size(cells), temperature(cells, start) {
    for (int i = 0; i < cells; ++i) size[i] = first * std::pow(growth, i);
  }
  /// Temperature of the face through which `flux`, W/m2, flows out.
  double face(double flux) const { return temperature[0] - flux * 0.5 * size[0] / conductivity; }
  /// Backward Euler over dt with a flux out of the face (Thomas algorithm).
  void advance(double dt, double flux) {
    const std::size_t n = size.size();
    std::vector<double> diagonal(n), upper(n), right(n);
    double left = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double mass = capacity * size[i] / dt;
      const double next = i + 1 < n ? 2 * conductivity / (size[i] + size[i + 1]) : 0;
      diagonal[i] = mass + left + next;
      right[i] = mass * temperature[i] - (i == 0 ? flux : 0);
      upper[i] = -next;
      if (i > 0) {
        const double factor = -left / diagonal[i - 1];
        diagonal[i] -= factor * upper[i - 1];
        right[i] -= factor * right[i - 1];
      }
      left = next;
    }
    for (std::size_t i = n; i-- > 0;)
      temperature[i] = (right[i] - (i + 1 < n ? upper[i] * temperature[i + 1] : 0)) / diagonal[i];
  }
};

/// Heat, J/m2, between two half-spaces in `time` through the gap, its equation integrated beside the heat: finite
/// volumes, the flux of a step found by repetition.
double reference_heat(const contact::GapConductance& law, double time, int steps) {
  Side glass(1.3, 2400.0 * 1300, 1273.15, 170, 1e-6, 1.04), tool(46, 7200.0 * 490, 673.15, 170, 4e-6, 1.04);
  double gap = law.touch_gap, heat = 0, now = 0;
  for (int i = 0; i < steps; ++i) {
    const double end = time * std::pow(double(i + 1) / steps, 2), dt = end - now;
    now = end;
    gap = (gap + dt / law.opening_time * law.open_gap) / (1 + dt / law.opening_time);
    const Side glass_before = glass, tool_before = tool;
    double flux = 0;
    for (int repeat = 0; repeat < 60; ++repeat) {
      glass = glass_before, tool = tool_before;
      glass.advance(dt, flux);
      tool.advance(dt, -flux);
      const double T1 = glass.face(flux), T2 = tool.face(-flux);
      const double wanted = law.at_opening(gap - law.touch_gap, T1, T2) * (T1 - T2);
      if (std::abs(wanted - flux) < 1e-9 * std::abs(wanted)) break;
      flux += 0.3 * (wanted - flux);
    }
    heat += dt * flux;
  }
  return heat;
}

TEST(GapContact, of_two_half_spaces_gives_the_heat_of_a_one_dimensional_reference) {
  Scene scene = scene_of(columns, "fine");
  scene.accuracy.temperature_tolerance = 1e-3;
  const auto& law = std::get<contact::GapConductance>(scene.interfaces[0].law);
  EXPECT_NEAR(law.exchange_emissivity, 1 / (1 / 0.89 + 1 / 0.8 - 1), 1e-12);
  State state = initial_state(scene);
  Workspace workspace;
  const double heat_before = glass_heat(scene, state);
  tests::Figure error("contact by the gap of two half-spaces: heat in 0.01 to 0.5 s against a 1-D reference, relative");
  double next = 0.01;
  for (int i = 1; i <= 50; ++i) {
    const auto result = coupled_step(scene, state, 0.01, workspace);
    ASSERT_TRUE(result.converged) << result.reason;
    state = result.state;
    if (state.time < next - 1e-9) continue;
    const double coarse = reference_heat(law, state.time, 400), fine = reference_heat(law, state.time, 800);
    const double exact = 2 * fine - coarse, found = state.tools[0].heat_received / 2e-3;
    std::printf("%.2f s: %.5g J/m2, reference %.5g (%.5g)\n", state.time, found, exact, fine);
    error.add(std::abs(found / exact - 1));
    next = state.time < 0.02 ? 0.05 : state.time < 0.06 ? 0.2 : 0.5;
  }
  error.at_most(2e-3);
  const double lost = heat_before - glass_heat(scene, state);
  tests::expect_at_most("contact by the gap: heat out of the glass against heat into the tool, relative",
                        std::abs(lost / state.tools[0].heat_received - 1), 1e-9);
  const double opening = law.opening_after(0, 0, 0.5);
  for (const Index node : contact_nodes(state.glass.mesh))
    EXPECT_NEAR(state.glass.contact_opening[node], opening, 1e-12 * opening);
}

/// The disc of the test of the coupling, with a gap that pressure and softness close.
const std::string pressed_disc = R"(case = "pressed_disc"
geometry = "axisymmetric"
air = { temperature = "50 degC", h = "20 W/m2/K", ambient = "50 degC" }
)" + container_glass("20 W/m/K") +
                                 iron + gap_contact(R"("plate", "plunger")") +
                                 disc_between_plates(8, R"(material = "glass"
temperature = "1000 degC"
mesh = { mapped = [6, 6] }
)",
                                                     R"(material = "iron"
temperature = "500 degC"
friction = { law = "navier", coefficient = "1e5 Pa.s/m" }
)") + R"([[stage]]
name = "press"
duration = "0.32 s"
tools = ["plate", "plunger"]
motion.plunger = { offset = [["0 s", "0 mm"], ["0.32 s", "-2.4 mm"]] }
)";

struct End {
  double heat, opening;
};

End after_equal_steps(Scene& scene, int steps) {
  State state = initial_state(scene);
  Workspace workspace;
  for (int i = 0; i < steps; ++i) {
    auto result = coupled_step(scene, state, scene.stages[0].duration / steps, workspace);
    EXPECT_TRUE(result.converged) << result.reason;
    state = std::move(result.state);
  }
  double opening = 0;
  for (Index n = 0; n < state.glass.mesh.node_count(); ++n)
    if (state.glass.mesh.nodes[n].norm() < 1e-9) opening = state.glass.contact_opening[n];
  return {state.totals.to_tools, opening};
}

TEST(GapContact, is_of_second_order_in_time_where_pressure_and_softness_close_the_gap) {
  Scene scene = scene_of(pressed_disc, "standard");
  scene.accuracy.temperature_tolerance = 1e-5;
  scene.accuracy.motion_tolerance = 1;
  scene.accuracy.temperature_per_step = 1e3;
  std::array<End, 4> end;
  for (int i = 0; i < 4; ++i) {
    end[i] = after_equal_steps(scene, 32 << i);
    std::printf("%3d steps: heat %.6f J, opening on the axis %.6f um\n", 32 << i, end[i].heat, 1e6 * end[i].opening);
  }
  const auto order = [&](double End::*quantity, int i) {
    return std::log2(
        std::abs((end[i].*quantity - end[i + 1].*quantity) / (end[i + 1].*quantity - end[i + 2].*quantity)));
  };
  for (int i = 0; i < 2; ++i)
    std::printf("orders: heat %.2f, opening %.2f\n", order(&End::heat, i), order(&End::opening, i));
  EXPECT_LT(end[3].opening, 0.9 * 39.75e-6 * (1 - std::exp(-0.32 / 0.25))) << "pressure has not closed the gap";
  tests::expect_at_least("order in time of contact by the gap: opening", order(&End::opening, 1), 1.8);
  tests::expect_at_least("order in time of contact by the gap: heat into the tools", order(&End::heat, 1), 1.8);
}

/// Integral of the conductance over the interface, W/K.
double conductance_of(const Scene& scene, const State& state) {
  const auto interface = thermal_interface(scene, state);
  const auto temperature = face_temperatures(state, interface);
  long clamped = 0;
  double sum = 0;
  for (std::size_t p = 0; p < interface.size(); ++p)
    sum += interface[p].area * interface[p].contact_weight *
           point_conductance(scene, interface[p], {temperature.glass[p], temperature.tool[p]}, clamped).h;
  return sum;
}

/// The state after steps of 2 ms.
State after_steps(const Scene& scene, State state, int steps) {
  Workspace workspace;
  for (int i = 0; i < steps; ++i) {
    auto result = coupled_step(scene, state, 2e-3, workspace);
    EXPECT_TRUE(result.converged) << result.reason;
    state = std::move(result.state);
  }
  return state;
}

double heat_of_steps(const Scene& scene, const State& state, int steps) {
  return after_steps(scene, state, steps).totals.to_tools - state.totals.to_tools;
}

class PressedPot : public ::testing::Test {
 protected:
  Scene scene;
  State state;

  void SetUp() override {
    const std::string law = pressed_contact(R"("pot", "plunger")");
    scene = scene_of(replaced(law, gap_contact(R"("pot", "plunger")"), pot));
    RunOutcome outcome = run_in_folder(scene, tests::absent_folder(), {});
    ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    state = outcome.state;
  }
};

TEST_F(PressedPot, keeps_its_gaps_through_a_new_mesh_in_mid_contact) {
  // A first new mesh has a node at each corner of the tools, beside which edges may have stood off.
  const RemeshedState cornered = remesh_state(scene, state, RemeshReason::quality);
  ASSERT_TRUE(cornered.ok) << cornered.reason;
  state = after_steps(scene, cornered.state, 10);
  const RemeshedState remeshed = remesh_state(scene, state, RemeshReason::quality);
  ASSERT_TRUE(remeshed.ok) << remeshed.reason;
  EXPECT_GT(state.glass.contact_opening.maxCoeff(), 5e-6);
  EXPECT_LE(remeshed.state.glass.contact_opening.maxCoeff(), state.glass.contact_opening.maxCoeff());
  EXPECT_GE(remeshed.state.glass.contact_opening.minCoeff(), 0);
  tests::expect_at_most("contact by the gap: conductance of all contacts changed by a new mesh, relative",
                        std::abs(conductance_of(scene, remeshed.state) / conductance_of(scene, state) - 1), 3e-3);
  tests::expect_at_most("contact by the gap: heat in the 20 ms after a new mesh, changed by it, relative",
                        std::abs(heat_of_steps(scene, remeshed.state, 10) / heat_of_steps(scene, state, 10) - 1), 3e-3);
}

TEST_F(PressedPot, begins_its_contact_anew_where_glass_and_tool_have_parted) {
  State parted = state;
  parted.tools[1].offset += 1e-3;
  advance_openings(scene, state, 1e-3, parted);
  int at_plunger = 0, at_pot = 0;
  for (Index n = 0; n < state.glass.mesh.node_count(); ++n) {
    if (!(state.glass.contact_opening[n] > 0)) continue;
    const Point& x = state.glass.mesh.nodes[n];
    if (x[0] < 10e-3 && x[1] > 4e-3) {
      EXPECT_EQ(parted.glass.contact_opening[n], 0) << x.transpose();
      ++at_plunger;
    } else if (x[0] < 10e-3) {
      EXPECT_GT(parted.glass.contact_opening[n], 0) << x.transpose();
      ++at_pot;
    }
  }
  EXPECT_GT(at_plunger, 5);
  EXPECT_GT(at_pot, 5);
}

TEST_F(PressedPot, balances_its_heat) {
  double received = 0;
  for (const ToolState& tool : state.tools) received += tool.heat_received;
  tests::expect_at_most("contact by the gap: heat of the tools against that the glass gave them, relative",
                        std::abs(received / state.totals.to_tools - 1), 1e-12);
  const double change = glass_heat(scene, state) - state.glass.initial_heat;
  const double flows = state.totals.dissipation - state.totals.to_air - state.totals.to_tools;
  tests::expect_at_most("contact by the gap: heat balance of the pressed glass, relative to the heat exchanged",
                        std::abs(change - flows) / state.totals.to_tools, 1e-9);
}

TEST(Swabbing, multiplies_the_conductance_of_its_tool) {
  const std::string plunger = "friction = \"slip\"\n";
  const auto heat = [](const std::string& text) {
    const auto outcome = run_in_folder(scene_of(replaced("duration = \"2 s\"", "duration = \"0.05 s\"", text)),
                                       tests::absent_folder(), {});
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    return std::array{outcome.state.tools[0].heat_received, outcome.state.tools[1].heat_received};
  };
  const auto split = replaced("tools = [\"plate\", \"plunger\"]\nlaw = \"constant\"\nh = \"2000 W/m2/K\"",
                              "tools = [\"plate\"]\nlaw = \"constant\"\nh = \"2000 W/m2/K\"\n[[interface]]\n"
                              "tools = [\"plunger\"]\nlaw = \"constant\"\nh = \"1000 W/m2/K\"");
  const auto halved = heat(split), swabbed = heat(replaced(plunger, plunger + "swabbing = 0.5\n"));
  const auto whole = heat(small_scene);
  for (int tool = 0; tool < 2; ++tool)  // the first cells at a tool follow its law
    EXPECT_NEAR(swabbed[tool], halved[tool], 2e-4 * halved[tool]);
  EXPECT_LT(halved[1], 0.9 * whole[1]);
}

}  // namespace
}  // namespace parison::forming
