// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "core/mesh/element.hpp"
#include "forming/remeshing/surface_transfer.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {
namespace {

/// Two meshes of the glass of the pot, a square section, whose surface nodes do not match.
class SurfaceTransferTest : public ::testing::Test {
 protected:
  core::Mesh coarse = mesh_with("surface_size = \"1.7 mm\"\n"), fine = mesh_with("surface_size = \"0.9 mm\"\n");

  static core::Mesh mesh_with(const std::string& numerics) {
    return initial_state(scene_of(pot + numerics)).glass.mesh;
  }
  static Eigen::VectorXd sampled(const core::Mesh& mesh, const std::function<double(const core::Point&)>& f) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(mesh.node_count());
    for (const Index node : contact_nodes(mesh)) values[node] = f(mesh.nodes[node]);
    return values;
  }
  static Eigen::VectorXd carried(const core::Mesh& from, const core::Mesh& to, const Eigen::VectorXd& field) {
    return SurfaceTransfer(from, to, core::Geometry::axisymmetric).project(field);
  }
  /// Integral along the surface of a field that stays within the range of its nodes along each edge.
  static double integral(const core::Mesh& mesh, const Eigen::VectorXd& field) {
    constexpr int parts = 50;
    double sum = 0;
    for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
      if (mesh.kind_of(edge) != BoundaryKind::contact) continue;
      const Eigen::Vector3d nodal(field[edge.nodes[0]], field[edge.nodes[1]], field[edge.nodes[2]]);
      for (int part = 0; part < parts; ++part) {
        const auto point =
            core::map_edge_point(mesh, edge.nodes, core::Geometry::axisymmetric, {(part + 0.5) / parts, 1.0 / parts});
        const double value = Eigen::Map<const Eigen::Vector3d>(point.shape.data()).dot(nodal);
        sum += point.area * std::clamp(value, nodal.minCoeff(), nodal.maxCoeff());
      }
    }
    return sum;
  }
};

TEST_F(SurfaceTransferTest, a_quadratic_field_is_the_same_on_either_mesh) {
  ASSERT_NE(contact_nodes(coarse).size(), contact_nodes(fine).size());
  const auto field = [](const core::Point& x) { return 3 + 100 * x[0] - 5e3 * x[1] * x[1]; };
  for (const auto& [from, to] : {std::pair(&coarse, &fine), std::pair(&fine, &coarse)})
    EXPECT_LT((carried(*from, *to, sampled(*from, field)) - sampled(*to, field)).cwiseAbs().maxCoeff(), 1e-10);
}

TEST_F(SurfaceTransferTest, an_opening_is_that_of_the_nearest_old_point) {
  const auto opening = [](const core::Point& x) { return 1e-5 * std::max(0.0, x[0] - 0.004); };
  const Eigen::VectorXd old = sampled(fine, opening);
  const Eigen::VectorXd now = SurfaceTransfer(fine, coarse, core::Geometry::axisymmetric).interpolate(old);
  EXPECT_LT((now - sampled(coarse, opening)).cwiseAbs().maxCoeff(), 1e-9);  // 0.1 mm of the kink
  EXPECT_EQ(now.minCoeff(), 0);
}

TEST_F(SurfaceTransferTest, the_front_of_a_pressure_keeps_its_force_and_range) {
  double worst = 0, worst_at_nodes = 0;
  for (double front = 0.003; front < 0.008; front += 3.1e-4) {
    const auto pressure = [front](const core::Point& x) { return 1e5 * std::max(0.0, 1 - x[0] / front); };
    const Eigen::VectorXd old = sampled(fine, pressure), now = carried(fine, coarse, old);
    EXPECT_GE(now.minCoeff(), 0);
    EXPECT_LE(now.maxCoeff(), old.maxCoeff());
    const double force = integral(fine, old);
    worst = std::max(worst, std::abs(integral(coarse, now) / force - 1));
    worst_at_nodes = std::max(worst_at_nodes, std::abs(integral(coarse, sampled(coarse, pressure)) / force - 1));
  }
  EXPECT_LT(worst, 0.3 * worst_at_nodes);
  EXPECT_LT(worst, 2e-3);
}

TEST_F(SurfaceTransferTest, glass_that_touches_nothing_carries_zeros) {
  core::Mesh free = fine;
  for (auto& boundary : free.edit().boundaries) boundary.kind = BoundaryKind::air;
  EXPECT_EQ(carried(free, free, Eigen::VectorXd::Ones(free.node_count())).cwiseAbs().maxCoeff(), 0);
}

}  // namespace
}  // namespace parison::forming
