// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <random>

#include "contact/mortar/box_tree.hpp"
#include "figure.hpp"
#include "interface_cases.hpp"

namespace parison::contact::testing {
namespace {

std::vector<Box> random_boxes(int count, double size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Box> boxes;
  for (int i = 0; i < count; ++i) {
    const Point low(place(random), place(random));
    boxes.push_back({low, low + size * Point(place(random), place(random))});
  }
  return boxes;
}

TEST(BoxTree, finds_just_the_overlapping_boxes) {
  const auto boxes = random_boxes(700, 0.05);
  const BoxTree tree(boxes);
  for (const auto& box : random_boxes(60, 0.2)) {
    std::vector<Index> found, expected;
    tree.query(box, found);
    for (Index i = 0; i < 700; ++i)
      if (overlap(boxes[i], box)) expected.push_back(i);
    EXPECT_EQ(found, expected);
  }
  std::vector<Index> none;
  EXPECT_EQ(BoxTree({}).query(boxes[0], none), 0);
}

double boxes_looked_at_per_edge(int count) {
  std::vector<Box> chain;
  for (int i = 0; i < count; ++i) {
    const double a = 3.0 * i / count, b = 3.0 * (i + 1) / count;
    const Point p(std::cos(a), std::sin(a)), q(std::cos(b), std::sin(b));
    chain.push_back({p.cwiseMin(q), p.cwiseMax(q)});
  }
  const BoxTree tree(chain);
  double sum = 0;
  std::vector<Index> found;
  for (const auto& box : chain) sum += tree.query(box, found);
  return sum / count;
}

TEST(BoxTree, work_per_edge_of_a_chain_grows_with_the_logarithm_only) {
  const double few = boxes_looked_at_per_edge(500), many = boxes_looked_at_per_edge(32000);
  std::printf("boxes looked at per edge: %.1f of 500, %.1f of 32000\n", few, many);
  EXPECT_LT(many, few + 2.5 * std::log2(32000.0 / 500));
}

TEST(BoxTree, an_interface_of_a_thousand_edges_a_side_is_exact_and_quick) {
  const auto slave = glass(divided(0, 0.2, 1000)), master = tool(divided(0, 0.2, 999));
  const auto slave_surface = contact_surface(0, slave), master_surface = contact_surface(1, master);
  const auto state = touching(slave);
  const auto start = std::chrono::steady_clock::now();
  const auto points = build_interface(slave_surface, master_surface, state, {core::Geometry::planar, width, 0});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("1000 x 999 edges, %zu points: %.1f ms\n", points.size(), 1e3 * seconds);
  tests::expect_at_most("interface of 1000 by 999 edges: area off by",
                        std::abs(weighted_contact_area(points) / 0.2 - 1), 5e-12);
  EXPECT_LT(seconds, 2);
}

}  // namespace
}  // namespace parison::contact::testing
