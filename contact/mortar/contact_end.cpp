// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/contact_end.hpp"

#include <algorithm>
#include <cmath>

namespace parison::contact {

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
  const auto touches = [&](int place) { return master.touching[here.nodes[place]]; };
  if (touches(0) == touches(1)) return std::nullopt;
  const int held = touches(0) ? 0 : 1, free = 1 - held;
  const Index behind = free == 0 ? ending_[here.nodes[0]] : starting_[here.nodes[1]];
  if (behind < 0) return std::nullopt;
  const Index next = slave_.edges[behind].nodes[2];
  if (master.touching[next]) return std::nullopt;
  const double near = master.gap[here.nodes[free]], far = master.gap[next];
  if (!(near > 0 && far > near && std::isfinite(far))) return std::nullopt;
  const double length = (here.x[free] - here.x[held]).norm(), on = (slave_.edges[behind].x[2] - here.x[free]).norm();
  const double open = on * std::sqrt(near) / (std::sqrt(far) - std::sqrt(near));  // from the end to the free vertex, m
  if (open < length) return ContactEnd{free + (held - free) * open / length, double(free), near, 1};
  const double bend = length / on * (far / near * length / (length + on) - 1);  // of the parabola through the three
  if (!(bend > 0)) return std::nullopt;
  return ContactEnd{double(held), double(free), near, std::min(bend, 1.0)};
}

}  // namespace parison::contact
