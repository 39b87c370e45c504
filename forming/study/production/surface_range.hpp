#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <string>
#include <vector>

#include "forming/study/production/cycle_run.hpp"

namespace parison::forming {

/// Temperatures of the surface of a tool over a machine cycle, K.
struct SurfaceRange {
  double min = std::numeric_limits<double>::infinity(), mean = 0, max = 0;  ///< of its mean
  double hottest = 0;                                                       ///< point
};

SurfaceRange range_of(const std::vector<CycleSample>& samples, std::size_t tool);

/// Why no machine makes containers with tools that are so hot: a sentence for each tool to all of whose surface glass
/// sticks, by the limit of the case for a tool surface, or that is hotter at some place than the softening point of
/// the glass, 10^6.6 Pa.s (Littleton, 1927). Empty where production is possible.
std::vector<std::string> why_not_possible(const Scene& scene, const std::vector<CycleSample>& samples);

/// A sentence for each tool whose surface is colder than the 400 degC that blanks and moulds have at least in
/// production, in the mean over it and the cycle.
std::vector<std::string> too_cold(const Scene& scene, const std::vector<CycleSample>& samples);

}  // namespace parison::forming
