// SPDX-License-Identifier: GPL-3.0-or-later
// Glass in space that remembers its stress: a plate against one dimension, a body that is free, a disc as a round one.
#include <gtest/gtest.h>

#include <cmath>

#include "cooling/cooling_body.hpp"
#include "cooling/one_dimensional.hpp"
#include "core/solid/cell_stacks.hpp"
#include "figure.hpp"
#include "forming/report/wall/solid_wall.hpp"
#include "forming/run/run.hpp"
#include "forming/scene_text.hpp"
#include "forming/solid/solid_memory.hpp"
#include "forming/step/cooling/cooling_step.hpp"
#include "solid/hex_block.hpp"

namespace parison::forming {
namespace {

using core::Vector3;

const flow::Material glass{2500, {}, {}, 0, {}};

/// Those nodes of a mesh that lie on a plane through the origin.
core::SymmetryPlane plane(const core::HexMesh& mesh, const Vector3& normal) {
  core::SymmetryPlane result{normal, {}};
  for (Index n = 0; n < mesh.node_count(); ++n)
    if (std::abs(normal.dot(mesh.nodes[n])) < 1e-12) result.nodes.push_back(n);
  return result;
}

/// A body that three planes of symmetry hold, with temperatures that are given.
struct Body {
  cooling::GlassLaw law;
  SolidState solid;
  flow::SolidProblem problem;
  std::unique_ptr<flow::FlowMatrix> matrix;

  Body(cooling::GlassLaw its_law, core::HexMesh mesh, const std::vector<Vector3>& normals, double start)
      : law(std::move(its_law)) {
    problem.material = &glass;
    for (const Vector3& normal : normals) problem.planes.push_back(plane(mesh, normal));
    matrix = std::make_unique<flow::FlowMatrix>(mesh, problem.planes, problem.fixed);
    solid.glass.temperature = Eigen::VectorXd::Constant(mesh.node_count(), start);
    solid.glass.mesh = std::move(mesh);
    solid.stacks = core::cell_stacks(solid.glass.mesh);
    solid.glass.cell_mass = Eigen::VectorXd::Ones(solid.glass.mesh.cell_count());
    begin_cooling(solid);
  }
  Body(const Body&) = delete;

  void step(const Eigen::VectorXd& next, double dt) {
    const Eigen::VectorXd before = std::exchange(solid.glass.temperature, next);
    const SolidMemoryStep memory = start_memory_step(law, solid, before, dt);
    problem.memory = &memory.flow;
    ASSERT_TRUE(flow::step_cooling(problem, *matrix, solid.glass, dt).accepted);
    end_memory_step(memory, solid.glass.mesh, dt, solid);
  }
  /// At the node nearest to a place, MPa.
  double stress(const Vector3& at, int entry) const {
    Index nearest = 0;
    for (Index n = 0; n < solid.glass.mesh.node_count(); ++n)
      if ((solid.glass.mesh.nodes[n] - at).norm() < (solid.glass.mesh.nodes[nearest] - at).norm()) nearest = n;
    return 1e-6 * nodal_stress(solid)(entry, nearest);
  }
};

const std::vector<Vector3> three_planes{Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};

TEST(SolidCooling, a_plate_has_the_stress_of_a_one_dimensional_solution) {
  using cooling::kelvin, cooling::thickness;
  const cooling::History history{{{0, 60, 120, 220}, {kelvin + 650, kelvin + 500, kelvin + 300, kelvin + 20}},
                                 {{0, 60, 120, 220}, {0, 35, 15, 0}}};
  const cooling::GlassLaw law = cooling::reference_law();
  const auto coarse = cooling::by_points(law, history, 4000), fine = cooling::by_points(law, history, 8000);
  for (const auto& [layers, allowed] : {std::pair{2, 2e-2}, {4, 4e-3}}) {
    tests::Figure off(
        fmt::format("plate in space, {} layers through half of it: stress off by, of the largest", layers));
    const double half = thickness / 2;
    Body body(law,
              tests::hex_block(6, 6, layers,
                               [&](const Vector3& at) {
                                 return Vector3(3 * thickness * at[0], 3 * thickness * at[1], half * at[2]);
                               }),
              three_planes, history.at(0, 0));
    const Eigen::VectorXd height = [&] {
      Eigen::VectorXd all(body.solid.glass.mesh.node_count());
      for (Index n = 0; n < all.size(); ++n) all[n] = body.solid.glass.mesh.nodes[n][2] / half;
      return all;
    }();
    const auto at = [&](double time) { return height.unaryExpr([&](double z) { return history.at(time, z); }).eval(); };
    constexpr double change = 2.5;  // K
    for (std::size_t part = 1; part < history.mean.x.size(); ++part) {
      const double from = history.mean.x[part - 1], seconds = history.mean.x[part] - from;
      const double longest = seconds * change / (at(from + seconds) - at(from)).lpNorm<Eigen::Infinity>();
      double time = 0;
      for (double dt = 1e-3 * seconds; time < seconds; dt = std::min(1.5 * dt, longest)) {
        const double next = seconds - time < 1.5 * dt ? seconds : time + dt;
        body.step(at(from + next), next - time);
        time = next;
      }
    }
    const std::array<double, 2> found{body.stress({0, 0, 0}, 0), body.stress({0, 0, half}, 0)};
    std::printf("%d layers: middle %.4f, surface %.4f MPa; one dimension %.4f, %.4f\n", layers, found[0], found[1],
                2 * fine[0] - coarse[0], 2 * fine[1] - coarse[1]);
    for (std::size_t i = 0; i < 2; ++i) off.add(std::abs(found[i] - (2 * fine[i] - coarse[i])) / fine[2]);
    off.at_most(allowed);
  }
}

/// A bent, twisted bar that cools evenly is free of stress and shrinks as its expansion says; turned about the axis it
/// stays so.
TEST(SolidCooling, a_free_body_shrinks_without_stress) {
  const auto bent = [](const Vector3& at) {
    const double angle = 0.6 * at[2] * at[2];
    const Vector3 x(0.02 * at[0], 0.01 * at[1] * (1 + at[2] * at[2]), 0.03 * at[2]);
    return Vector3(x[0] * std::cos(angle) * (1 + at[2]), x[1] * std::cos(angle), x[2] * std::cos(0.3 * at[0] * at[0]));
  };
  cooling::GlassLaw law = cooling::reference_law(false);
  Body body(law, tests::hex_block(2, 2, 3, bent), three_planes, 900);
  const double before = core::cell_volumes(body.solid.glass.mesh).sum();
  for (double to = 850; to > 299; to -= 50)
    body.step(Eigen::VectorXd::Constant(body.solid.glass.temperature.size(), to), 10);
  const double strain = law.solid_expansion * 600, now = core::cell_volumes(body.solid.glass.mesh).sum();
  EXPECT_NEAR(std::cbrt(now / before), 1 - strain, strain * strain);
  EXPECT_LT(nodal_stress(body.solid).cwiseAbs().maxCoeff(), 1e-3 * law.young * strain * strain);
}

const std::string disc = std::string("case = \"disc\"\ngeometry = \"axisymmetric\"\n") + R"([glass]
material = "flint"
temperature = "700 degC"
boundary = [
  { name = "surface", path = "(0, 0) (20, 0) (20, 8) (0, 8) mm", condition = "contact" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]
[[tool]]
name = "plate"
material = "grey_iron"
temperature = "450 degC"
friction = "slip"
boundary = [
  { name = "top", path = "(40, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -10) mm", condition = "symmetry" },
  { name = "rest", path = "(40, -10) (40, 0) mm", condition = "insulated" },
]
[[interface]]
tools = ["plate"]
law = "constant"
h = "300 W/m2/K"
[[stage]]
name = "rest"
duration = "50 ms"
air = { temperature = "20 degC", h = "60 W/m2/K", ambient = "20 degC" }
gravity = "-9.81 m/s2"
tools = ["plate"]
[[stage]]
name = "cool"
kind = "cooling"
duration = "400 s"
gravity = "-9.81 m/s2"
tools = ["plate"]
air = { temperature = "20 degC", h = "60 W/m2/K", ambient = "20 degC" }
)";

/// At the end: volume, m3, and the stress, MPa, around the axis in the middle of the disc and where it is free.
struct Cold {
  double volume, middle, top;
};

Cold cooled(const std::string& text) {
  Scene scene = scene_of(text, "draft coarser 2");
  scene.accuracy.elements_across = 6;
  const RunOutcome outcome = run(scene);
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  const auto nearest = [](const auto& nodes, const auto& at) {
    const auto closer = [&](const auto& a, const auto& b) { return (a - at).norm() < (b - at).norm(); };
    return std::min_element(nodes.begin(), nodes.end(), closer) - nodes.begin();
  };
  constexpr double half = 4e-3;
  if (outcome.solid) {
    const auto& nodes = outcome.solid->glass.mesh.nodes;
    const NodalTensors stress = 1e-6 * nodal_stress(*outcome.solid);
    return {whole_volume(*outcome.solid), stress(0, nearest(nodes, Vector3(0, 0, half))),
            stress(0, nearest(nodes, Vector3(0, 0, 2 * half)))};
  }
  const core::Mesh& mesh = outcome.state.glass.mesh;
  const Eigen::VectorXd stress = 1e-6 * nodal_stress(outcome.state.glass);
  constexpr Index components = 4, hoop = 2;
  return {core::volume(mesh, scene.geometry), stress[components * nearest(mesh.nodes, core::Point(0, half)) + hoop],
          stress[components * nearest(mesh.nodes, core::Point(0, 2 * half)) + hoop]};
}

TEST(SolidCooling, a_disc_on_a_plate_cools_as_a_round_one) {
  const Cold round = cooled(disc),
             solid = cooled(replaced("name = \"cool\"\n", "name = \"cool\"\nsolid = { sector = \"90 deg\" }\n", disc));
  for (const Cold* one : {&round, &solid})
    std::printf("%s: %.6g mm3, middle %.3f, top %.3f MPa\n", one == &round ? "round" : "in space", 1e9 * one->volume,
                one->middle, one->top);
  EXPECT_NEAR(solid.volume, round.volume, 3e-4 * round.volume);
  const double most = std::max(std::abs(round.middle), std::abs(round.top));
  EXPECT_NEAR(solid.middle, round.middle, 0.05 * most);
  EXPECT_NEAR(solid.top, round.top, 0.05 * most);
}

}  // namespace
}  // namespace parison::forming
