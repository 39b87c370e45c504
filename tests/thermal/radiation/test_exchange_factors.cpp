// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "thermal/bodies.hpp"
#include "thermal/radiation/rays/exchange_factors.hpp"

namespace parison::thermal {
namespace {

TEST(ExchangeFactors, all_that_is_sent_arrives_also_where_glass_is_so_dark_that_exponentials_vanish) {
  const core::Mesh mesh = test::rectangle(test::divide(0, 1, 4), test::divide(0, 1, 4));
  std::vector<Point> position;
  std::vector<double> volume;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const auto& at : core::triangle_rule(4)) {
      const auto point = core::map_cell_point(mesh, cell, Geometry::planar, at);
      position.push_back(point.position);
      volume.push_back(point.volume);
    }
  const Zones zones(position, volume, volume, 1);
  const std::vector<RaySurface> surface(mesh.boundary_edges().size(), {0, true});
  const double index = 1.5, surface_area = 4;
  Eigen::VectorXd one(zones.function_count() + 1);
  one << zones.one(), 1;
  for (const double absorption : {1.0, 4000.0}) {
    const auto factors = trace_exchange(mesh, Geometry::planar, zones, surface, 1, index,
                                        {Eigen::VectorXd::Constant(zones.size(), absorption)}, {});
    const double sent = index * index * (4 * absorption + surface_area);
    EXPECT_NEAR(one.dot(factors[0] * one), sent, 1e-10 * sent) << absorption;
  }
}

}  // namespace
}  // namespace parison::thermal
