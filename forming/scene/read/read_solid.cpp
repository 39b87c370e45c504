// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "contact/solid/section_surface.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/read/drawing/step/measured_sections.hpp"
#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

/// Largest radius at a height of the boundaries of an outline that may touch glass, m; 0 where there are none.
double width_at(const Body& body, double height) {
  const auto contact = contact_boundaries(body);
  double widest = 0;
  for (const auto& segment : body.profile.segments) {
    if (!contact[segment.boundary_id]) continue;
    constexpr int chords = 64;
    core::Point from = core::point_at(segment, 0);
    for (int i = 1; i <= chords; ++i) {
      const core::Point to = core::point_at(segment, double(i) / chords);
      const double low = std::min(from[1], to[1]), high = std::max(from[1], to[1]);
      constexpr double rounding = 1e-9;  // m
      if (height >= low - rounding && height <= high + rounding) {
        const double share = high > low ? std::clamp((height - from[1]) / (to[1] - from[1]), 0.0, 1.0) : 1;
        widest = std::max({widest, from[0] + share * (to[0] - from[0]), high > low ? 0 : from[0]});
      }
      from = to;
    }
  }
  return widest;
}

double widest_of(const Body& body) {
  const auto contact = contact_boundaries(body);
  double widest = 0;
  for (const auto& segment : body.profile.segments)
    if (contact[segment.boundary_id])
      widest = std::max({widest, core::point_at(segment, 0)[0], core::point_at(segment, 0.5)[0], segment.end[0]});
  return widest;
}

/// Lengths over heights, each over the half width that the outline has there; one length is over the largest.
core::Table over_width(const CaseNode& node, const Tool& tool) {
  core::Table table = core::quantity_table(node, dimension::length, dimension::length);
  const bool is_list = node.kind == CaseNode::Kind::list;
  for (std::size_t i = 0; i < table.y.size(); ++i) {
    const CaseNode& at = is_list ? node.items[i] : node;
    core::positive(is_list ? at.items[1] : at, dimension::length);
    const double width = is_list ? width_at(tool, table.x[i]) : widest_of(tool);
    if (width <= 0)
      core::refuse(at, fmt::format("z = {:g} mm was found, allowed are heights of the contact boundaries of \"{}\"",
                                   1e3 * table.x[i], tool.name));
    table.y[i] /= width;
  }
  return table;
}

/// Refuses corner radii larger than half of the narrower side.
void check_corners(const CaseNode& node, const core::SectionFamily& family, const Tool& tool) {
  for (std::size_t i = 0; i < family.corner.y.size(); ++i) {
    const double height = family.corner.x[i];
    const double depth = family.depth.y.empty() ? 1 : family.depth(height), allowed = std::min(1.0, depth);
    constexpr double rounding = 1e-9;
    if (family.corner.y[i] <= allowed * (1 + rounding)) continue;
    const bool is_list = node.kind == CaseNode::Kind::list;
    const double width = is_list ? width_at(tool, height) : widest_of(tool);
    core::refuse(is_list ? node.items[i] : node,
                 fmt::format("a corner radius of {:g} mm was found, allowed are at most {:g} mm, half of the narrower "
                             "side there",
                             1e3 * family.corner.y[i] * width, 1e3 * allowed * width));
  }
}

/// Whether a stage uses a tool that is not round, which it names.
const Tool* tool_with_sections(const Scene& scene, const Stage& stage) {
  for (const StageTool& entry : stage.tools)
    if (!scene.tools[entry.tool].section.is_round()) return &scene.tools[entry.tool];
  return nullptr;
}

/// Refuses what a stage has that is not computed for glass in space.
void check_solid_stage(const Stage& stage, const CaseNode& node) {
  const auto refuse = [&](const char* what) {
    core::refuse(node, fmt::format("{} was found in a stage in which the glass is a solid in space, where it is not "
                                   "computed yet",
                                   what));
  };
  if (stage.trapped_air) refuse("trapped air");
  for (const EndCondition& end : stage.ends)
    if (end.kind == EndCondition::Kind::force) refuse("a force that ends the stage");
  for (const StageTool& tool : stage.tools)
    if (std::holds_alternative<ForceMotion>(tool.motion)) refuse("a tool that a force drives");
  for (const auto& [name, pressure] : stage.pressure)
    if (name != inner_side) refuse("a pressure on another side than \"inner\"");
}

/// Where an outline is furthest inside the surface of a mould.
struct Narrowest {
  double depth = 0, height = 0, angle = 0;  ///< m, m, rad
};
Narrowest narrowest_place(const Body& blank, const Tool& mould) {
  const auto [low, high] = contact_range(mould);
  const contact::SectionSurface surface(mould.profile, contact_boundaries(mould), mould.section, mould.position);
  const auto contact = contact_boundaries(blank);
  Narrowest narrowest;
  constexpr int along = 16, quarter = 18;  // places of a segment, and of a quarter turn
  for (const core::Segment& segment : blank.profile.segments)
    for (int i = 0; contact[segment.boundary_id] && i <= along; ++i) {
      const core::Point at = core::point_at(segment, double(i) / along);
      const double z = at[1] + blank.position;
      constexpr double joint = 1e-3;  // m, at the ends of the mould
      if (z < low + mould.position + joint || z > high + mould.position - joint) continue;
      for (int turn = 0; turn <= quarter; ++turn) {
        const double angle = M_PI_2 * turn / quarter;
        const double depth = -surface.gap({at[0] * std::cos(angle), at[0] * std::sin(angle), z}).distance;
        if (depth > narrowest.depth) narrowest = {depth, z, angle};
      }
    }
  return narrowest;
}

/// Refuses a mould that is narrower than what forms the parison: by the outlines of both.
void check_room(const Scene& scene, const StageTool& entry, const CaseNode& node) {
  const Tool& mould = scene.tools[entry.tool];
  if (mould.section.is_round() || !scene.container || !scene.container->parison) return;
  for (const StageTool& other : scene.stages[scene.container->parison->stage].tools) {
    if (scene.container->parison->plunger == other.tool || other.tool == entry.tool) continue;
    const Tool& blank = scene.tools[other.tool];
    const auto [depth, height, angle] = narrowest_place(blank, mould);
    constexpr double bearable = 2e-4;  // m
    if (depth > bearable)
      core::refuse(node,
                   fmt::format("\"{}\" is {:.2f} mm wider than \"{}\" at z = {:.1f} mm, {:.0f} deg from the plane "
                               "y = 0, allowed is a mould with room for the parison",
                               blank.name, 1e3 * depth, mould.name, 1e3 * height, angle * 180 / M_PI));
  }
}

}  // namespace

core::SectionFamily read_sections(const CaseNode& node, const BodyContext& context, Tool& tool) {
  if (context.geometry != core::Geometry::axisymmetric)
    core::refuse(node, "sections were found in a planar case, allowed are they where geometry = \"axisymmetric\"");
  const bool has_file =
      CaseTable(node, {"half_depth", "corner_radius", "exponent", "file", "origin", "axis", "turn"}).find("file");
  if (has_file) return measured_sections(CaseTable(node, {"file", "origin", "axis", "turn"}), context.directory, tool);
  const CaseTable table(node, {"half_depth", "corner_radius", "exponent"});
  core::SectionFamily family;
  const auto *corner = table.find("corner_radius"), *exponent = table.find("exponent");
  if (corner && exponent) core::refuse(node, "corner_radius and exponent were found, allowed is one of them");
  if (const auto* item = table.find("half_depth")) family.depth = over_width(*item, tool);
  if (corner) family.corner = over_width(*corner, tool);
  if (corner) check_corners(*corner, family, tool);
  if (exponent) {
    family.exponent = core::quantity_table(*exponent, dimension::length, dimension::none);
    for (const double n : family.exponent.y)
      if (!(n >= 2 && n <= 20))
        core::refuse(*exponent, fmt::format("an exponent of {:g} was found, allowed are 2 (an ellipse) to 20", n));
  }
  if (family.is_round())
    core::refuse(node, "no shape was found, allowed are half_depth, corner_radius, exponent or the file of a solid");
  return family;
}

void read_solid(const CaseNode& node, const Stage& stage, Scene& scene) {
  if (scene.solid) {
    const std::string& first = scene.stages[scene.solid->from_stage].name;
    core::refuse(node,
                 fmt::format("the glass is a solid in space since stage \"{}\", allowed is this key once", first));
  }
  if (scene.geometry != core::Geometry::axisymmetric || !scene.has_flow() || !scene.has_heat())
    core::refuse(node, "a solid was found, allowed in an axisymmetric case whose glass flows and carries heat");
  if (scene.stages.empty())
    core::refuse(node,
                 fmt::format("stage \"{}\" is the first, allowed are later ones: the glass begins round", stage.name));
  const CaseTable table(node, {"sector"});
  const CaseNode& sector = table.get("sector");
  const double angle = core::positive(sector, dimension::none), share = 2 * M_PI / angle;
  constexpr double rounding = 1e-9;
  if (std::abs(share - std::round(share)) > rounding * share || angle > 2 * M_PI * (1 + rounding))
    core::refuse(sector, fmt::format("{:g} deg was found, allowed is a whole part of 360 deg: \"90 deg\", \"180 deg\", "
                                     "\"360 deg\", for round moulds also less",
                                     angle * 180 / M_PI));
  scene.solid = SolidPart{static_cast<Index>(scene.stages.size()), 2 * M_PI / std::round(share)};
}

void check_solid(const Scene& scene, const CaseTable& root) {
  const auto stages = root.tables("stage");
  const auto from = scene.solid ? static_cast<std::size_t>(scene.solid->from_stage) : scene.stages.size();
  for (std::size_t i = 0; i < from; ++i)
    if (const Tool* tool = tool_with_sections(scene, scene.stages[i]))
      core::refuse(*stages[i],
                   fmt::format("\"{}\" is not round, allowed are such tools from a stage on that has `solid = {{ "
                               "sector = \"90 deg\" }}`",
                               tool->name));
  for (std::size_t i = from; i < scene.stages.size(); ++i) {
    check_solid_stage(scene.stages[i], *stages[i]);
    for (const StageTool& entry : scene.stages[i].tools) check_room(scene, entry, *stages[i]);
    const Tool* tool = tool_with_sections(scene, scene.stages[i]);
    if (tool && scene.solid->sector < M_PI_2 * 0.999)
      core::refuse(*stages[from], fmt::format("a sector of {:g} deg was found, allowed are 90, 180 and 360 deg: the "
                                              "sections of \"{}\" have two planes of symmetry",
                                              scene.solid->sector * 180 / M_PI, tool->name));
  }
}

}  // namespace parison::forming
