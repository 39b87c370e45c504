// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/contact_end.hpp"

#include <algorithm>
#include <cmath>

#include "contact/mortar/root.hpp"

namespace parison::contact {
namespace {

constexpr double kink = 1, thick_body = 1.5, smooth_curve = 2;  ///< powers of the distance from the end of a contact

/// The power of the distance with which the gaps of three nodes grow that stand `first` and `second` apart, m. Below
/// that of a thick body they are not of one curve that leaves the tool, as behind a chord that a new mesh has cut into
/// edges: the nearer they are to a straight line, the nearer the power is that of a smooth curve again, with which the
/// contact ends soonest.
double power_of(double near, double middle, double far, double first, double second) {
  const auto bend = [&](double power) {
    const auto root = [&](double gap) { return std::pow(gap / far, 1 / power); };
    return (root(far) - root(middle)) / second - (root(middle) - root(near)) / first;
  };
  const double of_kink = bend(kink), of_curve = bend(smooth_curve);
  if (!(of_curve < 0 && of_kink > 0)) return smooth_curve;
  const double power = find_root(bend, kink, of_kink, smooth_curve, of_curve);
  return power < thick_body ? 2 * thick_body - power : power;
}

}  // namespace

ContactEndFinder::ContactEndFinder(const Surface& slave) : slave_(slave) {
  Index count = 0;
  for (const SurfaceEdge& edge : slave.edges) count = std::max({count, edge.nodes[0] + 1, edge.nodes[1] + 1});
  starting_.assign(count, -1);
  ending_.assign(count, -1);
  for (std::size_t i = 0; i < slave.edges.size(); ++i) {
    starting_[slave.edges[i].nodes[0]] = static_cast<Index>(i);
    ending_[slave.edges[i].nodes[1]] = static_cast<Index>(i);
  }
}

std::optional<ContactEnd> ContactEndFinder::operator()(std::size_t edge, const Master& master) const {
  if (master.touching.empty()) return std::nullopt;
  const SurfaceEdge& here = slave_.edges[edge];
  const bool first = master.touching[here.nodes[0]], second = master.touching[here.nodes[1]];
  if (first == second) return std::nullopt;
  const int held = first ? 0 : 1, free = 1 - held;
  const Index behind = free == 0 ? ending_[here.nodes[0]] : starting_[here.nodes[1]];
  if (behind < 0) return std::nullopt;
  const SurfaceEdge& beyond = slave_.edges[behind];
  const Index middle = beyond.nodes[2], last = beyond.nodes[free];
  if (master.touching[middle]) return std::nullopt;
  const double near = master.gap[here.nodes[free]], gap = master.gap[middle], far = master.gap[last];
  if (!(near > 0 && gap > near && std::isfinite(gap))) return std::nullopt;
  const double length = (here.x[free] - here.x[held]).norm(), on = (beyond.x[2] - here.x[free]).norm();
  const double power = far > gap && std::isfinite(far)
                           ? power_of(near, gap, far, on, (beyond.x[free] - beyond.x[2]).norm())
                           : smooth_curve;
  const double open = on / (std::pow(gap / near, 1 / power) - 1);  // from the end to the free vertex, m
  if (open < length) return ContactEnd{free + (held - free) * open / length, double(free), near, power};
  const double from_held = std::log(gap / near) / std::log1p(on / length);
  if (!(from_held > 1)) return std::nullopt;
  return ContactEnd{double(held), double(free), near, from_held};
}

}  // namespace parison::contact
