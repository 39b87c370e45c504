// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/mortar/contact_end.hpp"
#include "figure.hpp"
#include "interface_cases.hpp"

namespace parison::contact::testing {
namespace {

using tests::Figure;

constexpr double radius = 0.1, transition = 1e-5;  // m
constexpr int edges = 8;
constexpr double surface_length = 0.012, edge_length = surface_length / edges;  // m

/// The gap of glass that leaves a tool at x = `end` by a power of the distance: as a radius an edge behind the end.
struct Front {
  double end, power = 2;
};
constexpr double powers[] = {1.5, 1.7, 2};

/// Glass that lies on y = 0 from x = 0 to the front, as its vertices see it: those on the edge at the end of the
/// contact are on a chord. To the left instead where `mirrored`.
struct LandedGlass {
  core::Mesh mesh;
  SlaveState state;
  std::vector<bool> held;
};

double height(double x, const Front& front) {
  constexpr double at_edge = edge_length * edge_length / (2 * radius);
  return x > front.end ? at_edge * std::pow((x - front.end) / edge_length, front.power) : 0;
}

LandedGlass landed(const Front& front, bool mirrored) {
  const double side = mirrored ? -1 : 1;
  const auto columns = mirrored ? divided(-surface_length, 0, edges) : divided(0, surface_length, edges);
  LandedGlass glass{warped(testing::glass(columns),
                           [&](const Point& x) { return Point(x[0], x[1] == 0 ? height(side * x[0], front) : x[1]); }),
                    {},
                    {}};
  auto& nodes = glass.mesh.nodes;
  for (const auto& edge : glass.mesh.boundary_edges()) {
    const double first = nodes[edge.nodes[0]][1], last = nodes[edge.nodes[1]][1];
    if (edge.boundary_id == 1 && (first == 0) != (last == 0)) nodes[edge.nodes[2]][1] = 0.5 * (first + last);
  }
  glass.state = touching(glass.mesh, [](const Point& x) { return x[1]; });
  for (const Point& x : nodes) glass.held.push_back(x[1] == 0);
  return glass;
}

Master master_of(const LandedGlass& glass, const core::Mesh& tool, bool knows_contact) {
  Master master{contact_surface(1, tool), glass.state.gap, transition, 0, [](const Point& x) { return x[1]; }};
  if (knows_contact) master.touching = glass.held;
  return master;
}

/// Integral of the contact weight over the surface, m per metre of depth.
double length_in_contact(const LandedGlass& glass, bool knows_contact) {
  const auto tool = testing::tool(divided(-0.02, 0.02, 7));
  return weighted_contact_area(build_interface(contact_surface(0, glass.mesh), glass.state.pressure,
                                               {master_of(glass, tool, knows_contact)}, core::Geometry::planar));
}

double exact_length(const Front& front) {
  const double reach = edge_length * std::pow(transition / height(front.end + edge_length, front), 1 / front.power);
  double sum = 0;
  constexpr int parts = 2000;
  for (int i = 0; i < parts; ++i)
    sum += contact_weight(height(front.end + reach * (i + 0.5) / parts, front), transition);
  return front.end + reach * sum / parts;
}

TEST(FrontOfContact, is_found_where_the_gap_begins_to_grow_with_a_power_of_the_distance) {
  for (const double power : powers)
    for (const bool mirrored : {false, true})
      for (double end = 0.0031; end < 0.0089; end += 0.00037) {
        const auto glass = landed({end, power}, mirrored);
        const auto surface = contact_surface(0, glass.mesh);
        const auto tool = testing::tool(divided(-0.02, 0.02, 7));
        const Master master = master_of(glass, tool, true), unknowing = master_of(glass, tool, false);
        const ContactEndFinder find(surface);
        int found = 0;
        for (std::size_t edge = 0; edge < surface.edges.size(); ++edge) {
          EXPECT_FALSE(find(edge, unknowing));
          const auto at = find(edge, master);
          if (!at) continue;
          ++found;
          const auto& x = surface.edges[edge].x;
          EXPECT_NEAR(std::abs(((1 - at->end) * x[0] + at->end * x[1])[0]), end, 1.5e-5) << end << mirrored;
          EXPECT_NEAR(at->power, power, 0.01) << end << mirrored;
        }
        EXPECT_EQ(found, 1);
      }
}

TEST(FrontOfContact, makes_the_area_in_contact_follow_the_front_between_two_vertices) {
  for (const double power : powers) {
    const std::string of = fmt::format(" that opens with the power {} and moves through an edge", power);
    Figure chord("area in contact behind a front" + of + ", chord, off by at most", "%"),
        smooth("area in contact behind a front" + of + ", off by at most", "%");
    for (const bool mirrored : {false, true})
      for (double end = 0.0046; end < 0.0075; end += 0.0001) {
        const auto glass = landed({end, power}, mirrored);
        const double exact = exact_length({end, power});
        chord.add(100 * std::abs(length_in_contact(glass, false) / exact - 1));
        smooth.add(100 * std::abs(length_in_contact(glass, true) / exact - 1));
      }
    smooth.at_most(power == 2 ? 0.05 : 0.1);  // else the edge behind, a parabola, has an error too
    chord.for_comparison();
  }
}

TEST(FrontOfContact, is_left_to_the_chord_where_the_gap_opens_with_a_kink_or_nothing_is_known_behind) {
  auto glass = landed({0.005}, false);
  const auto tool = testing::tool(divided(-0.02, 0.02, 7));
  const auto surface = contact_surface(0, glass.mesh);
  const auto count = [&](const Master& master) {
    const ContactEndFinder find(surface);
    int found = 0;
    for (std::size_t edge = 0; edge < surface.edges.size(); ++edge) found += find(edge, master).has_value();
    return found;
  };
  Master linear = master_of(glass, tool, true);  // a kink: the gap grows with the distance itself
  for (Index n = 0; n < glass.mesh.node_count(); ++n)
    if (linear.gap[n] > 0) linear.gap[n] = 0.3 * (glass.mesh.nodes[n][0] - 0.0045);
  EXPECT_EQ(count(linear), 0);
  Master out_of_reach = master_of(glass, tool, true);
  for (double& gap : out_of_reach.gap)
    if (gap > transition) gap = infinity;
  EXPECT_EQ(count(out_of_reach), 0);
}

}  // namespace
}  // namespace parison::contact::testing
