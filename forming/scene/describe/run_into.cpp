// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "forming/scene/container/crossings.hpp"
#include "forming/scene/describe/unusual.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

/// Points of the contact boundaries of a tool that look at the axis, in its own frame: the walls of its hole. A guide
/// plate that is drawn without a hole has none, nor has a hole that is a seal and no contact boundary.
std::vector<core::Point> hole_walls(const Tool& tool) {
  constexpr double inwards = 1e-3;
  const double spacing = core::size(tool.profile) / 1000;
  std::vector<core::Point> points;
  for (const core::Segment& segment : tool.profile.segments) {
    if (tool.boundaries[segment.boundary_id].kind != BoundaryKind::contact) continue;
    const int count = 1 + static_cast<int>(std::min(2000.0, core::length(segment) / spacing));
    for (int i = 0; i <= count; ++i)
      if (core::normal_at(segment, double(i) / count)[0] < -inwards)
        points.push_back(core::point_at(segment, double(i) / count));
  }
  return points;
}

/// Every so many of the points, so that work with each segment of an outline stays bounded.
std::vector<core::Point> thinned(const std::vector<core::Point>& points, const core::Profile& outline) {
  constexpr std::size_t most_work = 1'000'000;
  const std::size_t stride = 1 + points.size() * outline.segments.size() / most_work;
  std::vector<core::Point> kept;
  for (std::size_t i = 0; i < points.size(); i += stride) kept.push_back(points[i]);
  return kept;
}

struct Interference {
  double depth = 0;  ///< m, along the radius
  core::Point at = core::Point::Zero();
};

/// How much wider a tool is than the hole that another one has, at points of its walls, shifted by so much along the
/// axis.
Interference interference(const Tool& moved, double shift, const std::vector<core::Point>& walls) {
  Interference worst;
  std::vector<Crossing> crossings;
  for (const core::Point& wall : walls) {
    const core::Point own = wall - shift * core::axis_direction();
    crossings.clear();
    for (const core::Segment& segment : moved.profile.segments)
      add_crossings(segment, own[1], moved.boundaries[segment.boundary_id].kind == BoundaryKind::contact, crossings);
    for (const Crossing& crossing : crossings)
      if (crossing.contact && crossing.at - own[0] > worst.depth) worst = {crossing.at - own[0], wall};
  }
  return worst;
}

/// Where a tool that moves from one offset to another first runs into a tool that it is free of at the start.
std::string collision(const Tool& moved, double from, double to, const Tool& other, double touching) {
  constexpr int count = 24;
  const std::vector<core::Point> walls = thinned(hole_walls(other), moved.profile);
  const auto at = [&](double offset) { return interference(moved, offset - other.position, walls); };
  if (at(from).depth > touching) return "";  // they slide in each other
  Interference worst;
  double free = from, caught = to;
  for (int i = 1; i <= count; ++i) {
    const double offset = from + (to - from) * i / count;
    const Interference now = at(offset);
    if (now.depth > touching && worst.depth == 0) caught = offset, free = offset - (to - from) / count;
    if (now.depth > std::max(touching, worst.depth))
      worst = {now.depth, now.at + other.position * core::axis_direction()};
  }
  if (worst.depth == 0) return "";
  for (int i = 0; i < 16; ++i) {
    const double middle = 0.5 * (free + caught);
    (at(middle).depth > touching ? caught : free) = middle;
  }
  return fmt::format(
      "\"{}\" runs into \"{}\" on its way: from {:.4g} mm on it is wider than the opening there, by up to {:.2g} mm, "
      "near "
      "({:.4g}, {:.4g}) mm. The run lets it pass, as where tools overlap their union counts; a machine would not",
      moved.name, other.name, 1e3 * caught, 1e3 * worst.depth, 1e3 * worst.at[0], 1e3 * worst.at[1]);
}

}  // namespace

std::vector<std::string> tools_run_into(const Scene& scene, const ContainerPlan& plan) {
  std::vector<std::string> notes;
  if (!plan.press || has_moved_before(scene, plan.press->stage, plan.press->tool)) return notes;
  const double touching = tolerance::sealed * core::size(scene.glass.profile);
  const Tool& moved = scene.tools[static_cast<std::size_t>(plan.press->tool)];
  for (const StageTool& entry : scene.stages[static_cast<std::size_t>(plan.press->stage)].tools) {
    if (entry.tool == plan.press->tool || entry.moves() || has_moved_before(scene, plan.press->stage, entry.tool))
      continue;
    std::string note =
        collision(moved, moved.position, plan.press->stop, scene.tools[static_cast<std::size_t>(entry.tool)], touching);
    if (!note.empty()) notes.push_back(std::move(note));
  }
  return notes;
}

}  // namespace parison::forming
