// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/container/container_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "forming/scene/container/crossings.hpp"
#include "forming/scene/container/free_space.hpp"
#include "forming/scene/container/hollow.hpp"
#include "forming/scene/container/standing.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

constexpr double fits = 1e-3;  // share of the cavity that sampled outlines leave open

struct Press {
  const Stage& stage;
  Index stage_index, tool;
  Placed placed;

  std::optional<FreeRegion> cavity(double offset) {
    placed.offset[tool] = offset;
    return closed_region(placed, stage, tool);
  }
};

/// Offsets at which a driven plunger is looked at, from where it is to where it meets another tool.
std::vector<double> offsets_of_stroke(const Press& press, double sense, std::string& against) {
  std::vector<Solid> others;
  std::vector<Index> indices;
  for (const StageTool& entry : press.stage.tools)
    if (entry.tool != press.tool) {
      if (!press.placed.offset[entry.tool]) return {};
      others.push_back(press.placed.solid(entry.tool));
      indices.push_back(entry.tool);
    }
  const auto travel = free_travel(press.placed.solid(press.tool), others, sense);
  if (!travel) return {};
  against = press.placed.scene.tools[indices[travel->met]].name;
  constexpr int count = 48;
  std::vector<double> offsets;
  for (int i = 0; i <= count; ++i)
    offsets.push_back(*press.placed.offset[press.tool] + sense * travel->distance * i / count);
  return offsets;
}

/// Offset between two at which the closed cavity holds a volume, by the method of G. E. Alefeld, F. A. Potra and Y. Shi
/// (ACM Transactions on Mathematical Software 21, 1995, algorithm 748); `narrow` where it holds more there too.
double offset_of_volume(Press& press, double volume, double wide, double narrow) {
  constexpr double tolerance = 1e-12;  // of the volume
  const auto spare = [&](double offset) {
    const auto cavity = press.cavity(offset);
    const double room = cavity ? cavity->volume / volume - 1 : 1;
    return std::abs(room) < tolerance ? 0 : room;
  };
  const double at_wide = spare(wide), at_narrow = spare(narrow);
  if (at_wide <= 0) return wide;
  if (at_narrow >= 0) return narrow;
  std::uintmax_t evaluations = 60;
  const bool ordered = wide < narrow;
  const auto [low, high] = boost::math::tools::toms748_solve(
      spare, std::min(wide, narrow), std::max(wide, narrow), ordered ? at_wide : at_narrow,
      ordered ? at_narrow : at_wide, boost::math::tools::eps_tolerance<double>(), evaluations);
  return ordered ? high : low;
}

std::string volume_text(const ContainerPlan& plan) {
  return fmt::format("{:.4g} g of glass have {:.4g} cm3", 1e3 * plan.mass, 1e6 * plan.glass_volume);
}

/// The offset before its start at which a plunger leaves the glass just its room, none where it never does.
std::optional<double> full_before_start(Press& press, double sense, double volume) {
  constexpr int count = 96;
  const double start = *press.placed.offset[press.tool];
  const double step = core::size(press.placed.scene.tools[press.tool].profile) / count;
  for (int i = 1; i <= count; ++i) {
    const double offset = start - sense * i * step;
    const auto cavity = press.cavity(offset);
    if (cavity && cavity->volume >= volume) return offset_of_volume(press, volume, offset, offset + sense * step);
  }
  return {};
}

/// The name of a tool in which the foremost point of the plunger lies at its start; empty without one.
std::string holder_of_tip(const Press& press, double start, double sense) {
  const Tool& plunger = press.placed.scene.tools[press.tool];
  core::Point tip(0, -sense * HUGE_VAL);
  for (const core::Segment& segment : plunger.profile.segments)
    for (const double t : {0.0, 0.5, 1.0})
      if (const core::Point x = core::point_at(segment, t); sense * x[1] > sense * tip[1]) tip = x;
  for (const StageTool& entry : press.stage.tools) {
    const Tool& tool = press.placed.scene.tools[entry.tool];
    const double shift = start - press.placed.offset[entry.tool].value_or(0);
    if (entry.tool != press.tool && core::contains(tool.profile, tip + shift * core::axis_direction()))
      return tool.name;
  }
  return "";
}

/// A cavity too small for the glass: because the plunger starts too far in, or because there is too much glass.
void tell_too_small(Press& press, double sense, double start, double most, double most_at, ContainerPlan& plan) {
  const std::string& name = press.placed.scene.tools[press.tool].name;
  plan.misfit = fmt::format("{}, but the cavity of stage \"{}\" has at most {:.4g} cm3 (with \"{}\" at {:.4g} mm)",
                            volume_text(plan), press.stage.name, 1e6 * most, name, 1e3 * most_at);
  const std::string holder = holder_of_tip(press, start, sense);
  press.placed.offset[press.tool] = start;
  const auto full = full_before_start(press, sense, plan.glass_volume);
  if (!full) return;
  plan.misfit += fmt::format(": that tool starts {}beyond {:.4g} mm, where the cavity is full",
                             holder.empty() ? "" : fmt::format("inside \"{}\", ", holder), 1e3 * *full);
  plan.remedy = fmt::format("a `position` of \"{}\" {} {:.4g} mm, or a mass that fits", name,
                            sense > 0 ? "below" : "above", 1e3 * *full);
}

/// A plunger that a force drives stops where the glass fills the cavity.
void plan_driven(Press& press, double sense, ContainerPlan& plan) {
  std::string against;
  const double start = *press.placed.offset[press.tool];
  const std::vector<double> offsets = offsets_of_stroke(press, sense, against);
  std::optional<double> most, least, wide;
  double most_at = 0;
  for (const double offset : offsets) {
    const auto cavity = press.cavity(offset);
    if (!cavity) continue;
    if (!most || cavity->volume > *most) most = cavity->volume, most_at = offset;
    least = cavity->volume;
    if (cavity->volume >= plan.glass_volume) {
      wide = offset;
      continue;
    }
    if (!wide) wide = offset == offsets.front() ? offset : offset - (offsets[1] - offsets[0]);
    const double stop = offset_of_volume(press, plan.glass_volume, *wide, offset);
    const auto full = press.cavity(stop);
    if (!full || std::abs(full->volume - plan.glass_volume) > fits * plan.glass_volume) break;
    plan.press = PressPlan{press.stage_index, press.tool,         true, stop, full->volume, full->low, full->high,
                           full->slices,      press.placed.offset};
    return;
  }
  if (!most) return;
  const std::string& name = press.placed.scene.tools[press.tool].name;
  if (*most < plan.glass_volume)
    tell_too_small(press, sense, start, *most, most_at, plan);
  else
    plan.misfit = fmt::format(
        "{}, but the cavity of stage \"{}\" has at least {:.4g} cm3 (with \"{}\" at {:.4g} mm, where it "
        "meets \"{}\")",
        volume_text(plan), press.stage.name, 1e6 * *least, name, 1e3 * offsets.back(), against);
}

/// A plunger with a given motion has to leave the glass its room.
void plan_moved(Press& press, double end, ContainerPlan& plan) {
  const auto cavity = press.cavity(end);
  if (!cavity) return;
  plan.press = PressPlan{press.stage_index, press.tool,         false, end, cavity->volume, cavity->low, cavity->high,
                         cavity->slices,    press.placed.offset};
  if (cavity->volume < (1 - fits) * plan.glass_volume)
    plan.misfit = fmt::format("{}, but the cavity of stage \"{}\" has {:.4g} cm3 at its end", volume_text(plan),
                              press.stage.name, 1e6 * cavity->volume);
}

/// The direction along the axis in which a force drives, 1 or -1.
double sense_of(const ForceMotion& motion) {
  return motion.force.max() >= -motion.force.min() ? 1 : -1;
}

/// The motion of a tool as the press, where it closes a cavity.
void plan_motion(Press& press, const Motion& motion, const std::optional<double>& end, ContainerPlan& plan) {
  const double start = *press.placed.offset[press.tool];
  if (const auto* force = std::get_if<ForceMotion>(&motion)) plan_driven(press, sense_of(*force), plan);
  if (end && *end != start) plan_moved(press, *end, plan);
}

/// The first stage in which a moving tool closes a cavity, of a few that are looked at; gives the offsets of all tools
/// at the end.
void plan_press(const Scene& scene, Placed& placed, ContainerPlan& plan) {
  int left = 6;  // motions
  for (std::size_t i = 0; i < scene.stages.size(); ++i) {
    const Stage& stage = scene.stages[i];
    for (const StageTool& entry : stage.tools) {
      if (!entry.moves()) continue;
      const auto* position = std::get_if<PositionMotion>(&entry.motion);
      std::optional<double> end;
      if (position && !stage.may_end_early()) end = position->offset(stage.duration);
      if (!plan.press && plan.misfit.empty() && placed.offset[entry.tool] && left-- > 0) {
        Press press{stage, static_cast<Index>(i), entry.tool, placed};
        plan_motion(press, entry.motion, end, plan);
      }
      const bool is_press = plan.press && plan.press->stage == static_cast<Index>(i) && plan.press->tool == entry.tool;
      placed.offset[entry.tool] = is_press ? plan.press->stop : end;
    }
  }
}

/// Volume of the plunger between two places, as it stands when the press ends.
double plunger_volume(const Scene& scene, const PressPlan& press, double low, double high) {
  const Tool& tool = scene.tools[press.tool];
  return contact_volume({&tool.profile, contact_boundaries(tool), press.stop}, low, high);
}

/// Whether the plunger of the press is still in the last stage.
bool keeps_plunger(const Scene& scene, const ContainerPlan& plan) {
  const auto& tools = last_forming_stage(scene).tools;
  return plan.press && std::any_of(tools.begin(), tools.end(),
                                   [&](const StageTool& entry) { return entry.tool == plan.press->tool; });
}

/// Volume of a region whose sections are those of the tools that are not round, m3.
double volume_in_space(const Placed& placed, const Stage& stage, const FreeRegion& region) {
  double volume = region.volume;
  for (const StageTool& entry : stage.tools) {
    const Tool& tool = placed.scene.tools[entry.tool];
    if (tool.section.is_round()) continue;
    const auto [low, high] = contact_range(tool);
    const double offset = *placed.offset[entry.tool];
    for (const Slice& slice : region.slices) {
      const double height = 0.5 * (slice.from + slice.to) - offset;
      if (height > low && height < high) volume += (core::area_factor(tool.section, height) - 1) * slice.volume();
    }
  }
  return volume;
}

/// Rim, capacity and what it holds to the fill level.
void plan_capacity(const Scene& scene, const Placed& placed, ContainerPlan& plan) {
  const Stage& last = last_forming_stage(scene);
  if (last.gravity == 0) return;
  const bool rim_is_low = last.gravity > 0;
  const auto mould = keeps_plunger(scene, plan) ? std::nullopt : closed_region(placed, last, {});
  if (mould) {
    plan.outside = volume_in_space(placed, last, *mould);
    plan.mould_range = {mould->low, mould->high};
    plan.falls = why_it_falls(*mould, rim_is_low ? -1 : 1);
    plan.rim = rim_is_low ? mould->low : mould->high;
    plan.capacity = *plan.outside - plan.glass_volume;
    if (plan.misfit.empty() && *plan.outside < (1 - fits) * plan.glass_volume)
      plan.misfit = fmt::format("{}, but the cavity of stage \"{}\" has {:.4g} cm3", volume_text(plan), last.name,
                                1e6 * *plan.outside);
  } else if (plan.press) {
    const auto hollow = hollow_of(plan.press->glass, rim_is_low ? -1 : 1);
    if (!hollow) return;
    plan.rim = hollow->rim;
    plan.capacity = hollow->capacity;
    if (scene.output.fill_level) plan.filled = hollow->to_depth(*scene.output.fill_level);
    return;
  }
  if (!plan.press || !plan.capacity || !scene.output.fill_level) return;
  const double level = *scene.output.fill_level;
  if (level >= inside_height(plan)) return;
  plan.filled = *plan.capacity - (rim_is_low ? plunger_volume(scene, *plan.press, *plan.rim, *plan.rim + level)
                                             : plunger_volume(scene, *plan.press, *plan.rim - level, *plan.rim));
}

/// What gives the parison its outside: the cavity of the press, or the last one that the tools of a stage close around
/// glass that air blows up, before a mould of the last stage comes.
void plan_parison(const Scene& scene, const Placed& placed, ContainerPlan& plan) {
  if (plan.press) {
    plan.parison =
        ParisonPlan{plan.press->stage, plan.press->tool, plan.press->low, plan.press->high, plan.press->cavity};
    return;
  }
  Index mould = 0;  // first use of the tool of the last stage that comes last
  for (const StageTool& entry : last_forming_stage(scene).tools) mould = std::max(mould, first_use(scene, entry.tool));
  for (Index i = mould - 1; i >= 0; --i) {
    const Stage& stage = scene.stages[static_cast<std::size_t>(i)];
    if (!stage.blows()) continue;
    if (const auto cavity = closed_region(placed, stage, {})) {
      plan.parison = ParisonPlan{i, {}, cavity->low, cavity->high, cavity->volume};
      return;
    }
  }
}

/// The largest share by which the volumes of mould and press differ from those within chords of the outlines.
double difference_by_chords(const Scene& scene, Placed placed, const ContainerPlan& plan) {
  placed.draw_chords();
  const auto difference = [](double volume, const std::optional<FreeRegion>& other) {
    return other ? std::abs(other->volume / volume - 1) : 1;
  };
  double largest = 0;
  if (plan.outside) {
    auto region = closed_region(placed, last_forming_stage(scene), {});
    if (region) region->volume = volume_in_space(placed, last_forming_stage(scene), *region);
    largest = difference(*plan.outside, region);
  }
  if (!plan.press) return largest;
  for (std::size_t i = 0; i < plan.press->offsets.size(); ++i) placed.offset[i] = plan.press->offsets[i];
  const Stage& stage = scene.stages[plan.press->stage];
  return std::max(largest, difference(plan.press->cavity, closed_region(placed, stage, plan.press->tool)));
}

}  // namespace

bool is_upright(const Scene& scene, std::size_t stage) {
  for (std::size_t i = stage + 1; i-- > 0;)
    if (const double gravity = scene.stages[i].gravity; gravity != 0) return gravity < 0;
  return true;
}

std::optional<double> inside_height(const ContainerPlan& plan) {
  if (plan.mould_range) return plan.mould_range->second - plan.mould_range->first;
  if (plan.press) return plan.press->high - plan.press->low;
  return {};
}

std::optional<double> full_offset(const Scene& scene, const std::vector<double>& offset, Index stage, Index tool,
                                  double volume) {
  const Stage& present = scene.stages[stage];
  const auto entry = std::find_if(present.tools.begin(), present.tools.end(),
                                  [&](const StageTool& candidate) { return candidate.tool == tool; });
  Press press{present, stage, tool, {scene, {offset.begin(), offset.end()}, {}}};
  const auto cavity = press.cavity(offset[tool]);
  if (!cavity) return {};
  if (cavity->volume <= (1 + fits) * volume) return offset[tool];
  ContainerPlan plan{};
  plan.glass_volume = volume;
  plan_driven(press, sense_of(std::get<ForceMotion>(entry->motion)), plan);
  if (!plan.press) return {};
  return plan.press->stop;
}

const Stage& last_forming_stage(const Scene& scene) {
  const auto found =
      std::find_if(scene.stages.rbegin(), scene.stages.rend(), [](const Stage& one) { return !one.cools; });
  return found == scene.stages.rend() ? scene.stages.back() : *found;
}

std::optional<ContainerPlan> plan_container(const Scene& scene) {
  if (scene.geometry != core::Geometry::axisymmetric || !scene.has_flow() || scene.tools.empty()) return {};
  const DimensionlessNumbers numbers = dimensionless_numbers(scene);
  ContainerPlan plan{numbers.mass, numbers.volume, {}, {}, "a mass that fits", {}, {}, {}, {}, {}, {}, 0};
  Placed placed{scene, {}, {}};
  for (const Tool& tool : scene.tools) placed.offset.emplace_back(tool.position);
  plan_press(scene, placed, plan);
  plan_capacity(scene, placed, plan);
  plan_parison(scene, placed, plan);
  plan.doubt = difference_by_chords(scene, placed, plan);
  return plan;
}

}  // namespace parison::forming
