// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/container/free_space.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/numbers.hpp"
#include "forming/scene/container/crossings.hpp"

namespace parison::forming {
namespace {

constexpr std::size_t most_crossings = 300'000, most_bands = 2000;
constexpr int least_panels = 800;  // over the whole height

/// A line across the axis and the height that it stands for, m.
struct Level {
  double z, height;
  double from, to;  ///< of its panel, m
  int band;
};

/// What a line passes: solid from `inner` to `outer`, radii in m.
struct Span {
  double inner, outer;
  std::size_t inner_solid, outer_solid;
  bool inner_contact, outer_contact;
};

/// Free part of a line; `solid` of an end that is the axis or infinity has no meaning.
struct Gap {
  double inner, outer;
  std::size_t inner_solid, outer_solid;
  bool inner_contact, outer_contact;
  std::size_t level;
};

/// Gauss's two points in each panel of the bands between the places where an outline has an end or turns.
std::vector<Level> levels_of(std::vector<double> places, double low, double high) {
  places.push_back(low);
  places.push_back(high);
  std::sort(places.begin(), places.end());
  const double least = (high - low) / most_bands, panel = (high - low) / least_panels;
  std::vector<Level> levels;
  double from = low;
  int band = 0;
  for (const double to : places) {
    if (to <= from || to > high || (to - from < least && places.size() > most_bands && to < high)) continue;
    const int count = std::max(1, static_cast<int>(std::ceil((to - from) / panel)));
    const double height = (to - from) / count;
    for (int i = 0; i < count; ++i)
      for (const double t : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
        levels.push_back({from + (i + t) * height, height / 2, from + i * height, from + (i + 1) * height, band});
    from = to;
    ++band;
  }
  return levels;
}

/// The spans of one solid on a line.
void add_spans(std::vector<Crossing> crossings, std::size_t solid, std::vector<Span>& spans) {
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    spans.push_back({std::max(crossings[i].at, 0.0), crossings[i + 1].at, solid, solid, crossings[i].contact,
                     crossings[i + 1].contact});
}

/// What two lists of spans share, in any order.
std::vector<Span> shared(const std::vector<Span>& below, const std::vector<Span>& above) {
  std::vector<Span> result;
  constexpr std::size_t most = 10'000;
  for (const Span& a : below)
    for (const Span& b : above) {
      Span span = a.inner > b.inner ? a : b;
      const Span& outer = a.outer < b.outer ? a : b;
      span.outer = outer.outer, span.outer_solid = outer.outer_solid, span.outer_contact = outer.outer_contact;
      if (span.inner < span.outer && result.size() < most) result.push_back(span);
    }
  return result;
}

/// Closes gaps along the axis: where a band between two ends of outlines is narrower than `sealed`, what is solid on
/// both sides of it is solid in it.
void close_bands(const std::vector<Level>& levels, double sealed, std::vector<std::vector<Span>>& spans) {
  for (std::size_t first = 1, end; first < levels.size(); first = end) {
    end = first + 1;
    while (end < levels.size() && levels[end].band == levels[first].band) ++end;
    if (end == levels.size() || levels[end - 1].to - levels[first].from >= sealed) continue;
    const std::vector<Span> both = shared(spans[first - 1], spans[end]);
    for (std::size_t k = first; k < end; ++k) spans[k].insert(spans[k].end(), both.begin(), both.end());
  }
}

/// What the spans leave free of a line, without gaps up to `sealed`.
void add_gaps(std::vector<Span> spans, std::size_t level, double sealed, std::vector<Gap>& gaps) {
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.inner < b.inner; });
  Gap gap{0, core::infinity, 0, 0, false, false, level};
  for (const Span& span : spans) {
    if (span.inner - gap.inner > sealed) {
      gap.outer = span.inner, gap.outer_solid = span.inner_solid, gap.outer_contact = span.inner_contact;
      gaps.push_back(gap);
    }
    if (span.outer > gap.inner)
      gap = {span.outer, core::infinity, span.outer_solid, 0, span.outer_contact, false, level};
  }
  gaps.push_back(gap);
}

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Joins gaps of neighbouring lines that overlap; both lists are in order along their lines.
std::vector<std::size_t> joined(const std::vector<Gap>& gaps) {
  std::vector<std::size_t> parent(gaps.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto end_of_level = [&](std::size_t i) {
    const std::size_t level = gaps[i].level;
    while (i < gaps.size() && gaps[i].level == level) ++i;
    return i;
  };
  for (std::size_t first = 0, next; (next = end_of_level(first)) < gaps.size(); first = next) {
    const std::size_t end = end_of_level(next);
    for (std::size_t a = first, b = next; a < next && b < end;) {
      if (std::max(gaps[a].inner, gaps[b].inner) < std::min(gaps[a].outer, gaps[b].outer))
        parent[root_of(parent, a)] = root_of(parent, b);
      gaps[a].outer < gaps[b].outer ? ++a : ++b;
    }
  }
  return parent;
}

void add_to_region(const Gap& gap, const Level& level, FreeRegion& region) {
  if (region.touches.empty()) return;
  region.low = std::min(region.low, level.from);
  region.high = std::max(region.high, level.to);
  if (gap.inner_contact) region.touches[gap.inner_solid] = true;
  if (gap.outer_contact) region.touches[gap.outer_solid] = true;
  if (!std::isfinite(gap.outer)) {
    region.is_open = true;
    return;
  }
  region.slices.push_back({gap.level, level.from, level.to, gap.inner, gap.outer});
  region.volume += region.slices.back().volume();
}

std::vector<FreeRegion> regions_of(const std::vector<Gap>& gaps, const std::vector<Level>& levels, std::size_t solids,
                                   const SpaceLimits& limits) {
  std::vector<std::size_t> parent = joined(gaps), index(gaps.size(), gaps.size());
  std::vector<FreeRegion> regions;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const std::size_t root = root_of(parent, i);
    if (index[root] == gaps.size()) {
      index[root] = regions.size();
      regions.emplace_back();
      regions.back().low = core::infinity, regions.back().high = -core::infinity;
      regions.back().touches.assign(solids, false);
    }
    FreeRegion& region = regions[index[root]];
    add_to_region(gaps[i], levels[gaps[i].level], region);
    const bool first = gaps[i].level == 0, last = gaps[i].level + 1 == levels.size();
    region.from_low_limit = region.from_low_limit || (first && limits.low);
    region.from_high_limit = region.from_high_limit || (last && limits.high);
    region.is_open = region.is_open || (first && !limits.low) || (last && !limits.high);
  }
  return regions;
}

/// Lines across the axis from end to end of what is looked at, none where that has no height.
std::vector<Level> levels_of(const std::vector<Solid>& solids, const SpaceLimits& limits) {
  std::vector<double> places;
  for (const Solid& solid : solids)
    for (const core::Segment& segment : solid.profile->segments) add_turns(segment, solid.shift, places);
  if (places.empty()) return {};
  const auto [lowest, highest] = std::minmax_element(places.begin(), places.end());
  const double low = limits.low.value_or(*lowest), high = limits.high.value_or(*highest);
  if (!(high > low)) return {};
  return levels_of(places, low, high);
}

/// What each line passes; nothing where there are too many crossings.
std::optional<std::vector<std::vector<Span>>> spans_of(const std::vector<Solid>& solids,
                                                       const std::vector<Level>& levels) {
  std::vector<std::vector<Span>> spans(levels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    std::vector<std::vector<Crossing>> crossings(levels.size());
    for (const core::Segment& segment : solids[i].profile->segments) {
      const auto [from, to] = range_along_axis(segment);
      auto level = std::lower_bound(levels.begin(), levels.end(), from + solids[i].shift,
                                    [](const Level& a, double z) { return a.z < z; });
      for (; level != levels.end() && level->z <= to + solids[i].shift; ++level) {
        if (++count > most_crossings) return std::nullopt;
        add_crossings(segment, level->z - solids[i].shift, solids[i].contact[segment.boundary_id],
                      crossings[level - levels.begin()]);
      }
    }
    for (std::size_t k = 0; k < levels.size(); ++k) add_spans(std::move(crossings[k]), i, spans[k]);
  }
  return spans;
}

}  // namespace

double Slice::volume() const {
  return M_PI * (outer * outer - inner * inner) * (to - from) / 2;
}

std::optional<std::vector<FreeRegion>> free_regions(const std::vector<Solid>& solids, const SpaceLimits& limits) {
  const std::vector<Level> levels = levels_of(solids, limits);
  if (levels.empty()) return std::vector<FreeRegion>{};
  auto spans = spans_of(solids, levels);
  if (!spans) return std::nullopt;
  close_bands(levels, limits.sealed_gap, *spans);
  std::vector<Gap> gaps;
  for (std::size_t k = 0; k < levels.size(); ++k) add_gaps(std::move((*spans)[k]), k, limits.sealed_gap, gaps);
  return regions_of(gaps, levels, solids.size(), limits);
}

std::optional<std::vector<Slice>> slices_of(const Solid& solid) {
  const std::vector<Level> levels = levels_of(std::vector<Solid>{solid}, {});
  const auto spans = spans_of({solid}, levels);
  if (!spans) return std::nullopt;
  std::vector<Slice> slices;
  for (std::size_t k = 0; k < levels.size(); ++k)
    for (const Span& span : (*spans)[k]) slices.push_back({k, levels[k].from, levels[k].to, span.inner, span.outer});
  return slices;
}

double contact_volume(const Solid& solid, double low, double high) {
  std::vector<double> places;
  for (const core::Segment& segment : solid.profile->segments) add_turns(segment, solid.shift, places);
  double volume = 0;
  if (high > low)
    for (const Level& level : levels_of(places, low, high)) {
      std::vector<Crossing> crossings;
      for (const core::Segment& segment : solid.profile->segments)
        if (solid.contact[segment.boundary_id]) add_crossings(segment, level.z - solid.shift, true, crossings);
      double radius = 0;
      for (const Crossing& crossing : crossings) radius = std::max(radius, crossing.at);
      volume += M_PI * radius * radius * level.height;
    }
  return volume;
}

}  // namespace parison::forming
