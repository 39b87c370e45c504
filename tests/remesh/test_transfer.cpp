// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "core/mesh/element.hpp"
#include "figure.hpp"
#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/mesher/quality.hpp"
#include "remesh/profiles.hpp"
#include "remesh/remesh_glass.hpp"
#include "remesh/transfer/transfer.hpp"

namespace parison::remesh {
namespace {

using core::Geometry;
using core::Index;
using core::Mesh;
using core::Point;
using Field = std::function<double(const Point&)>;

Mesh gob_mesh(double size) {
  return mesh_profile(gob(), {size, size, 0.3, {false, false}});
}

Mesh again(const Mesh& mesh, double size) {
  const Criteria criteria{Geometry::axisymmetric, size, 1e-4, 2, 0.3, 5e-5, {false, true}, {}, {}, {}};
  Remeshed made = remesh_glass(mesh, criteria);
  EXPECT_TRUE(made.ok) << made.reason;
  return std::move(made.mesh);
}

Eigen::VectorXd sample(const Mesh& mesh, const Field& field) {
  Eigen::VectorXd nodal(mesh.node_count());
  for (Index i = 0; i < mesh.node_count(); ++i) nodal[i] = field(mesh.nodes[i]);
  return nodal;
}

double error_l2(const Mesh& mesh, const Eigen::VectorXd& nodal, const Field& field) {
  double sum = 0, volume = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const auto& at : core::triangle_rule(6)) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, Geometry::axisymmetric, at);
      double value = -field(point.position);
      for (int k = 0; k < 6; ++k) value += point.shape[k] * nodal[mesh.cells()[cell][k]];
      sum += value * value * point.volume;
      volume += point.volume;
    }
  return std::sqrt(sum / volume);
}

/// Core and skin of a gob, with its hottest and coldest points inside.
double smooth(const Point& x) {
  return 1300 + 80 * std::cos(160 * x[0]) * std::sin(140 * x[1]);
}

/// A skin about 1 mm deep under the surface.
double skin(const Point& x) {
  return 900 + 520 * (1 - std::exp(-core::distance(gob(), x) / 1e-3));
}

TEST(Transfer, quadratic_fields_are_carried_over_exactly) {
  const Mesh from = gob_mesh(3e-3), to = again(from, 2.3e-3);
  const Field quadratic = [](const Point& x) {
    return 1000 + 3e3 * x[0] - 2e3 * x[1] + 5e4 * x[0] * x[1] + 4e4 * x[0] * x[0];
  };
  const Transfer transfer = make_transfer(from, to);
  const Eigen::VectorXd carried = interpolate(from, transfer, sample(from, quadratic)), exact = sample(to, quadratic);
  double inner = 0, all = 0;
  for (Index i = 0; i < to.node_count(); ++i) {
    const double error = std::abs(carried[i] - exact[i]);
    all = std::max(all, error);
    if (core::distance(gob(), to.nodes[i]) > 4e-3) inner = std::max(inner, error);
  }
  EXPECT_LT(inner, 1e-9);
  EXPECT_LT(all, 0.05);  // curved cells are not exactly quadratic
}

TEST(Transfer, every_new_node_is_found_where_it_is) {
  const Mesh from = gob_mesh(3e-3), to = again(from, 1.7e-3);
  const Transfer transfer = make_transfer(from, to);
  double worst = 0;
  for (Index i = 0; i < to.node_count(); ++i) {
    const auto shape = core::triangle_shape(transfer.at[i][0], transfer.at[i][1]);
    Point reached = Point::Zero();
    for (int k = 0; k < 6; ++k) reached += shape[k] * from.nodes[from.cells()[transfer.cell[i]][k]];
    worst = std::max(worst, (reached - to.nodes[i]).norm());
  }
  std::printf("farthest new node from the old body: %.2e mm\n", 1e3 * worst);
  EXPECT_LT(worst, 2e-6);  // only the shift that restores the volume
}

TEST(Transfer, heat_is_kept_and_no_extreme_is_new) {
  const Mesh from = gob_mesh(2.5e-3), to = again(from, 2e-3);
  for (const Field& field : {Field(smooth), Field(skin)}) {
    const Eigen::VectorXd old = sample(from, field);
    const Transfer transfer = make_transfer(from, to);
    const double raw = mean(to, Geometry::axisymmetric, interpolate(from, transfer, old));
    const Eigen::VectorXd carried = transfer_conserving(from, to, Geometry::axisymmetric, transfer, old);
    const double before = mean(from, Geometry::axisymmetric, old);
    const double after = mean(to, Geometry::axisymmetric, carried);
    std::printf("heat: interpolation alone is off by %.1e, kept to %.1e\n", raw / before - 1, after / before - 1);
    EXPECT_GT(std::abs(raw / before - 1), 1e-12);
    EXPECT_NEAR(after / before, 1, 1e-13);
    EXPECT_LE(carried.maxCoeff(), old.maxCoeff());
    EXPECT_GE(carried.minCoeff(), old.minCoeff());
  }
}

TEST(Transfer, any_content_is_kept_within_the_old_extremes_where_a_common_shift_would_leave_them) {
  const Mesh from = gob_mesh(2.5e-3), to = again(from, 2e-3);
  const Field thin = [](const Point& x) { return 900 + 520 * (1 - std::exp(-core::distance(gob(), x) / 0.1e-3)); };
  const Eigen::VectorXd old = sample(from, thin);
  const Content squares = [&](const Eigen::VectorXd& field) {
    return mean(to, Geometry::axisymmetric, field.cwiseAbs2());
  };
  const Carried carried = project(from, to, Geometry::axisymmetric, make_transfer(from, to), old);
  const double now = squares(carried.value);
  const double shift = 0.5e-4 * now / mean(to, Geometry::axisymmetric, carried.value);  // of all, to have 1e-4 more
  EXPECT_GT(carried.value.maxCoeff() + shift, old.maxCoeff() + 1e-3);
  const double room = old.maxCoeff() * old.maxCoeff() - now;
  for (const double wanted : {now * (1 + 1e-4), now * (1 - 1e-4), now + 0.9 * room}) {
    const Eigen::VectorXd field = restore_content(carried, squares, wanted);
    EXPECT_NEAR(squares(field) / wanted, 1, 1e-12);
    EXPECT_LE(field.maxCoeff(), old.maxCoeff() + 1e-9);
    EXPECT_GE(field.minCoeff(), old.minCoeff() - 1e-9);
  }
}

TEST(Transfer, a_uniform_field_stays_uniform) {
  const Mesh from = gob_mesh(3e-3), to = again(from, 2e-3);
  const Eigen::VectorXd old = Eigen::VectorXd::Constant(from.node_count(), 1423.15);
  const Eigen::VectorXd carried = transfer_conserving(from, to, Geometry::axisymmetric, make_transfer(from, to), old);
  EXPECT_LT((carried.array() - 1423.15).abs().maxCoeff(), 1e-9);
  EXPECT_LE(carried.maxCoeff(), 1423.15);
}

TEST(Transfer, a_linear_temperature_is_carried_over_exactly_where_cells_are_straight) {
  const Mesh from = gob_mesh(3e-3), to = again(from, 2.3e-3);
  const Field linear = [](const Point& x) { return 1000 + 3e3 * x[0] - 2e3 * x[1]; };
  const Eigen::VectorXd carried =
      transfer_conserving(from, to, Geometry::axisymmetric, make_transfer(from, to), sample(from, linear));
  double inner = 0;
  for (Index i = 0; i < to.node_count(); ++i)
    if (core::distance(gob(), to.nodes[i]) > 8e-3) inner = std::max(inner, std::abs(carried[i] - linear(to.nodes[i])));
  EXPECT_LT(inner, 0.02);
}

void carry_hundred_times(const Field& field, const char* name) {
  Mesh mesh = again(gob_mesh(1.3e-3), 1.3e-3);
  Eigen::VectorXd carried = sample(mesh, field);
  const double once = error_l2(mesh, carried, field), start = mean(mesh, Geometry::axisymmetric, carried);
  for (int pass = 0; pass < 100; ++pass) {
    const Mesh next = again(mesh, pass % 2 ? 1.3e-3 : 1.26e-3);
    carried = transfer_conserving(mesh, next, Geometry::axisymmetric, make_transfer(mesh, next), carried);
    mesh = next;
    if (pass == 0 || pass == 9 || pass == 99)
      std::printf("%s after %3d remeshes: L2 error %.3f times one interpolation (%.2e K)\n", name, pass + 1,
                  error_l2(mesh, carried, field) / once, once);
  }
  const std::string what = fmt::format("100 remeshes of a {}: ", name);
  tests::expect_at_most(what + "error over that of one interpolation", error_l2(mesh, carried, field) / once, 3);
  tests::expect_at_most(what + "heat changed by", std::abs(mean(mesh, Geometry::axisymmetric, carried) / start - 1),
                        1e-12);
}

TEST(Transfer, a_smooth_field_survives_a_hundred_remeshes) {
  carry_hundred_times(smooth, "smooth field");
}

TEST(Transfer, a_thermal_skin_survives_a_hundred_remeshes) {
  carry_hundred_times(skin, "thermal skin");
}

TEST(Transfer, glass_that_lies_on_itself_twice_keeps_its_temperatures) {
  // A slotted plate whose slot has closed: its sides overlap by 0.3 mm, over which two old cells lie on each other.
  const auto slotted = [](double lower, double upper) {
    return Pen(0, 0)
        .line(30, 0, "below")
        .line(30, lower, "right")
        .line(10, 5, "side")
        .line(30, upper, "side")
        .line(30, 10, "right")
        .line(0, 10, "above")
        .line(0, 0, "left")
        .closed();
  };
  Mesh from = mesh_profile(slotted(4, 6), {1e-3, 1e-3, 0.3, std::vector<bool>(6, false)});
  for (Point& x : from.nodes)
    if (x[0] > 10e-3) {
      const double share = (x[0] - 10e-3) / 20e-3, middle = 5e-3;
      x[1] += 1.3e-3 * share * std::max(0.0, 1 - std::abs(x[1] - middle) / 5e-3) * (x[1] < middle ? 1 : -1);
    }
  const core::Profile whole =
      Pen(0, 0).line(30, 0, "below").line(30, 10, "right").line(0, 10, "above").line(0, 0, "left").closed();
  const Mesh to = mesh_profile(whole, {0.9e-3, 0.9e-3, 0.3, std::vector<bool>(4, false)});
  const auto linear = [](const Point& x) { return 1200 + 2000 * x[1]; };
  const Eigen::VectorXd old = sample(from, linear);
  const Carried carried = project(from, to, Geometry::planar, make_transfer(from, to), old);
  const Eigen::VectorXd exact = sample(to, linear);
  EXPECT_LT((carried.value - exact).cwiseAbs().maxCoeff(), 1.0) << "of 20 K";
}

/// A plate of 10 mm by 20 mm in eight cells, four around each of two vertices inside. The edge across its middle bends
/// down by `bend`, m, and the two above it by a third of that.
Mesh eight_cells(double upper, double lower, double bend) {
  Mesh mesh;
  mesh.nodes = {{0, 0},          {10e-3, 0},  {10e-3, 10e-3}, {0, 10e-3},
                {10e-3, -10e-3}, {0, -10e-3}, {5e-3, upper},  {5e-3, lower}};
  mesh.edit().vertex_count = 8;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), mesh.node_count());
    const double below = std::max(a, b) == 1 ? bend : std::max(a, b) == 6 && std::min(a, b) < 2 ? bend / 3 : 0;
    if (is_new) mesh.nodes.push_back(0.5 * (mesh.nodes[a] + mesh.nodes[b]) - Point(0, below));
    return place->second;
  };
  for (const auto& [a, b, c] :
       {std::array{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {3, 0, 6}, {5, 4, 7}, {4, 1, 7}, {1, 0, 7}, {0, 5, 7}})
    mesh.edit().cells.push_back({a, b, c, middle(a, b), middle(b, c), middle(c, a)});
  mesh.edit().boundaries = {{"side", core::BoundaryKind::contact}};
  for (const auto& [a, b, cell] : {std::array{1, 2, 1}, {2, 3, 2}, {3, 0, 3}, {0, 5, 7}, {5, 4, 4}, {4, 1, 5}})
    mesh.edit().boundary_edges.push_back({{a, b, middle(a, b)}, cell, 0});
  return mesh;
}

TEST(Transfer, a_cell_whose_corners_alone_would_be_inverted_counts_once) {
  const Mesh from = eight_cells(-0.2e-3, -6e-3, 2.4e-3), to = eight_cells(4e-3, -4e-3, 0);
  ASSERT_GT(min_quality(from), 0);
  const Field linear = [](const Point& x) { return 1200 + 3e3 * x[0] - 2e3 * x[1]; };
  const Carried carried = project(from, to, Geometry::planar, make_transfer(from, to), sample(from, linear));
  EXPECT_LT((carried.value - sample(to, linear)).lpNorm<Eigen::Infinity>(), 6) << "of 70 K";
}

}  // namespace
}  // namespace parison::remesh
