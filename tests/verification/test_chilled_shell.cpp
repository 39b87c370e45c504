// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/run/run.hpp"
#include "forming/scene_text.hpp"

namespace parison::forming {
namespace {

constexpr double conductivity = 1.3, capacity = 2400.0 * 1300, hot = 1323.15, cold = 373.15;

/// A thick shell of one temperature that a pressure inside blows up while air chills it outside.
struct ChilledShell {
  double inner, outer;  ///< m
  double h;             ///< W/m2/K
  double pressure;      ///< Pa
  double duration;      ///< s
};

/// Blown to 1.3 times their inner radius, with skins 14 500 and 330 times as viscous as their insides in the end.
constexpr ChilledShell stiff{10e-3, 20e-3, 500, 515.3, 3}, small{6e-3, 15e-3, 400, 443.7, 2};

double viscosity_at(double kelvin) {
  return std::pow(10, -2.309 + 3922 / (kelvin - 291 - 273.15));
}

/// The same in one dimension, in cells of glass that thin towards the outside.
class Layers {
 public:
  explicit Layers(const ChilledShell& shell) : shell_(shell), temperature_(cells, hot) {
    for (int i = 0; i <= cells; ++i) {
      const double left = 1 - double(i) / cells;
      cubes_.push_back(std::pow(shell.inner + (shell.outer - shell.inner) * (1 - left * left), 3));
    }
  }

  /// Inner radius at the end, m: half of each step's motion, its heat, the other half.
  double blow() {
    for (int step = 0; step < steps; ++step) {
      const auto time = [&](int n) { return shell_.duration * n * n / (double(steps) * steps); };
      const double dt = time(step + 1) - time(step), start = inner_;
      inner_ = start + 0.5 * dt * speed();
      const std::vector<double> before = temperature_, whole = conducted(before, dt),
                                halves = conducted(conducted(before, 0.5 * dt), 0.5 * dt);
      for (int i = 0; i < cells; ++i) temperature_[i] = 0.5 * (before[i] + 2 * halves[i] - whole[i]);
      inner_ = start + dt * speed();
      for (int i = 0; i < cells; ++i) temperature_[i] = 2 * halves[i] - whole[i];
    }
    return inner_;
  }

 private:
  static constexpr int cells = 200, steps = 800;

  double radius(double cube) const { return std::cbrt(inner_ * inner_ * inner_ + cube - cubes_[0]); }
  double middle(int cell) const { return radius(0.5 * (cubes_[cell] + cubes_[cell + 1])); }

  /// Of the inner surface, m/s: the pressure is the integral of 12 eta a^2 a'/r^4 over the wall.
  double speed() const {
    double sum = 0;
    for (int i = 0; i < cells; ++i)
      sum +=
          viscosity_at(temperature_[i]) * (std::pow(radius(cubes_[i]), -3) - std::pow(radius(cubes_[i + 1]), -3)) / 3;
    return shell_.pressure / (12 * inner_ * inner_ * sum);
  }

  /// Temperatures after a step of Euler's backward method, per steradian.
  std::vector<double> conducted(const std::vector<double>& from, double dt) const {
    std::vector<double> diagonal(cells), between(cells, 0.0), right(cells);
    for (int i = 0; i < cells; ++i) {
      diagonal[i] = capacity * (cubes_[i + 1] - cubes_[i]) / (3 * dt);
      right[i] = diagonal[i] * from[i];
    }
    for (int i = 0; i + 1 < cells; ++i)
      between[i] = conductivity * std::pow(radius(cubes_[i + 1]), 2) / (middle(i + 1) - middle(i));
    const double out = radius(cubes_[cells]),
                 lost = out * out / (1 / shell_.h + (out - middle(cells - 1)) / conductivity);
    for (int i = 0; i < cells; ++i) diagonal[i] += between[i] + (i > 0 ? between[i - 1] : 0);
    diagonal[cells - 1] += lost;
    right[cells - 1] += lost * cold;
    for (int i = 1; i < cells; ++i) {
      diagonal[i] -= between[i - 1] * between[i - 1] / diagonal[i - 1];
      right[i] += between[i - 1] * right[i - 1] / diagonal[i - 1];
    }
    right[cells - 1] /= diagonal[cells - 1];
    for (int i = cells - 2; i >= 0; --i) right[i] = (right[i] + between[i] * right[i + 1]) / diagonal[i];
    return right;
  }

  ChilledShell shell_;
  double inner_ = shell_.inner;
  std::vector<double> cubes_, temperature_;
};

/// Thickness of the wall, m, with such an inner radius.
double wall(const ChilledShell& shell, double inner) {
  return std::cbrt(inner * inner * inner + std::pow(shell.outer, 3) - std::pow(shell.inner, 3)) - inner;
}

std::string text_of(const ChilledShell& shell) {
  return fmt::format(R"toml(case = "shell"
geometry = "axisymmetric"
air = {{ temperature = "100 degC", h = "{h} W/m2/K", ambient = "100 degC" }}
stage = [{{ name = "blow", duration = "{duration} s", pressure.inner = "{pressure} Pa" }}]
[material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
viscosity = {{ law = "vft", A = -2.309, B = "3922 K", T0 = "291 degC" }}
[glass]
material = "glass"
temperature = "1050 degC"
boundary = [
  {{ name = "equator", path = "({inner}, 0) ({outer}, 0) m", condition = "symmetry" }},
  {{ name = "outer", path = "arc centre (0, 0) m radius {outer} m from 0 deg to 90 deg", condition = "air" }},
  {{ name = "axis", path = "(0, {inner}) m", condition = "symmetry" }},
  {{ name = "inner", path = "arc centre (0, 0) m radius {inner} m from 90 deg to 0 deg", condition = "insulated" }},
]
)toml",
                     fmt::arg("h", shell.h), fmt::arg("duration", shell.duration), fmt::arg("pressure", shell.pressure),
                     fmt::arg("inner", shell.inner), fmt::arg("outer", shell.outer));
}

/// By how much the wall in the mean over the inner surface is off.
double error_of_wall(const ChilledShell& shell, const char* accuracy) {
  const auto outcome = run(scene_of(text_of(shell), accuracy));
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  const core::Mesh& mesh = outcome.state.glass.mesh;
  const Index inner = core::find_boundary(mesh, "inner");
  double sum = 0, count = 0;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    if (edge.boundary_id == inner) sum += mesh.nodes[edge.nodes[2]].norm(), ++count;
  const double exact = wall(shell, Layers(shell).blow()), found = wall(shell, sum / count);
  std::printf("%s: wall %.4f mm, in one dimension %.4f, off by %.2e\n", accuracy, 1e3 * found, 1e3 * exact,
              found / exact - 1);
  return std::abs(found / exact - 1);
}

TEST(ChilledShell, gets_new_meshes_while_the_skin_that_it_is_blown_against_stiffens) {
  EXPECT_NEAR(1e3 * Layers(stiff).blow(), 12.9997, 2e-3);
  EXPECT_LT(error_of_wall(stiff, "draft"), 0.02);
  EXPECT_LT(error_of_wall(stiff, "standard"), 0.006);
  EXPECT_LT(error_of_wall(small, "draft"), 0.006);
  EXPECT_LT(error_of_wall(small, "standard"), 0.002);
}

}  // namespace
}  // namespace parison::forming
