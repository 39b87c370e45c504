// SPDX-License-Identifier: GPL-3.0-or-later
// Plates with random histories of temperature against a one-dimensional solution of their own.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "cooling_body.hpp"
#include "figure.hpp"

namespace parison::cooling {
namespace {

constexpr double thickness = 6e-3, kelvin = 273.15;

/// Temperatures of a plate: a mean and what its middle has above its surface, straight between times.
struct History {
  core::Table mean, apart;  // K over s

  /// At a height over half the thickness.
  double at(double time, double height) const { return mean(time) + apart(time) * (1.0 / 3 - height * height); }
  double end() const { return mean.x.back(); }
};

History random_history(unsigned seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * double(random()) / double(std::mt19937::max());
  };
  History history{{{0}, {kelvin + 680}}, {{0}, {0}}};
  const auto go = [&](double seconds, double celsius, double apart) {
    history.mean.x.push_back(history.mean.x.back() + seconds);
    history.apart.x.push_back(history.mean.x.back());
    history.mean.y.push_back(kelvin + celsius);
    history.apart.y.push_back(apart);
  };
  const int turns = 2 + int(between(0, 4));
  for (int turn = 0; turn < turns; ++turn) go(10 * std::pow(50, between(0, 1)), between(420, 660), between(-20, 40));
  go(10 * std::pow(50, between(0, 1)), between(200, 400), between(0, 20));
  go(100, 20, 0);
  return history;
}

/// Stress of the middle and of the surface and the largest without sign, MPa, by points through half the thickness,
/// with small steps of backward Euler for branches and structure, extrapolated from two step lengths.
std::array<double, 3> by_points(const GlassLaw& law, const History& history, int steps) {
  constexpr int points = 21;
  struct At {
    Branches stress = Branches::Zero(), fictive;
    double thermal = 0;
  };
  std::vector<At> at(points);
  for (int i = 0; i < points; ++i) at[i].fictive = Branches::Constant(history.at(0, double(i) / (points - 1)));
  const double G = law.shear_modulus(), K = law.bulk_modulus(), dt = history.end() / steps;
  double in_plane = 0, before = 0;
  std::vector<double> mean(points, 0), thickening(points, 0), sigma(points, 0);
  for (int step = 1; step <= steps; ++step) {
    std::vector<double> constant(points), slope(points);
    std::vector<Branches> factor(points), left(points);
    for (int i = 0; i < points; ++i) {
      const double height = double(i) / (points - 1), T = history.at(step * dt, height),
                   T_before = history.at((step - 1) * dt, height);
      const double Tf = (law.structure.weight * at[i].fictive).sum();
      const double pace = dt * G / std::exp(law.log_viscosity(T, Tf));
      const Branches q = pace / law.structure.time;
      at[i].fictive = (at[i].fictive + q * T) / (1 + q);
      const double change = (law.structure.weight * at[i].fictive).sum() - Tf;
      at[i].thermal += law.solid_expansion * (T - T_before) + (law.liquid_expansion - law.solid_expansion) * change;
      // s' = (s + 2 G w de)/(1 + q), de_x = (ex - ez)/3 of the increments; sigma_z = 0.
      const Branches relaxing = 1 / (1 + pace / law.shear.time);
      left[i] = at[i].stress * relaxing;
      factor[i] = 2 * G * law.shear.weight * relaxing;
      // With s_z = -2 s_x: p' = K (2 ex + ez - 3 eth) (tension), s_z + p' = 0.
      const double S = left[i].sum(), F = factor[i].sum() / 3;
      // S + F (dex - dez) = s_x; -2 s_x + K (2 ex + ez - 3 eth) = 0 with ez = thickening + dez.
      const double whole = K + 2 * F;
      constant[i] = (2 * S - K * (2 * before + thickening[i] - 3 * at[i].thermal)) / whole;  // dez at dex = 0
      slope[i] = (2 * F - 2 * K) / whole;
    }
    // sigma_x = s_x + p' = 3 s_x; mean over the thickness is zero.
    double sum = 0, by = 0;
    for (int i = 0; i < points; ++i) {
      const double weight = i == 0 || i == points - 1 ? 1 : i % 2 ? 4 : 2;
      const double F = factor[i].sum() / 3;
      sum += weight * (left[i].sum() - F * constant[i]);
      by += weight * F * (1 - slope[i]);
    }
    const double dex = -sum / by;
    in_plane = before + dex;
    for (int i = 0; i < points; ++i) {
      const double dez = constant[i] + slope[i] * dex;
      at[i].stress = left[i] + factor[i] * (dex - dez) / 3;
      thickening[i] += dez;
      sigma[i] = 3 * at[i].stress.sum();
    }
    before = in_plane;
  }
  double largest = 0;
  for (const double here : sigma) largest = std::max(largest, std::abs(here));
  return {1e-6 * sigma.front(), 1e-6 * sigma.back(), 1e-6 * largest};
}

std::array<double, 2> by_equilibrium(const GlassLaw& law, const History& history, double change) {
  CoolingBody body(law, rectangle(3 * thickness, thickness / 2, 6, 12, 1, 1), core::Geometry::axisymmetric,
                   history.at(0, 0));
  hold_symmetry(body);
  const auto at = [&](double time) {
    Eigen::VectorXd temperature(body.mesh.node_count());
    for (Index n = 0; n < body.mesh.node_count(); ++n)
      temperature[n] = history.at(time, 2 * body.mesh.nodes[n][1] / thickness);
    return temperature;
  };
  // After a bend stress relaxes in branches of all times: steps grow from short ones, as in a stage.
  constexpr double shortest = 1e-3, growth = 1.5;
  for (std::size_t part = 1; part < history.mean.x.size(); ++part) {
    const double from = history.mean.x[part - 1], seconds = history.mean.x[part] - from;
    const double longest = seconds * change / (at(from + seconds) - at(from)).lpNorm<Eigen::Infinity>();
    double time = 0;
    for (double dt = shortest * seconds; time < seconds; dt = std::min(growth * dt, longest)) {
      const double next = seconds - time < 1.5 * dt ? seconds : time + dt;
      body.strain_to(at(from + next), next - time);
      time = next;
    }
  }
  return {body.stress({0, 0}, 2), body.stress({0, thickness / 2}, 2)};
}

TEST(RandomHistories, plates_have_the_stress_of_a_one_dimensional_solution) {
  // PARISON_HISTORIES: how many, 200 for the figure in forming/cooling/README.md.
  const char* asked = std::getenv("PARISON_HISTORIES");
  const int count = asked ? std::atoi(asked) : 12;
  const GlassLaw law = reference_law();
  tests::Figure off("plates with random histories: residual stress off by, of the largest in the plate");
  std::vector<double> errors;
  for (int seed = 1; seed <= count; ++seed) {
    const History history = random_history(unsigned(seed));
    const auto coarse = by_points(law, history, 4000), fine = by_points(law, history, 8000);
    const auto found = by_equilibrium(law, history, 2.5);
    double error = 0;
    for (int i = 0; i < 2; ++i)
      error = std::max(error, std::abs(found[i] - (2 * fine[i] - coarse[i])) / std::max(fine[2], 0.1));
    off.add(error);
    errors.push_back(error);
    if (error > 1e-2) std::printf("history %d: %.2f %% of %.3f MPa\n", seed, 100 * error, fine[2]);
  }
  std::sort(errors.begin(), errors.end());
  const double most = errors[errors.size() * 9 / 10];
  std::printf("%d histories: %.2f %% at nine of ten, %.2f %% at the most\n", count, 100 * most, 100 * errors.back());
  off.at_most(3e-2);
  tests::expect_at_most("nine of ten of them off by", most, 1e-2);
}

}  // namespace
}  // namespace parison::cooling
