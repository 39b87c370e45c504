// SPDX-License-Identifier: GPL-3.0-or-later
// The batched kernel of quadratic cells, its map and inverse, and the search in uniform grids.
#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/cell_batch.hpp"
#include "core/mesh/cell_map.hpp"
#include "core/mesh/uniform_grid.hpp"

namespace parison::core {
namespace {

/// Curved cells around the axis' neighbourhood; their number is not a multiple of the batch size.
Mesh curved_mesh() {
  std::vector<Point> x;
  std::vector<std::array<Index, 3>> cells;
  for (Index j = 0; j < 4; ++j)
    for (Index i = 0; i < 4; ++i)
      x.push_back({0.1 + 0.1 * i + 0.013 * std::sin(5 * j), 0.1 * j + 0.011 * std::cos(3 * i)});
  for (Index j = 0; j < 3; ++j)
    for (Index i = 0; i < 3; ++i) {
      const Index a = 4 * j + i;
      cells.push_back({a, a + 1, a + 5});
      cells.push_back({a, a + 5, a + 4});
    }
  Mesh mesh = make_quadratic_mesh(x, cells);
  for (Index i = mesh.vertex_count(); i < mesh.node_count(); ++i)
    mesh.nodes[i] += 0.01 * Point(std::sin(7 * i), std::cos(11 * i));
  return mesh;
}

TEST(CellBatch, each_lane_has_the_bits_of_the_single_cell) {
  const Mesh mesh = curved_mesh();
  ASSERT_NE(mesh.cell_count() % batch_size, 0);
  const Depth depth(Geometry::axisymmetric);
  const auto& rule = triangle_rule(4);
  for (Index batch = 0; batch < batch_count(mesh.cell_count()); ++batch) {
    BatchIndices<6> nodes;
    set_nodes(mesh.cells(), batch, nodes);
    NodeVectors x;
    gather(mesh.nodes.front().data(), nodes, x);
    for (int q = 0; q < cell_points; ++q) {
      MappedPoint<VectorizedArray> at;
      VectorizedArray depth_there;
      std::array<std::array<VectorizedArray, dim>, 6> gradient;
      map_point(cell_shapes<6>(), q, x, at);
      set_gradients(cell_shapes<6>(), q, at, gradient);
      depth.set(at.position[0], depth_there);
      for (int lane = 0; lane < batch_size; ++lane) {
        const Index cell = cell_in_lane(mesh.cell_count(), batch, lane);
        const CellPoint single = map_cell_point(mesh, cell, Geometry::axisymmetric, rule[q]);
        EXPECT_EQ(rule[q].weight * at.determinant[lane] * depth_there[lane], single.volume);
        for (int a = 0; a < dim; ++a) {
          EXPECT_EQ(at.position[a][lane], single.position[a]);
          for (int i = 0; i < 6; ++i) EXPECT_EQ(gradient[i][a][lane], single.gradient[i][a]);
        }
      }
    }
  }
}

TEST(CellBatch, gradients_are_those_of_the_shape_functions_in_space) {
  const Mesh mesh = curved_mesh();
  const double e = 1e-6;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const CellPoint point = map_cell_point(mesh, cell, Geometry::planar, {0.3, 0.4, 1});
    const auto shape_at = [&](const Point& x, int i) {
      const auto at = invert_cell_map(mesh, cell, x);
      return triangle_shape(at[0], at[1])[i];
    };
    for (int a = 0; a < dim; ++a)
      for (int i = 0; i < 6; ++i) {
        const Point step = e * Point::Unit(a);
        const double slope = (shape_at(point.position + step, i) - shape_at(point.position - step, i)) / (2 * e);
        EXPECT_NEAR(point.gradient[i][a], slope, 1e-6 * (1 + std::abs(slope)));
      }
  }
}

TEST(CellBatch, integrate_is_the_transpose_of_interpolate) {
  UnknownValues<6> x, sum{};
  PointValues values, at;
  for (int i = 0; i < 6; ++i) {
    x[i] = VectorizedArray{1.0 + i, 2.0 - i, 0.3 * i, -1.0};
    values[i] = VectorizedArray{0.5 * i, 1.0, -2.0 + i, 3.0};
  }
  for (const auto* shape : {&cell_shapes<6>().value, &cell_shapes<6>().derivative_a, &cell_shapes<6>().derivative_b}) {
    interpolate(*shape, x, at);
    sum = {};
    integrate(*shape, values, sum);
    VectorizedArray left{}, right{};
    for (int i = 0; i < 6; ++i) left += values[i] * at[i], right += sum[i] * x[i];
    for (int lane = 0; lane < batch_size; ++lane) EXPECT_NEAR(left[lane], right[lane], 1e-12) << lane;
  }
}

TEST(CellBatch, scatter_adds_the_filled_lanes_and_no_other) {
  const Mesh mesh = curved_mesh();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.node_count()), expected = sum;
  for (const auto& cell : mesh.cells())
    for (const Index node : cell) expected[node] += 1;
  for (Index batch = 0; batch < batch_count(mesh.cell_count()); ++batch) {
    BatchIndices<6> nodes;
    set_nodes(mesh.cells(), batch, nodes);
    UnknownValues<6> ones;
    ones.fill(VectorizedArray{1, 1, 1, 1});
    scatter(ones, nodes, filled_lanes(mesh.cell_count(), batch), sum.data());
  }
  EXPECT_EQ(sum, expected);
}

TEST(CellMap, eight_points_at_once_are_inverted_as_one_is) {
  const Mesh mesh = curved_mesh();
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    PointBatches x, reference;
    const auto a = [](int i) { return 0.05 + 0.08 * i; };
    for (int i = 0; i < point_batches * batch_size; ++i)
      for (int d = 0; d < dim; ++d)
        x[i / batch_size][d][i % batch_size] = map_cell_point(mesh, cell, Geometry::planar, {a(i), 0.3, 1}).position[d];
    const CellMap map = cell_map(mesh, cell);
    invert(map, x, reference);
    for (int i = 0; i < point_batches * batch_size; ++i) {
      const auto& [at_a, at_b] = reference[i / batch_size];
      const int lane = i % batch_size;
      EXPECT_NEAR(at_a[lane], a(i), 1e-12);
      EXPECT_NEAR(at_b[lane], 0.3, 1e-12);
      const auto& [r, z] = x[i / batch_size];
      const auto single = invert(map, Point(r[lane], z[lane]));
      EXPECT_NEAR(at_a[lane], single[0], 1e-13);
      EXPECT_NEAR(at_b[lane], single[1], 1e-13);
    }
  }
}

TEST(UniformGrid, boxes_are_found_as_by_looking_at_all) {
  const Mesh mesh = curved_mesh();
  std::vector<Box> boxes;
  for (const auto& cell : mesh.cells()) boxes.push_back(bounding_box(mesh, cell, 0.1));
  for (const double size : {0.02, 0.1, 1.0}) {
    const BoxGrid grid({bounding_box(mesh.nodes), size}, boxes);
    for (const Point& x : mesh.nodes) {
      const Box box{x - Point(0.03, 0.01), x + Point(0.05, 0.02)};
      std::vector<Index> found, expected;
      grid.find(box, found);
      for (Index i = 0; i < mesh.cell_count(); ++i)
        if (boxes[i].meets(box)) expected.push_back(i);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected);
    }
  }
}

}  // namespace
}  // namespace parison::core
