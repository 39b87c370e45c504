// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "interface_cases.hpp"

namespace parison::contact::testing {
namespace {

TEST(MortarSize, an_interface_of_sixteen_thousand_edges_a_side_is_exact) {
  const int count = 16000;
  const auto slave = glass(divided(0, 0.2, count)), master = tool(divided(0, 0.2, count - 1));
  const auto points = build_interface(contact_surface(0, slave), contact_surface(1, master), touching(slave),
                                      {core::Geometry::planar, width, 0});
  EXPECT_NEAR(weighted_contact_area(points), 0.2, 1e-12);
}

}  // namespace
}  // namespace parison::contact::testing
