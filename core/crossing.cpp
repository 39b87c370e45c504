// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/crossing.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <limits>

namespace parison::core {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Chord*>;

Kernel::Segment_2 segment(const Chord& chord) {
  return {Kernel::Point_2(chord.a[0], chord.a[1]), Kernel::Point_2(chord.b[0], chord.b[1])};
}

bool meet(const Chord& p, const Chord& q) {
  return p.from == q.from || p.from == q.to || p.to == q.from || p.to == q.to;
}

}  // namespace

std::pair<Index, Index> find_crossing(const std::vector<Chord>& chords) {
  std::vector<Box> boxes;
  for (const auto& chord : chords) boxes.emplace_back(segment(chord).bbox(), &chord);
  constexpr Index none = std::numeric_limits<Index>::max();
  std::pair<Index, Index> lowest{none, none};
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& one, const Box& other) {
    const Chord &p = *one.handle(), &q = *other.handle();
    if (meet(p, q) || !CGAL::do_intersect(segment(p), segment(q))) return;
    lowest = std::min(lowest, std::pair<Index, Index>(std::minmax(Index(&p - chords.data()), Index(&q - chords.data()))));
  });
  return lowest.first == none ? std::pair<Index, Index>{-1, -1} : lowest;
}

}  // namespace parison::core
