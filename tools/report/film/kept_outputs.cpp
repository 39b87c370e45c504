// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/film/kept_outputs.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace parison::tools {

std::size_t nearest(const std::vector<PvdEntry>& entries, double time) {
  const auto closer = [time](const PvdEntry& a, const PvdEntry& b) {
    return std::abs(a.time - time) < std::abs(b.time - time);
  };
  return static_cast<std::size_t>(std::min_element(entries.begin(), entries.end(), closer) - entries.begin());
}

std::vector<std::size_t> kept_outputs(const ResultFolder& folder, const std::vector<PvdEntry>& entries, double bytes,
                                      std::size_t budget) {
  const double last = static_cast<double>(entries.size() - 1),
               stride = std::max(1.0, bytes / static_cast<double>(budget));
  std::set<std::size_t> kept{entries.size() - 1};
  for (double i = 0; i < last; i += stride) kept.insert(static_cast<std::size_t>(i));
  for (const StageSpan& stage : folder.stages) kept.insert(nearest(entries, stage.end));
  return {kept.begin(), kept.end()};
}

}  // namespace parison::tools
