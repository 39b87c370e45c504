// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ordering.hpp"

#include <amd.h>

#include <cassert>
#include <numeric>

namespace parison::core {

std::vector<Index> minimum_degree_order(Index size, const std::vector<std::array<Index, 2>>& edges) {
  std::vector<Index> start(size + 1, 0), neighbour(edges.size()), order(size);
  for (const auto& edge : edges) ++start[edge[0] + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Index> next(start.begin(), start.end() - 1);
  for (const auto& [from, to] : edges) neighbour[next[from]++] = to;
  [[maybe_unused]] const int status =
      amd_order(size, start.data(), neighbour.data(), order.data(), nullptr, nullptr);  // orders A + A'
  assert(status >= AMD_OK);
  return order;
}

}  // namespace parison::core
