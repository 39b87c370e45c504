// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/mesh/mesh.hpp"
#include "figure.hpp"
#include "forming/run/run.hpp"
#include "forming/scene_text.hpp"

namespace parison::forming {
namespace {

/// A drop of 5 mm radius in free flight: 1000 Pa.s, 0.3 N/m; two half spheres 0.6 mm apart.
std::string drop(double duration) {
  return fmt::format(R"(case = "drop"
geometry = "axisymmetric"
stage = [{{ name = "flight", duration = "{} s" }}]
[material.liquid]
density = "2400 kg/m3"
viscosity = {{ law = "constant", value = "1000 Pa.s" }}
surface_tension = "0.3 N/m"
[glass]
material = "liquid"
boundary = [
  {{ name = "surface", condition = "contact", path = [
    "arc centre (0, 20) mm radius 5 mm from -90 deg to 0 deg", "(5, 20.6) mm",
    "arc centre (0, 20.6) mm radius 5 mm from 0 deg to 90 deg"] }},
  {{ name = "axis", condition = "symmetry", path = "(0, 15) mm" }},
]
)",
                     duration);
}

/// Quadrupole, int z^2 - r^2/2 dV about the centre of mass, m5, and height of that centre, m.
struct Moments {
  double quadrupole, centre;
};
Moments moments(const core::Mesh& mesh) {
  const auto geometry = core::Geometry::axisymmetric;
  Eigen::VectorXd z(mesh.node_count()), shape(mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) z[n] = mesh.nodes[n][1];
  const double centre = core::volume_mean(mesh, geometry, z);
  for (Index n = 0; n < mesh.node_count(); ++n)
    shape[n] = std::pow(z[n] - centre, 2) - 0.5 * std::pow(mesh.nodes[n][0], 2);
  return {core::volume_mean(mesh, geometry, shape) * core::volume(mesh, geometry), centre};
}

Moments after(double time, const char* accuracy) {
  const auto outcome = run(scene_of(drop(time), accuracy));
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  return moments(outcome.state.glass.mesh);
}

TEST(FreeDrop, rounds_at_the_rate_of_its_second_mode_and_stays_where_it_is) {
  // (n (n+2) (2n+1)) / (2 (2n^2 + 4n + 3)) sigma / (mu R), n = 2: creeping limit of W. H. Reid, Q. Appl. Math. 18
  // (1960) 86-89.
  const double radius = std::cbrt(std::pow(5, 3) + 0.75 * 25 * 0.6) * 1e-3, rate = 20.0 / 19 * 0.3 / (1000 * radius);
  tests::Figure off("viscous drop in free flight, second mode, draft and standard: rate of decay off by"),
      drift("the same: centre of mass moves by, of the radius");
  for (const char* accuracy : {"draft", "standard"}) {
    const Moments early = after(15, accuracy), late = after(30, accuracy);
    const double found = std::log(early.quadrupole / late.quadrupole) / 15;
    std::printf("%s: rate %.5f 1/s, exact %.5f, off by %.2e\n", accuracy, found, rate, found / rate - 1);
    off.add(std::abs(found / rate - 1));
    drift.add(std::abs(late.centre - 20.3e-3) / radius);
  }
  off.at_most(1e-2);
  drift.at_most(1e-6);
}

TEST(FreeDrop, is_refused_where_gravity_or_air_would_move_it) {
  const auto refused = [](const std::string& load) {
    std::string text = drop(1);
    text.replace(text.find(" }]"), 3, ", " + load + " }]");
    return complaint_about(text);
  };
  for (const char* load : {"gravity = \"-9.81 m/s2\"", "pressure.surface = \"1 bar\""})
    EXPECT_NE(refused(load).find("nothing constrains the glass along the axis"), std::string::npos) << refused(load);
}

}  // namespace
}  // namespace parison::forming
