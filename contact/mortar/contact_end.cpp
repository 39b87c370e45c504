// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/contact_end.hpp"

#include <algorithm>
#include <cmath>

#include "contact/mortar/root.hpp"

namespace parison::contact {
namespace {

constexpr double thick_body = 1.5, smooth_curve = 2;  ///< powers of the distance from the end of a contact

/// The power with which the gaps of three nodes grow, which stand `first` and `second` apart, m.
double power_of(double near, double middle, double far, double first, double second) {
  const auto bend = [&](double power) {
    const auto root = [&](double gap) { return std::pow(gap / far, 1 / power); };
    return (root(far) - root(middle)) / second - (root(middle) - root(near)) / first;
  };
  const double of_thick = bend(thick_body), of_curve = bend(smooth_curve);
  if (!(of_curve < 0)) return smooth_curve;
  return of_thick > 0 ? find_root(bend, thick_body, of_thick, smooth_curve, of_curve) : thick_body;
}

/// Distance of two nodes along the tool, m, whose gaps differ by `higher`, m.
double along_tool(const Point& from, const Point& to, double higher) {
  return std::sqrt(std::max(0.0, (to - from).squaredNorm() - higher * higher));
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
  const double length = along_tool(here.x[held], here.x[free], near);
  const double on = along_tool(here.x[free], beyond.x[2], gap - near);
  if (!(length > 0 && on > 0)) return std::nullopt;
  const double power = far > gap && std::isfinite(far)
                           ? power_of(near, gap, far, on, along_tool(beyond.x[2], beyond.x[free], far - gap))
                           : smooth_curve;
  const double open = on / (std::pow(gap / near, 1 / power) - 1);  // from the end to the free vertex, m
  if (open < length) return ContactEnd{free + (held - free) * open / length, double(free), near, power};
  const double from_held = std::log(gap / near) / std::log1p(on / length);
  if (!(from_held > 1)) return std::nullopt;
  return ContactEnd{double(held), double(free), near, from_held};
}

}  // namespace parison::contact
