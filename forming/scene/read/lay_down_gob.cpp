// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "forming/scene/container/free_space.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/read/gob_shape.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;

/// Lowest and highest place along the axis of an outline, m, or of those of its boundaries that count.
std::pair<double, double> range_of(const core::Profile& profile, const std::vector<bool>& counts) {
  std::pair<double, double> range{HUGE_VAL, -HUGE_VAL};
  for (const core::Segment& segment : profile.segments)
    if (counts.empty() || counts[segment.boundary_id])
      for (const double t : {0.0, 0.5, 1.0}) {
        const double z = core::point_at(segment, t)[1];
        range = {std::min(range.first, z), std::max(range.second, z)};
      }
  return range;
}

/// The place of an outline that has to lie in the tool that takes it in, m: its middle, or its widest place where that
/// is lower and the gob stands out by no more than its width. So it may stand out of a shallow mould, but not lie on
/// the rim of a narrow one.
double place_inside(const core::Profile& profile, double sense) {
  const auto [low, high] = range_of(profile, {});
  double widest = 0, place = HUGE_VAL;  // rising against gravity
  for (const core::Segment& segment : profile.segments)
    for (const double t : {0.0, 0.5, 1.0}) {
      const core::Point x = core::point_at(segment, t);
      const bool is_wider = x[0] > widest * (1 + tolerance::joined);
      if (is_wider || x[0] > widest * (1 - tolerance::joined))
        place = std::min(is_wider ? HUGE_VAL : place, -sense * x[1]);
      widest = std::max(widest, x[0]);
    }
  const double end = sense < 0 ? high : -low;
  return -sense * std::min(std::max(place, end - 2 * widest), -sense * (low + high) / 2);
}

/// The first stage as a gob that is laid down finds it.
struct Bed {
  const Scene& scene;
  const Tool& taker;  ///< the tool that takes the gob in

  double sense() const { return scene.stages.front().gravity < 0 ? -1 : 1; }

  /// The tools of the first stage, without those that move in some stage where these are left out.
  std::vector<Solid> solids(bool with_moving) const {
    const auto all = static_cast<Index>(scene.stages.size());
    std::vector<Solid> found;
    for (const StageTool& entry : scene.stages.front().tools) {
      const Tool& tool = scene.tools[entry.tool];
      if (with_moving || !has_moved_before(scene, all, entry.tool))
        found.push_back({&tool.profile, contact_boundaries(tool), tool.position});
    }
    return found;
  }

  /// The shift that brings an outline to rest inside the taker's contact boundaries; nothing where there is no such
  /// place.
  std::optional<double> shift_of(const core::Profile& outline, bool with_moving = true) const {
    const double place = place_inside(outline, sense());
    const auto [bottom, top] = range_of(taker.profile, contact_boundaries(taker));
    std::optional<double> found;
    for (const FreeShifts& range : free_shifts({&outline, {}, 0}, solids(with_moving))) {
      const double shift = sense() < 0 ? range.low.shift : range.high.shift;
      const double inside = place + shift - taker.position;
      // Of several the first that is met on the way down.
      if (std::isfinite(shift) && inside > bottom && inside < top && (!found || sense() * shift < sense() * *found))
        found = shift;
    }
    return found;
  }

  /// The room that the taker gives to a gob of some size, m.
  GobRoom room(double size) const {
    const auto [bottom, top] = range_of(taker.profile, contact_boundaries(taker));
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Solid& solid : solids(true)) {
      const auto range = range_of(*solid.profile, solid.contact);
      low = std::min(low, range.first + solid.shift);
      high = std::max(high, range.second + solid.shift);
    }
    (sense() < 0 ? high : low) = (sense() < 0 ? top : bottom) + taker.position;  // nothing stands out of the taker
    return {solids(true), low, high, -sense(), tolerance::sealed * size};
  }
};

/// The diameters of a capsule of a volume that find room, m; nothing where none does.
std::optional<std::pair<double, double>> fitting_diameters(const Bed& bed, double volume) {
  constexpr int count = 60, halvings = 12;
  const double sphere = std::cbrt(6 * volume / M_PI);
  const auto fits = [&](double diameter) {
    core::Profile outline;
    outline.segments = capsule(volume, diameter, 0);
    return bed.shift_of(outline).has_value();
  };
  const auto edge = [&](double inside, double outside) {
    for (int i = 0; i < halvings; ++i) {
      const double middle = (inside + outside) / 2;
      (fits(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  std::optional<std::pair<double, double>> found;
  for (int i = count; i > count / 10; --i) {
    const double diameter = sphere * i / count, next = sphere * (i + 1) / count;
    if (!fits(diameter)) {
      if (found) return std::pair{edge(found->first, diameter), found->second};
    } else if (!found) {
      found = {diameter, i == count ? sphere : edge(diameter, next)};
    } else {
      found->first = diameter;
    }
  }
  return found;
}

/// Refuses a mass for which no capsule finds room, with what does.
[[noreturn]] void refuse_mass(const core::CaseTable& gob, const Bed& bed, double volume) {
  const core::CaseNode& mass = gob.get("mass");
  const std::string& in = gob.get("in").text;
  const double most = shape_gob(bed.room(std::cbrt(volume)), volume).most;
  const std::string largest =
      fmt::format("{:.4g} g", 1e3 * 0.999 * most / volume * core::quantity(mass, core::Dimension{0, 1}));
  const auto* diameter = gob.find("diameter");
  std::string allowed = most <= 0       ? "is a mass that does"
                        : !diameter     ? "are up to " + largest
                        : most < volume ? fmt::format("are up to {} without a diameter", largest)
                                        : "is one without a diameter";
  if (diameter && most > 0) allowed += fmt::format(", for a gob that takes the shape of \"{}\"", in);
  if (most < volume) allowed += ", or a tool that starts further away or comes in a later stage";
  core::refuse(mass, fmt::format("{:.4g} cm3 of glass find no room in \"{}\" with the tools of the first stage{}; "
                                 "allowed {}",
                                 1e6 * volume, in, diameter ? ", whatever their diameter" : "", allowed));
}

[[noreturn]] void refuse_gob(const core::CaseTable& gob, const Bed& bed, double volume) {
  const std::string& in = gob.get("in").text;
  const auto* item = gob.find("diameter");
  if (!item)
    core::refuse(gob.get("in"),
                 fmt::format("the outline of the glass finds no room in \"{}\" with the tools of the first "
                             "stage, allowed is one that does, or \"at\"",
                             in));
  const double diameter = core::quantity(*item, core::dimension::length);
  const auto fit = fitting_diameters(bed, volume);
  if (!fit) refuse_mass(gob, bed, volume);
  const double low = 0.01 * std::ceil(1e5 * fit->first), high = 0.01 * std::floor(1e5 * fit->second);
  const std::string allowed =
      fmt::format("allowed for this mass are {:.4g} to {:.4g} mm", std::min(low, high), std::max(low, high));
  if (diameter > fit->second)
    core::refuse(*item, fmt::format("a gob of {:.4g} mm is {:.3g} mm too wide to lie in \"{}\", {}", 1e3 * diameter,
                                    1e3 * (diameter - fit->second), in, allowed));
  const auto length = [&](double d) { return d + (volume - M_PI / 6 * d * d * d) / (M_PI / 4 * d * d); };
  core::refuse(*item,
               fmt::format("a gob of {:.4g} mm is {:.4g} mm long, {:.3g} mm too long for \"{}\", {}", 1e3 * diameter,
                           1e3 * length(diameter), 1e3 * (length(diameter) - length(fit->first)), in, allowed));
}

void move(core::Profile& profile, double shift) {
  for (core::Segment& segment : profile.segments)
    for (core::Point* x : {&segment.start, &segment.end, &segment.centre}) (*x)[1] += shift;
}

/// Gives a gob that is a sphere the shape of its room.
void take_shape(const core::CaseTable& gob, const Bed& bed, core::Profile& profile) {
  const double volume = 4.0 / 3 * M_PI * std::pow(profile.segments.front().radius, 3);
  GobShape shape = shape_gob(bed.room(core::size(profile)), volume);
  if (shape.sides.empty()) refuse_mass(gob, bed, volume);
  for (std::size_t i = 0; i < shape.tops; ++i) shape.sides[shape.first_top + i].boundary_id = 1;
  core::Segment axis = profile.segments.back();
  axis.start = shape.sides.back().end;
  axis.end = shape.sides.front().start;
  profile.segments = std::move(shape.sides);
  profile.segments.push_back(axis);
  scale_to(profile, volume, axis.end);
}

/// Gives the names of a capsule's sides to those that gravity makes them: the upper half sphere is the lower one then.
void turn_names(Glass& glass) {
  auto& segments = glass.profile.segments;
  for (std::size_t i = 1; i + 1 < segments.size(); ++i) segments[i].boundary_id = 1;
  std::swap(glass.boundaries[0].name, glass.boundaries[1].name);
  std::swap(glass.profile.boundary_names[0], glass.profile.boundary_names[1]);
}

}  // namespace

void lay_down_gob(const core::CaseTable& root, const BodyContext& context, Scene& scene) {
  const core::CaseTable glass(root.get("glass"), glass_keys());
  const auto* node = glass.find("gob");
  if (!node) return;
  const core::CaseTable gob(*node, gob_keys());
  const auto* in = gob.find("in");
  if (!in) return;
  const Stage& first = scene.stages.front();
  std::vector<std::string> names;
  for (const StageTool& entry : first.tools) names.push_back(scene.tools[entry.tool].name);
  if (names.empty() || first.gravity == 0)
    core::refuse(*in, fmt::format("the first stage, \"{}\", has no {}, allowed is \"at\" with the place of the gob",
                                  first.name, names.empty() ? "tools" : "gravity that lays the gob down"));
  const Bed bed{scene, scene.tools[first.tools[static_cast<std::size_t>(core::choice(*in, names))].tool]};
  if (gob.find("diameter") && first.gravity > 0) turn_names(scene.glass);
  if (!gob.find("diameter") && !glass.find("boundary")) take_shape(gob, bed, scene.glass.profile);
  auto shift = bed.shift_of(scene.glass.profile);
  // Without room under a tool that moves, that tool starts too near: the check of overlaps says where it would not.
  if (!shift) shift = bed.shift_of(scene.glass.profile, false);
  if (!shift) refuse_gob(gob, bed, outline_volume(scene.glass.profile, scene.geometry));
  move(scene.glass.profile, *shift);
  read_glass_temperature(glass, context, scene.glass);
}

}  // namespace parison::forming
