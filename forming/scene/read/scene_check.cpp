// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/describe/support.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

/// Points along an outline, dense enough to find an overlap deeper than `touching`, m.
std::vector<core::Point> samples(const core::Profile& profile, double touching) {
  double perimeter = 0;
  for (const auto& segment : profile.segments) perimeter += core::length(segment);
  return core::polyline(profile, perimeter / 2000, touching / 2);
}

struct OverlapPoint {
  core::Point point;
  double depth;  ///< m
};

/// The one of `points`, moved by `shift`, that lies deepest inside the outline.
OverlapPoint max_overlap_point(const std::vector<core::Point>& points, const core::Point& shift,
                               const core::Profile& profile) {
  OverlapPoint result{core::Point::Zero(), 0};
  for (const auto& x : points)
    if (core::contains(profile, x + shift))
      if (const double depth = core::distance(profile, x + shift); depth > result.depth) result = {x, depth};
  return result;
}

/// The deepest overlap of the glass and a tool that has moved by `shift` along the axis, at the place in space.
struct GlassAndTool {
  const Glass& glass;
  const Tool& tool;
  std::vector<core::Point> of_glass, of_tool;

  OverlapPoint overlap(double shift) const {
    const core::Point moved = shift * core::axis_direction();
    const OverlapPoint inside = max_overlap_point(of_glass, -moved, tool.profile);
    OverlapPoint other = max_overlap_point(of_tool, moved, glass.profile);
    other.point += moved;
    return other.depth > inside.depth ? other : inside;
  }

  /// The position next to a given one, in one sense along the axis, at which they do not overlap; none within their
  /// sizes.
  std::optional<double> free_position(double sense, double touching) const {
    constexpr int steps = 24, halvings = 24;
    const double reach = core::size(glass.profile) + core::size(tool.profile);
    double taken = tool.position;
    for (int i = 1; i <= steps; ++i) {
      double free = tool.position + sense * reach * i / steps;
      if (overlap(free).depth <= touching) {
        for (int k = 0; k < halvings; ++k) {
          const double middle = 0.5 * (free + taken);
          (overlap(middle).depth > touching ? taken : free) = middle;
        }
        return free;
      }
      taken = free;
    }
    return {};
  }
};

/// The `position` at which a tool that moves in some stage would only touch the glass, as advice; empty without one.
std::string advised_position(const Scene& scene, const GlassAndTool& pair, Index index, double touching) {
  const bool moves = has_moved_before(scene, static_cast<Index>(scene.stages.size()), index);
  constexpr std::size_t most_work = 2'000'000;  // points times segments
  const std::size_t work = pair.of_glass.size() * pair.tool.profile.segments.size() +
                           pair.of_tool.size() * pair.glass.profile.segments.size();
  if (!moves || work > most_work) return "";
  const auto low = pair.free_position(-1, touching), high = pair.free_position(1, touching);
  if (!low && !high) return "";
  const double at = pair.tool.position;
  const bool is_low = low && (!high || at - *low <= *high - at);
  // Rounded away from the glass to a hundredth of a millimetre.
  const double rounded = is_low ? 1e-5 * std::floor(1e5 * *low + 1e-6) : 1e-5 * std::ceil(1e5 * *high - 1e-6);
  return fmt::format("; with `position = \"{:.6g} mm\"` in place of {:.6g} mm the tool would not", 1e3 * rounded,
                     1e3 * at);
}

bool can_touch(const Body& body) {
  const auto contact = [](const Boundary& boundary) { return boundary.kind == BoundaryKind::contact; };
  return std::any_of(body.boundaries.begin(), body.boundaries.end(), contact);
}

/// Refuses an edge length that would give a body too many cells, taken over its whole area, or too many edges.
void refuse_too_fine(const core::CaseNode& at, const Body& body, double size, bool whole_area) {
  constexpr double max_cells = 500000, max_edges = 50000;
  double outline = 0;
  for (const auto& segment : body.profile.segments) outline += core::length(segment);
  const double cells = std::abs(core::signed_area(body.profile)) / (std::sqrt(3.0) / 4 * size * size);
  if (whole_area && cells > max_cells)
    core::refuse(at, fmt::format("{:g} mm would give \"{}\" about {:.2g} cells, allowed are sizes that give up to {:g}",
                                 1e3 * size, body.name, cells, max_cells));
  if (outline / size > max_edges)
    core::refuse(at, fmt::format("{:g} mm would give \"{}\" about {:.2g} edges along its outline, allowed are sizes "
                                 "that give up to {:g}",
                                 1e3 * size, body.name, outline / size, max_edges));
}

void check_mesh_sizes(const core::CaseNode& node, const Body& body) {
  const auto* mesh = core::member(node, "mesh");
  if (const auto& size = body.mesh.size) refuse_too_fine(*core::member(*mesh, "size"), body, *size, true);
  if (const auto& size = body.mesh.contact_size)
    refuse_too_fine(*core::member(*mesh, "contact_size"), body, *size, false);
  constexpr double max_quadrangles = 250000;
  if (const auto& mapped = body.mesh.mapped;
      mapped && double(mapped->along_first) * mapped->along_second > max_quadrangles)
    core::refuse(*core::member(*mesh, "mapped"),
                 fmt::format("{} by {} divisions were found, allowed are up to {:g} in all", mapped->along_first,
                             mapped->along_second, max_quadrangles));
}

}  // namespace

void check_sizes(const Scene& scene, const core::CaseTable& root) {
  const auto &glass = root.get("glass"), *numerics = root.find("numerics");
  const auto tools = root.tables("tool");
  const auto place = [&](const char* key, const core::CaseNode& body) -> const core::CaseNode& {
    const auto* item = numerics ? core::member(*numerics, key) : nullptr;
    return item ? *item : body;
  };
  check_mesh_sizes(glass, scene.glass);
  if (scene.has_flow() || (!scene.glass.mesh.size && !scene.glass.mesh.mapped))
    refuse_too_fine(place("surface_size", glass), scene.glass, scene.accuracy.surface_size, true);
  refuse_too_fine(place("skin_size", glass), scene.glass, scene.accuracy.skin_size, false);
  for (std::size_t i = 0; i < tools.size(); ++i) {
    check_mesh_sizes(*tools[i], scene.tools[i]);
    refuse_too_fine(place("tool_contact_size", *tools[i]), scene.tools[i], scene.accuracy.tool_contact_size, false);
  }
}

void refuse_repeated_names(const std::vector<const core::CaseNode*>& tables) {
  constexpr std::size_t most = 1000;
  if (tables.size() > most)
    core::refuse(*tables[most], fmt::format("{} tables were found, allowed are up to {}", tables.size(), most));
  std::set<std::string> names;
  for (const auto* table : tables)
    for (const auto& item : table->items)
      if (item.name == "name") {
        if (!names.insert(core::text(item)).second)
          core::refuse(item, fmt::format("\"{}\" was found twice, allowed are different names", item.text));
      }
}

void check_no_overlap(const Scene& scene, const std::vector<const core::CaseNode*>& tools) {
  if (scene.stages.empty()) return;
  const double touching = tolerance::initial_overlap * core::size(scene.glass.profile);
  const auto glass = samples(scene.glass.profile, touching);
  const auto by_height = [](const core::Point& a, const core::Point& b) { return a[1] < b[1]; };
  const auto [low, high] = std::minmax_element(glass.begin(), glass.end(), by_height);
  const double lowest = (*low)[1], highest = (*high)[1];
  for (const auto& entry : scene.stages.front().tools) {
    const auto& tool = scene.tools[entry.tool];
    const GlassAndTool pair{scene.glass, tool, glass, samples(tool.profile, touching)};
    const OverlapPoint inside = pair.overlap(tool.position);
    if (inside.depth > touching)
      core::refuse(
          *tools[entry.tool],
          fmt::format("\"{}\" overlaps the glass at the start by {:.3g} mm, near ({:g}, {:g}) mm; allowed is "
                      "contact to within {:.2g} mm; the glass lies between {:.4g} and {:.4g} mm along the axis{}",
                      tool.name, 1e3 * inside.depth, 1e3 * inside.point[0], 1e3 * inside.point[1], 1e3 * touching,
                      1e3 * lowest, 1e3 * highest, advised_position(scene, pair, entry.tool, touching)));
  }
}

void check_interfaces(const Scene& scene, const std::vector<const core::CaseNode*>& stages) {
  if (!scene.has_heat()) return;
  bool glass_can_touch = can_touch(scene.glass);
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    glass_can_touch = glass_can_touch || !scene.stages[i].named_boundaries.empty();  // a named boundary may touch
    if (!glass_can_touch) continue;
    for (const auto& entry : scene.stages[i].tools) {
      const auto& tool = scene.tools[entry.tool];
      const auto joins = [&](const Interface& interface) { return interface.tool == entry.tool; };
      if (!tool.thermal || !can_touch(tool) || std::any_of(scene.interfaces.begin(), scene.interfaces.end(), joins))
        continue;
      core::CaseNode place = *stages[i];
      place.key += ".tools";
      core::refuse(place,
                   fmt::format("the glass and \"{}\" can touch in stage \"{}\" but have no interface; allowed is an "
                               "[[interface]] that names the tool",
                               tool.name, scene.stages[i].name));
    }
  }
}

void check_motions(const Scene& scene, const std::vector<const core::CaseNode*>& stages) {
  const double same_place = core::tolerance::motion_start * core::size(scene.glass.profile);
  std::vector<std::optional<double>> at;  // of each tool, where it is known
  for (const Tool& tool : scene.tools) at.emplace_back(tool.position);
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    for (const StageTool& entry : scene.stages[i].tools) {
      const auto* position = std::get_if<PositionMotion>(&entry.motion);
      if (!position) {
        if (entry.is_driven()) at[entry.tool].reset();
        continue;
      }
      const double first = position->offset(0);
      if (at[entry.tool] && std::abs(*at[entry.tool] - first) > same_place) {
        core::CaseNode place = *stages[i];
        place.key += ".motion." + scene.tools[entry.tool].name;
        core::refuse(
            place,
            fmt::format("starts at {:g} mm, but the tool is at {:g} mm then; allowed is a motion that starts there",
                        1e3 * first, 1e3 * *at[entry.tool]));
      }
      at[entry.tool].reset();
      if (!scene.stages[i].may_end_early()) at[entry.tool] = position->offset(scene.stages[i].duration);
    }
}

void check_standing(const Scene& scene, const core::CaseTable& root) {
  if (!scene.container || scene.container->falls.empty()) return;
  const auto stages = root.tables("stage");
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (const Stage& stage = scene.stages[i]; stage.cools && stage.gravity != 0 && !stage.tools.empty())
      core::refuse(*core::member(*stages[i], "kind"),
                   scene.container->falls +
                       "; allowed is one with a flat bottom or a foot ring, or a last stage that "
                       "forms");
}

void check_support(const Scene& scene, const core::CaseTable& root) {
  if (!scene.has_flow()) return;
  const auto& boundaries = scene.glass.boundaries;
  if (std::all_of(boundaries.begin(), boundaries.end(), [](const Boundary& boundary) {
        return boundary.kind == BoundaryKind::fixed || boundary.kind == BoundaryKind::symmetry;
      }))
    core::refuse(
        *core::member(root.get("glass"), "boundary"),
        "every boundary is fixed or a symmetry plane, so the pressure of the glass has no reference value; allowed is "
        "at least one boundary that is neither");
  if (constrained_along_axis(scene.glass)) return;
  const auto stages = root.tables("stage");
  bool named = false;  // a boundary that may touch
  for (std::size_t i = 0; i < stages.size(); ++i) {
    named = named || !scene.stages[i].named_boundaries.empty();
    if (!scene.stages[i].tools.empty() && (named || can_touch(scene.glass))) continue;
    if (scene.stages[i].gravity == 0 && scene.stages[i].pressure.empty()) continue;  // it floats
    core::CaseNode place = *stages[i];
    place.key += ".tools";
    core::refuse(
        place, fmt::format("nothing constrains the glass along the axis in stage \"{}\"; allowed is a tool that it can "
                           "touch, a fixed boundary, a symmetry plane across the axis, or neither gravity nor pressure",
                           scene.stages[i].name));
  }
}

}  // namespace parison::forming
