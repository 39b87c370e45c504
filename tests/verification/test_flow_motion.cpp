// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/mesh/element.hpp"
#include "figure.hpp"
#include "forming/scene_text.hpp"
#include "forming/step/contact/penetration.hpp"
#include "stepping.hpp"

namespace parison::forming {
namespace {

/// A disc, 20 mm radius and 10 mm high, squeezed to 1.5 mm between slipping plates.
const std::string squeeze = R"(case = "squeeze"
geometry = "axisymmetric"
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
)" +
                            disc_between_plates(10, R"(material = "liquid"
mesh = { mapped = [8, 4] }
)",
                                                "friction = \"slip\"\n") +
                            R"([[stage]]
name = "squeeze"
duration = "0.85 s"
tools = ["plate", "plunger"]
motion.plunger = { offset = [["0 s", "0 mm"], ["0.85 s", "-8.5 mm"]] }
)";

struct SqueezeErrors {
  double force = 0, radius, drift;
};

SqueezeErrors squeeze_errors(double strain_per_step) {
  Scene scene = scene_of(squeeze, "standard");
  scene.accuracy.strain_per_step = strain_per_step;
  const double volume = M_PI * 0.02 * 0.02 * 0.01;
  SqueezeErrors errors;
  int heights = 0;
  const State start = initial_state(scene);
  const State end = steps_to(scene, start, 0.85, [&](const State& before, const State& after) {
    // The force of a step is that of its middle.
    const double height = 0.01 + 0.5 * (before.tools[1].offset + after.tools[1].offset);
    const double exact = 3 * 1e3 * 0.01 * volume / (height * height);
    for (const int tool : {1, 2})
      errors.force = std::max(errors.force, std::abs(std::abs(after.tools[tool - 1].force) / exact - 1));
    ++heights;
  });
  const auto& mesh = end.glass.mesh;
  double radius = 0;
  for (const auto& x : mesh.nodes) radius = std::max(radius, x[0]);
  errors.radius = radius / (0.02 * std::sqrt(10 / 1.5)) - 1;
  errors.drift = core::volume(mesh, scene.geometry) / start.glass.initial_volume - 1;
  std::printf(
      "slipping squeeze to 1.5 mm, strain %.4f a step: force off by %.1e at the worst of %d heights, radius by %.1e, "
      "volume by %.1e\n",
      strain_per_step, errors.force, heights, errors.radius, errors.drift);
  return errors;
}

TEST(SlippingSqueeze, needs_the_exact_force_at_every_height_on_the_way_down) {
  tests::Figure force("disc squeezed with slip from 10 to 1.5 mm, followed in time, all presets: force off by"),
      radius("the same: radius off by"), volume("the same: volume off by");
  for (const double strain_per_step : {0.3, 0.15, 0.075}) {  // of draft, standard and fine
    const auto errors = squeeze_errors(strain_per_step);
    force.add(errors.force);
    radius.add(std::abs(errors.radius));
    volume.add(std::abs(errors.drift));
  }
  force.at_most(1e-6);
  radius.at_most(1e-8);
  volume.at_most(1e-8);
}

/// The squeezed disc under a narrow sticking plunger with a sharp corner, which sinks by a tenth of the height.
std::string punch() {
  std::string text = squeeze;
  const auto put = [&](const std::string& from, const std::string& to) { text = replaced(from, to, text); };
  put("friction = \"slip\"", "friction = \"stick\"");
  put("friction = \"slip\"", "friction = \"stick\"");
  put("mesh = { mapped = [8, 4] }\n", "");
  put("name = \"rim\", condition = \"air\"", "name = \"rim\", condition = \"contact\"");
  put("(0, 10) (60, 10) mm\" }", "(0, 10) (7, 10) (7, 20) mm\" }");
  put("\"insulated\", path = \"(60, 20) (0, 20) mm\"", "\"insulated\", path = \"(0, 20) mm\"");
  put("duration = \"0.85 s\"", "duration = \"0.1 s\"");
  put("[\"0.85 s\", \"-8.5 mm\"]", "[\"0.1 s\", \"-1 mm\"]");
  return text;
}

TEST(Punch, whose_corner_sinks_into_smooth_glass_keeps_the_glass_out_and_its_volume) {
  const Scene scene = scene_of(punch(), "standard");
  const State start = initial_state(scene);
  double weakest = 1e9, depth = 0, drift = 0;
  const State end = steps_to(scene, start, 0.1, [&](const State&, const State& after) {
    weakest = std::min({weakest, after.tools[0].force, -after.tools[1].force});
    depth = deepest_node(scene, after, depth).depth;
    drift = std::max(drift, std::abs(core::volume(after.glass.mesh, scene.geometry) / after.glass.initial_volume - 1));
    EXPECT_NEAR(after.tools[0].force, -after.tools[1].force, 1e-6 * after.tools[0].force);
  });
  double rise = 0;
  for (const auto& x : end.glass.mesh.nodes) rise = std::max(rise, x[1] - 0.01);
  std::printf(
      "punch: %d steps, force %.2f N, glass in the tools at most %.2f um, volume off by %.1e, glass beside it rises "
      "%.2f mm\n",
      end.totals.steps, end.tools[0].force, 1e6 * depth, drift, 1e3 * rise);
  EXPECT_NEAR(end.time, 0.1, 1e-9);
  EXPECT_GT(weakest, 0);
  tests::expect_at_most("corner of a punch sinks into smooth glass: deepest node inside the punch", 1e6 * depth, 5,
                        "um");
  EXPECT_LT(drift, 1e-4);
}

/// A quarter of a drop, 10 mm radius, under its surface tension alone.
constexpr const char* drop = R"(case = "drop"
geometry = "axisymmetric"
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "100 Pa.s" }
surface_tension = "0.3 N/m"
[glass]
material = "liquid"
boundary = [
  { name = "equator", condition = "symmetry", path = "(0, 0) (10, 0) mm" },
  { name = "surface", condition = "air", path = "arc centre (0, 0) mm radius 10 mm from 0 deg to 90 deg" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[[stage]]
name = "relax"
duration = "4 s"
)";

double second_mode(const Point& x) {
  const double axial = x[1] / std::max(x.norm(), 1e-12);
  return 0.5 * (3 * axial * axial - 1);
}

/// Amplitude of the second mode of the surface, relative to the radius.
double amplitude(const Scene& scene, const core::Mesh& mesh) {
  const Index surface = core::find_boundary(mesh, "surface");
  double projected = 0, square = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (edge.boundary_id == surface)
      for (const auto& rule : core::edge_rule(4)) {
        const auto at = core::map_edge_point(mesh, edge.nodes, scene.geometry, rule);
        const double mode = second_mode(at.position);
        projected += at.area * mode * (at.position.norm() / 0.01 - 1);
        square += at.area * mode * mode;
      }
  return projected / square;
}

/// What is left after `time` of a drop stretched by `first`.
std::pair<double, double> relax(const Scene& scene, double first, double time) {
  State state = initial_state(scene);
  auto& mesh = state.glass.mesh;
  for (auto& x : mesh.nodes) x *= 1 + first * second_mode(x);
  state.glass.initial_volume = core::volume(mesh, scene.geometry);
  const double before = amplitude(scene, mesh);
  return {before, amplitude(scene, steps_to(scene, state, time).glass.mesh)};
}

TEST(RelaxingDrop, loses_its_second_mode_at_the_exact_rate) {
  Scene scene = scene_of(drop, "standard");
  const double exact = 20.0 / 19 * 0.3 / (100 * 0.01), time = 3;
  const auto [long_before, long_after] = relax(scene, 0.01, time);
  const auto [flat_before, flat_after] = relax(scene, -0.01, time);
  const double rate = std::log((long_before - flat_before) / (long_after - flat_after)) / time;
  std::printf("drop, %.0f s: decays at %.5f 1/s, exact %.5f, off by %.1e\n", time, rate, exact, rate / exact - 1);
  tests::expect_at_most("relaxing drop followed for 3 s, second mode: rate off by", std::abs(rate / exact - 1), 5e-3);
}

}  // namespace
}  // namespace parison::forming
