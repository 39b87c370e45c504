// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/container/hollow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace parison::forming {
namespace {

constexpr double least_share = 1e-3;  // of the glass, from which a dent counts as a hollow

/// The free parts of the lines through glass, from the bottom up, the lines counted from 0.
std::vector<Slice> free_slices(const std::vector<Slice>& glass, int up) {
  std::vector<Slice> sorted = glass, free;
  std::sort(sorted.begin(), sorted.end(), [up](const Slice& a, const Slice& b) {
    return a.line != b.line ? (up > 0 ? a.line < b.line : a.line > b.line) : a.inner < b.inner;
  });
  std::size_t count = 0;
  for (auto slice = sorted.begin(); slice != sorted.end(); ++count) {
    Slice gap = *slice;
    gap.line = count;
    double inner = 0;
    for (const std::size_t line = slice->line; slice != sorted.end() && slice->line == line; ++slice) {
      gap.inner = inner, gap.outer = slice->inner;
      if (gap.outer > gap.inner) free.push_back(gap);
      inner = std::max(inner, slice->outer);
    }
    gap.inner = inner, gap.outer = std::numeric_limits<double>::infinity();
    free.push_back(gap);
  }
  return free;
}

/// Space below a level, of parts that are joined below it.
class Basins {
 public:
  explicit Basins(const std::vector<Slice>& free) : free_(free), parent_(free.size()), open_(free.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    volume_.resize(free.size());
  }

  /// Adds the next line, parts from `end` of the one before to a new end, and joins them with those below.
  void add_line(const std::vector<bool>& is_reached) {
    const std::size_t below = first_, here = end_;
    const std::size_t line = here < free_.size() ? free_[here].line : 0;
    for (first_ = here; end_ < free_.size() && free_[end_].line == line; ++end_) {
      open_[end_] = line == 0 || std::isinf(free_[end_].outer);
      volume_[end_] = open_[end_] || !is_reached[end_] ? 0 : free_[end_].volume();
    }
    for (std::size_t a = below, b = here; a < here && b < end_;) {
      if (std::max(free_[a].inner, free_[b].inner) < std::min(free_[a].outer, free_[b].outer)) join(a, b);
      free_[a].outer < free_[b].outer ? ++a : ++b;
    }
  }

  /// The closed basins that come up to the last line, by one part of each.
  std::vector<std::size_t> closed() {
    std::vector<std::size_t> roots;
    for (std::size_t i = first_; i < end_; ++i)
      if (const std::size_t root = root_of(i); !open_[root]) roots.push_back(root);
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    return roots;
  }

  std::size_t root_of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool is_at_end() const { return end_ == free_.size(); }
  std::size_t first() const { return first_; }
  bool is_open(std::size_t root) const { return open_[root]; }
  double volume(std::size_t root) const { return volume_[root]; }

 private:
  void join(std::size_t a, std::size_t b) {
    a = root_of(a), b = root_of(b);
    if (a == b) return;
    parent_[a] = b;
    volume_[b] += volume_[a];
    open_[b] = open_[b] || open_[a];
  }

  const std::vector<Slice>& free_;
  std::vector<std::size_t> parent_;
  std::vector<bool> open_;
  std::vector<double> volume_;
  std::size_t first_ = 0, end_ = 0;  ///< of the last line
};

/// Which parts liquid poured in from above comes to: not bubbles in the glass.
std::vector<bool> reached_from_above(const std::vector<Slice>& free) {
  Basins space(free);
  while (!space.is_at_end()) space.add_line(std::vector<bool>(free.size(), true));
  const std::vector<std::size_t> above = space.closed();  // what ends in the last line
  std::vector<bool> reached(free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    const std::size_t root = space.root_of(i);
    reached[i] = space.is_open(root) || std::binary_search(above.begin(), above.end(), root);
  }
  return reached;
}

/// The line at which the basins below it hold most, and what they hold, m3.
std::pair<std::size_t, double> fullest_line(const std::vector<Slice>& free, const std::vector<bool>& reached) {
  Basins basins(free);
  std::pair<std::size_t, double> fullest{0, 0};
  while (!basins.is_at_end()) {
    basins.add_line(reached);
    double volume = 0;
    for (const std::size_t root : basins.closed()) volume += basins.volume(root);
    if (volume > fullest.second) fullest = {free[basins.first()].line, volume};
  }
  return fullest;
}

/// Volume on each line up to one in the basins that come up to it, m3.
std::vector<double> volumes_of_lines(const std::vector<Slice>& free, const std::vector<bool>& reached,
                                     std::size_t last) {
  Basins basins(free);
  std::vector<double> volumes(last + 1);
  for (std::size_t line = 0; line <= last; ++line) basins.add_line(reached);
  const std::vector<std::size_t> wet = basins.closed();
  for (std::size_t i = 0; i < free.size() && free[i].line <= last; ++i)
    if (reached[i] && std::binary_search(wet.begin(), wet.end(), basins.root_of(i)))
      volumes[free[i].line] += free[i].volume();
  return volumes;
}

}  // namespace

std::optional<double> Hollow::to_depth(double depth) const {
  if (depth >= content.x.back()) return {};
  return content(depth);
}

std::optional<Hollow> hollow_of(const std::vector<Slice>& glass, int up) {
  double glass_volume = 0;
  for (const Slice& slice : glass) glass_volume += slice.volume();
  const std::vector<Slice> free = free_slices(glass, up);
  const std::vector<bool> reached = reached_from_above(free);
  const auto [last, capacity] = fullest_line(free, reached);
  if (capacity <= least_share * glass_volume) return {};
  std::vector<std::pair<double, double>> panels(last + 1);  // of the lines, from below to above
  for (const Slice& slice : free)
    if (slice.line <= last)
      panels[slice.line] = up > 0 ? std::pair{slice.from, slice.to} : std::pair{slice.to, slice.from};
  const std::vector<double> volumes = volumes_of_lines(free, reached, last);
  Hollow hollow{panels[last].second, capacity, {}};
  double below = capacity;
  for (std::size_t line = last + 1; line-- > 0 && below > 1e-9 * capacity;) {
    if (line == last || panels[line] != panels[line + 1]) {
      hollow.content.x.push_back(up * (hollow.rim - panels[line].second));
      hollow.content.y.push_back(below);
    }
    below -= volumes[line];
    if (below <= 1e-9 * capacity) {
      hollow.content.x.push_back(up * (hollow.rim - panels[line].first));
      hollow.content.y.push_back(0);
    }
  }
  return hollow;
}

}  // namespace parison::forming
