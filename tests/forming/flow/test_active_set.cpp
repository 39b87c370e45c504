// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "flow_case.hpp"
#include "forming/flow/contact/active_set.hpp"
#include "forming/flow/surface.hpp"

namespace parison::flow {
namespace {

/// A block at rest on a tool, with contact forces of a given pressure.
struct BlockOnTool {
  FlowProblem flow{tests::structured(8, 8, [](double s, double t) { return Point(0.01 * s, 0.01 * t); }),
                   core::Geometry::planar, 1e3};
  std::vector<bool> active;
  std::vector<int> releases;
  Eigen::VectorXd area;
  Response response;

  explicit BlockOnTool(const std::function<double(double x)>& pressure) {
    flow.problem.tools.resize(1);
    flow.touch("bottom", 0, Point(0, 1));
    const Problem& problem = flow.bound();
    const std::size_t count = problem.candidates.size();
    active.assign(count, true);
    releases.assign(count, 0);
    area = contact_areas(flow.mesh, surface_edges(problem), nodes_in_contact(problem, active));
    response.unknowns = Eigen::VectorXd::Zero(2 * flow.mesh.node_count() + flow.mesh.vertex_count());
    response.tool_velocity = {0.0};
    response.forces.normal.resize(Index(count));
    for (std::size_t i = 0; i < count; ++i)
      response.forces.normal[Index(i)] = pressure(position(i)) * area[problem.candidates[i].node];
  }
  double position(std::size_t candidate) const {
    return flow.mesh.nodes[flow.problem.candidates[candidate].node][0] / 0.01;
  }
  ActiveSetChange update() { return update_active_set(flow.bound(), response, area, active, releases); }
  /// Whether the contacts with positions from `begin` to `end`, and they alone, are open.
  void expect_open(double begin, double end) const {
    for (std::size_t i = 0; i < active.size(); ++i)
      EXPECT_EQ(!active[i], position(i) >= begin && position(i) <= end) << "at " << position(i);
  }
};

TEST(ActiveSet, contacts_open_where_they_pull_most) {
  BlockOnTool block([](double x) { return x < 0.3 ? -100.0 : x < 0.6 ? -2.0 : 50.0; });
  EXPECT_GT(block.update().changed, 0);
  block.expect_open(0, 0.3);  // the weak tension beside it may be gone when the stronger one is
  for (std::size_t i = 0; i < block.active.size(); ++i)
    if (!block.active[i]) block.response.forces.normal[Index(i)] = 0;
  EXPECT_GT(block.update().changed, 0);
  block.expect_open(0, 0.6);  // it is not
  EXPECT_EQ(block.update().changed, 0);
}

TEST(ActiveSet, tension_counts_by_pressure_not_by_force) {
  BlockOnTool block([](double x) { return x < 0.5 ? -10.0 : 10.0; });
  block.area *= 1e-3;  // as of cells a thousand times finer
  block.response.forces.normal *= 1e-3;
  for (std::size_t i = 0; i < block.active.size(); ++i)
    if (block.position(i) < 0.2) {  // beside coarse ones with the same tension
      block.area[block.flow.problem.candidates[i].node] *= 100;
      block.response.forces.normal[Index(i)] *= 100;
    }
  block.update();
  block.expect_open(0, 0.49);
}

TEST(ActiveSet, contacts_opened_too_often_stay_and_keep_no_other_closed) {
  BlockOnTool block([](double x) { return x < 0.3 ? -100.0 : x < 0.6 ? -2.0 : 50.0; });
  for (std::size_t i = 0; i < block.active.size(); ++i)
    if (block.position(i) < 0.3) block.releases[i] = 3;
  const auto change = block.update();
  EXPECT_EQ(change.locked, 5);  // nodes at 0, 1/16 ... 4/16
  block.expect_open(0.3, 0.6);
}

}  // namespace
}  // namespace parison::flow
