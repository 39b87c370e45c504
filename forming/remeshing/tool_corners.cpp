// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/remeshing/tool_corners.hpp"

#include <algorithm>
#include <cmath>

#include "contact/unilateral/tool_gap.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {

using core::Point;

namespace {

/// Turns sharper than this (sine) count.
constexpr double sharp = 0.2;
constexpr int chords_of_arc = 32;

/// A contact segment of an active tool as a chain of chords.
using Chain = std::vector<Point>;

Chain chain_of(const core::Segment& segment, const Point& shift) {
  const int chords = segment.is_arc ? chords_of_arc : 1;
  Chain chain;
  for (int k = 0; k <= chords; ++k) chain.push_back(core::point_at(segment, double(k) / chords) + shift);
  return chain;
}

/// Adds a corner unless it is nearer than `same`, m, to one of the others.
void add(const Point& corner, double same, std::vector<Point>& corners) {
  const auto near = [&](const Point& other) { return (other - corner).norm() < same; };
  if (std::none_of(corners.begin(), corners.end(), near)) corners.push_back(corner);
}

void add_crossings(const Chain& first, const Chain& second, double same, std::vector<Point>& corners) {
  constexpr double end = 1e-6;
  const auto within = [](double t) { return t > -end && t < 1 + end; };
  for (std::size_t i = 0; i + 1 < first.size(); ++i)
    for (std::size_t k = 0; k + 1 < second.size(); ++k) {
      const Point u = first[i + 1] - first[i], v = second[k + 1] - second[k], w = second[k] - first[i];
      const double area = core::cross(u, v);
      if (std::abs(area) < sharp * u.norm() * v.norm()) continue;
      const double along_first = core::cross(w, v) / area, along_second = core::cross(w, u) / area;
      if (within(along_first) && within(along_second)) add(first[i] + along_first * u, same, corners);
    }
}

/// Whether a point lies inside an active tool: no glass gets there.
bool is_hidden(const Scene& scene, const State& state, const Point& x, double same) {
  const auto& places = scene.stages[state.stage].tools;
  return std::any_of(places.begin(), places.end(), [&](const auto& place) {
    const Body& tool = scene.tools[place.tool];
    const Point local = x - state.tools[place.tool].offset * core::axis_direction();
    return contact::signed_gap(tool.profile, contact_boundaries(tool), local) < -same;
  });
}

}  // namespace

std::vector<Point> tool_corners(const Scene& scene, const State& state) {
  const double same = core::tolerance::junction * core::size(scene.glass.profile);
  std::vector<Point> corners;
  std::vector<std::vector<Chain>> chains;
  for (const auto& place : scene.stages[state.stage].tools) {
    const Body& tool = scene.tools[place.tool];
    const Point shift = state.tools[place.tool].offset * core::axis_direction();
    const auto& segments = tool.profile.segments;
    const auto touches = [&](const core::Segment& segment) {
      return tool.boundaries[segment.boundary_id].kind == BoundaryKind::contact;
    };
    chains.emplace_back();
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const auto& next = segments[(i + 1) % segments.size()];
      if (touches(segments[i])) chains.back().push_back(chain_of(segments[i], shift));
      if ((touches(segments[i]) || touches(next)) &&
          std::abs(core::cross(core::tangent_at(segments[i], 1), core::tangent_at(next, 0))) > sharp)
        add(segments[i].end + shift, same, corners);
    }
  }
  for (std::size_t a = 0; a < chains.size(); ++a)
    for (std::size_t b = a + 1; b < chains.size(); ++b)
      for (const Chain& first : chains[a])
        for (const Chain& second : chains[b]) add_crossings(first, second, same, corners);
  const auto hidden = [&](const Point& corner) { return is_hidden(scene, state, corner, same); };
  corners.erase(std::remove_if(corners.begin(), corners.end(), hidden), corners.end());
  return corners;
}

}  // namespace parison::forming
