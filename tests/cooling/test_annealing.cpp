// SPDX-License-Identifier: GPL-3.0-or-later
// The shortest curve that anneals a plate under a limit: what the search of `optimise` finds against what is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "cooling_body.hpp"
#include "core/io/files.hpp"
#include "figure.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/run/run.hpp"
#include "forming/step/cooling/cooling_step.hpp"
#include "forming/study/search/goal.hpp"
#include "forming/study/search/minimum/scalar_search.hpp"
#include "one_dimensional.hpp"
#include "test_folder.hpp"

namespace parison::forming {
namespace {

/// Half a plate of 6 mm in a wide disc whose surface has the temperature of the air: from 600 degC to the switch at one
/// rate, from there to 20 degC at another.
const std::string plate = R"(case = "plate"
geometry = "axisymmetric"
[dimension]
slow = "100 min"
fast = "10 min"
switch = "300 degC"
[material.reference]
density = "2500 kg/m3"
expansion = { cold_density = "2500 kg/m3", solid = "9e-6 1/K", liquid = "32e-6 1/K", transformation = "573 degC" }
heat_capacity = "1100 J/kg/K"
conductivity = "1.3 W/m/K"
viscosity = { law = "vft", A = -27.62366, B = "33093.7 K", T0 = "0.001 K" }
annealing = { young = "70 GPa", poisson = 0.22, frozen_share = 0.5, shear = [[0.05523, 6.658e-5], [0.08205, 1.197e-3],
  [0.1215, 1.514e-2], [0.2286, 0.1672], [0.2860, 0.7497], [0.22662, 3.292]], structure = [[0.05523, 5.965e-4],
  [0.08205, 1.077e-2], [0.1215, 0.1362], [0.2286, 1.505], [0.2860, 6.747], [0.22662, 29.63]] }
[glass]
material = "reference"
temperature = "600 degC"
mesh = { mapped = [8, 6] }
boundary = [
  { name = "middle", path = "(0, 0) (18, 0) mm", condition = "symmetry" },
  { name = "rim", path = "(18, 3) mm", condition = "insulated" },
  { name = "surface", path = "(0, 3) mm", condition = "air" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
[[stage]]
name = "range"
kind = "cooling"
duration = "slow"
air = { temperature = [["0 s", "600 degC"], ["slow", "switch"]], h = "20 kW/m2/K", ambient = "20 degC" }
[[stage]]
name = "below"
kind = "cooling"
duration = "fast"
air = { temperature = [["0 s", "switch"], ["fast", "20 degC"]], h = "20 kW/m2/K", ambient = "20 degC" }
[[stage]]
name = "even_out"
kind = "cooling"
duration = "3 min"
air = { temperature = "20 degC", h = "20 kW/m2/K", ambient = "20 degC" }
)";

constexpr double limit_middle = 0.428, limit_surface = 1.7;  // MPa
const std::string sought = R"(case = "case.toml"
confirm = "none"
runs = 60
goal = { least = "cooling_time" }
limit = [{ quantity = "residual_tension", at_most = "0.428 MPa" }, { quantity = "cooling_tension_surface", at_most = "1.7 MPa" }]
variable = [{ key = "dimension.slow", from = "5 min", to = "200 min", scale = "logarithmic", step = 1.3 },
  { key = "dimension.fast", from = "2 min", to = "100 min", scale = "logarithmic", step = 1.3 },
  { key = "dimension.switch", from = "250 degC", to = "560 degC", step = "30 K" }]
)";

struct Curve {
  double slow, fast, change;  // s, s, K

  double slow_rate() const { return (600 + core::zero_celsius - change) / slow; }
  double fast_rate() const { return (change - core::zero_celsius - 20) / fast; }
  double duration() const { return slow + fast; }
};

/// What a run leaves: what a search sees, and the hoop stress of the middle on the axis, MPa, without the rim.
struct Left {
  Quantities quantities;
  double centre;

  double tension() const { return quantities.find("residual_tension")->value; }
};

class Annealing : public ::testing::Test {
 protected:
  const std::filesystem::path folder = tests::new_folder();

  Left run_with(const std::vector<std::string>& overrides, const std::string& accuracy) const {
    const Scene scene = read_scene((folder / "case.toml").string(), accuracy, overrides);
    const RunOutcome outcome = run(scene);
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    const auto& nodes = outcome.state.glass.mesh.nodes;
    const auto nearer = [](const Point& a, const Point& b) { return a.norm() < b.norm(); };
    const auto centre = std::min_element(nodes.begin(), nodes.end(), nearer) - nodes.begin();
    return {summarise(scene, outcome.state, outcome.facts, thickness_profile(scene, outcome.state), nullptr).quantities,
            1e-6 * nodal_stress(outcome.state.glass)[4 * centre + 2]};
  }
  /// The best place that the search has asked for, as settings.
  std::vector<std::string> search(const Goal& goal) const {
    const auto count = Eigen::Index(goal.variables.size());
    Eigen::VectorXd start(count), low(count), high(count), step(count), best;
    for (Eigen::Index i = 0; i < count; ++i) {
      const SearchVariable& variable = goal.variables[std::size_t(i)];
      start[i] = variable.start, low[i] = variable.low(), high[i] = variable.high(), step[i] = variable.step;
    }
    std::optional<Worth> least;
    const auto ask = [&](const Eigen::VectorXd& at) -> std::optional<ScalarValue> {
      const auto found = worth(goal, {"", run_with(settings_at(goal.variables, at), goal.accuracy).quantities, {}});
      EXPECT_TRUE(found.has_value());
      if (!least || is_better(*found, *least)) least = found, best = at;
      return ScalarValue{found->value, found->excess};
    };
    scalar_search(start, {low, high, step, goal.runs, goal.limits.size()}, ask, [] { return false; });
    return settings_at(goal.variables, best);
  }
};

/// Hoop stress of the middle, MPa, by points through the thickness: with a steady rate its temperatures are a parabola.
double middle_by_points(const Curve& curve, int steps) {
  constexpr double diffusivity = 1.3 / (2500 * 1100), settling = 20;             // m2/s, s
  const double apart = std::pow(cooling::thickness / 2, 2) / (2 * diffusivity);  // K for each K/s
  const double hot = 600 + core::zero_celsius, cold = 20 + core::zero_celsius;
  cooling::History history{{{0}, {hot}}, {{0}, {0}}};
  const auto go = [&](double time, double surface, double rate) {
    history.mean.x.push_back(time);
    history.apart.x.push_back(time);
    history.mean.y.push_back(surface + 2.0 / 3 * apart * rate);
    history.apart.y.push_back(apart * rate);
  };
  const double end = curve.slow + curve.fast, slow = curve.slow_rate(), fast = curve.fast_rate();
  go(settling, hot - settling * slow, slow);
  go(curve.slow, curve.change, slow);
  go(curve.slow + settling, curve.change - settling * fast, fast);
  go(end, cold, fast);
  go(end + settling, cold, 0);
  return cooling::by_points(cooling::reference_law(), history, steps)[0];
}

/// The shortest curve with the fast rate of another and this slow one, K/s, that leaves as much by points.
Curve as_good(const Curve& curve, double slow_rate) {
  constexpr int steps = 4000, halvings = 9;
  const double left = middle_by_points(curve, steps);
  double cold = curve.change - 100, hot = curve.change + 60;  // K
  const auto with = [&](double change) {
    return Curve{(600 + core::zero_celsius - change) / slow_rate,
                 (change - core::zero_celsius - 20) / curve.fast_rate(), change};
  };
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (cold + hot);
    (middle_by_points(with(middle), steps) > left ? hot : cold) = middle;
  }
  return with(cold);
}

TEST_F(Annealing, the_shortest_curve_of_a_plate_is_slow_through_the_range_and_fast_below) {
  core::write_text(folder / "case.toml", plate);
  core::write_text(folder / "goal.toml", sought);
  const Goal goal = read_goal((folder / "goal.toml").string(),
                              [](const std::string& from, const std::string& name) { return from + '/' + name; });
  const std::vector<std::string> found = search(goal);
  const Scene scene = read_scene((folder / "case.toml").string(), "draft", found);
  const Curve curve{scene.stages[0].duration, scene.stages[1].duration, scene.stages[0].air.air_temperature(1e9)};
  // The rate of the surface pulls by 0.427 MPa for each 5 K/min against twice the 0.428 MPa that one of 5 K/min leaves.
  const double bearable = (limit_surface + 2 * 0.428 * 60 * curve.slow_rate() / 5) / 0.427 * 5 / 60;
  tests::expect_at_most("shortest annealing of a plate: fast rate off that which its surface bears",
                        std::abs(curve.fast_rate() / bearable - 1), 0.1);
  tests::expect_at_most("shortest annealing of a plate: its time over that of one rate that leaves the same",
                        curve.duration() / (580.0 / 5 * 60), 0.5);
  tests::Figure sooner("shortest annealing of a plate: by how much one at another slow rate is sooner, by points");
  for (const double rate : {2.5, 3.2, 4.0, 4.8}) {
    const Curve other = as_good(curve, rate / 60);
    sooner.add(1 - other.duration() / curve.duration());
  }
  sooner.at_most(0.03);
  const Left finer = run_with(found, "standard");
  tests::expect_at_most("shortest annealing of a plate at standard: tension off its limit",
                        std::abs(finer.tension() / limit_middle - 1), 0.02);
  const double by_points = 2 * middle_by_points(curve, 16000) - middle_by_points(curve, 8000);
  tests::expect_at_most("shortest annealing of a plate by points: stress of the middle off",
                        std::abs(by_points / finer.centre - 1), 0.01);
}

}  // namespace
}  // namespace parison::forming
