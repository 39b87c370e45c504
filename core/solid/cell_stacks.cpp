// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/cell_stacks.hpp"

#include <unordered_map>

namespace parison::core {

std::vector<std::vector<Index>> cell_stacks(const HexMesh& mesh) {
  constexpr int low = 4, high = 22;  // nodes in the middle of a cell's sides
  std::unordered_map<Index, Index> above;
  std::unordered_map<Index, char> is_high;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    above[mesh.cells[c][low]] = c;
    is_high[mesh.cells[c][high]] = 1;
  }
  std::vector<std::vector<Index>> stacks;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    if (is_high.count(mesh.cells[c][low])) continue;
    auto& stack = stacks.emplace_back(1, c);
    for (auto next = above.find(mesh.cells[c][high]); next != above.end();
         next = above.find(mesh.cells[stack.back()][high]))
      stack.push_back(next->second);
  }
  return stacks;
}

}  // namespace parison::core
