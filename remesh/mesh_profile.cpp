// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/mesh_profile.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "remesh/outline.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

constexpr double largest_turn = 20 * M_PI / 180;  ///< of an arc within one edge

std::vector<SizeSource> size_sources(const core::Profile& profile, const ProfileSizes& sizes) {
  std::vector<SizeSource> sources;
  for (const core::Segment& segment : profile.segments) {
    double wish = sizes.fine_pieces.at(segment.piece) ? sizes.contact_size : sizes.size;
    if (segment.is_arc) wish = std::min(wish, largest_turn * segment.radius);
    if (wish >= sizes.size) continue;
    const auto count = static_cast<Index>(std::ceil(core::length(segment) / wish));
    for (Index i = 0; i <= count; ++i)
      sources.push_back({core::point_at(segment, static_cast<double>(i) / count), wish, wish});
  }
  return sources;
}

}  // namespace

core::Mesh mesh_profile(const core::Profile& profile, const ProfileSizes& sizes) {
  const SizeField field(size_sources(profile, sizes), sizes.growth, sizes.size);
  Outline outline;
  for (const core::Segment& segment : profile.segments) {
    const double length = core::length(segment);
    const std::vector<double> at =
        divide(length, [&](double s) { return field(core::point_at(segment, s / length)); }, 1);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      outline.vertices.push_back(i == 0 ? segment.start : core::point_at(segment, at[i] / length));
      outline.mids.push_back(core::point_at(segment, 0.5 * (at[i] + at[i + 1]) / length));
      outline.pieces.push_back(segment.piece);
    }
  }
  outline.loop_start.push_back(outline.edge_count());
  MeshedOutline result = mesh_outline(outline, profile.pieces, field);
  if (!result.reason.empty()) throw std::runtime_error("the profile cannot be meshed: " + result.reason);
  return std::move(result.mesh);
}

}  // namespace parison::remesh
