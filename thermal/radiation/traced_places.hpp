#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::thermal {

/// Where glass and tools were when light was traced last: of that and the present topology comes what was traced, so
/// that a run which goes on from here has the same. Empty where all is to be traced anew.
struct TracedPlaces {
  std::vector<core::Point> rays;        ///< nodes of the glass, m
  std::vector<core::Index> surfaces;    ///< what its boundaries were to light
  std::vector<double> absorption;       ///< of each band in each zone of the glass, 1/m; empty where it never changes
  std::vector<core::Point> views;       ///< nodes of all bodies in an enclosure, m
  std::vector<double> open_area, area;  ///< m2, of their boundary edges: what no tool covered, and in all
};

/// What was traced last and what before that: a step that is tried again goes back to it.
template <typename Traced>
struct KeptTraces {
  std::shared_ptr<const Traced> last, before;

  void add(std::shared_ptr<const Traced> made) {
    before = std::move(last);
    last = std::move(made);
  }
  /// Makes one of the two the last one by what `is_it` says of it, or that which `trace` makes.
  template <typename IsIt, typename Trace>
  void recall(const IsIt& is_it, const Trace& trace) {
    if (last && is_it(*last)) return;
    if (before && is_it(*before))
      std::swap(last, before);
    else
      add(trace());
  }
};

}  // namespace parison::thermal
