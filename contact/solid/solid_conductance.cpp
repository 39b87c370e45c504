// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solid/solid_conductance.hpp"

namespace parison::contact {

std::vector<core::InterfacePoint> conductance_points(const std::vector<core::SolidInterfacePoint>& points) {
  std::vector<core::InterfacePoint> result;
  result.reserve(points.size());
  for (const core::SolidInterfacePoint& point : points) {
    core::InterfacePoint& flat = result.emplace_back();
    flat.position = {point.position.head<2>().norm(), point.position[2]};
    flat.area = point.area;
    flat.gap = point.gap;
    flat.contact_weight = point.contact_weight;
    flat.pressure = point.pressure;
    flat.law = point.law;
    flat.opening = point.opening;
    flat.closing_rate = point.closing_rate;
  }
  return result;
}

}  // namespace parison::contact
