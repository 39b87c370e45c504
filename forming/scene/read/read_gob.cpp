// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>

#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using core::Point;
using core::Segment;
namespace dimension = core::dimension;

constexpr core::Dimension mass_dimension{0, 1};

Segment arc_of(const Point& centre, double radius, double from, double to, const Point& start, const Point& end) {
  Segment arc{start, end};
  arc.is_arc = true;
  arc.centre = centre;
  arc.radius = radius;
  arc.from = from;
  arc.to = to;
  return arc;
}

/// The point that stays where it is, on the axis.
Point pole_of(const CaseNode& node, double size) {
  const Point at = read_point(node);
  if (std::abs(at[0]) > tolerance::joined * std::max(size, std::abs(at[1])))
    core::refuse(node, fmt::format("\"{}\" was found, allowed are points on the axis", node.text));
  return Point(0, at[1]);
}

double sphere_volume(double diameter) {
  return M_PI / 6 * std::pow(diameter, 3);
}

void check_length(const CaseTable& table, double volume, double diameter) {
  constexpr double longest = 100;  // diameters, of the straight part
  const double sphere = sphere_volume(diameter);
  const CaseNode& node = table.get("diameter");
  if (volume < (1 - 1e-9) * sphere)
    core::refuse(node, fmt::format("a sphere of {:.4g} mm has more than the gob's {:.4g} cm3, allowed is a diameter of "
                                   "up to {:.4g} mm",
                                   1e3 * diameter, 1e6 * volume, 1e3 * std::cbrt(6 * volume / M_PI)));
  const double length = (volume - sphere) / (M_PI / 4 * diameter * diameter);
  if (!(length <= longest * diameter))
    core::refuse(node,
                 fmt::format("the gob would be {:.3g} m long, allowed are up to {:g} diameters", length, longest));
}

/// Draws a capsule with its lower pole at `at`; one that is laid down has names for its sides. Without a diameter it is
/// a sphere until it takes the shape of its room.
void draw_capsule(const CaseTable& table, double volume, Glass& glass) {
  const bool is_laid = table.find("in") != nullptr, takes_shape = is_laid && !table.find("diameter");
  const double diameter =
      takes_shape ? std::cbrt(6 * volume / M_PI) : core::positive(table.get("diameter"), dimension::length);
  if (!takes_shape) check_length(table, volume, diameter);
  auto& segments = glass.profile.segments;
  segments = capsule(volume, diameter, is_laid ? 0 : pole_of(table.get("at"), diameter)[1]);
  glass.boundaries = {{is_laid ? "side" : "surface", BoundaryKind::contact, {}, {}}};
  if (is_laid) {
    (segments.end() - 2)->boundary_id = 1;
    glass.boundaries.push_back({"top", BoundaryKind::contact, {}, {}});
  }
  segments.back().boundary_id = static_cast<Index>(glass.boundaries.size());
  glass.boundaries.push_back({"axis", BoundaryKind::symmetry, {}, {}});
  for (const Boundary& boundary : glass.boundaries) glass.profile.boundary_names.push_back(boundary.name);
}

/// The lowest point of an outline on the axis.
Point lower_pole(const CaseNode& node, const Body& body) {
  const double on_axis = tolerance::joined * core::size(body.profile);
  double lowest = HUGE_VAL;
  for (const Segment& segment : body.profile.segments)
    if (std::abs(segment.start[0]) <= on_axis) lowest = std::min(lowest, segment.start[1]);
  if (!std::isfinite(lowest))
    core::refuse(node, "the outline does not meet the axis, allowed is \"at\" with a point there");
  return Point(0, lowest);
}

/// Scales the drawn outline about a point of the axis.
void scale_outline(const CaseTable& table, double volume, Glass& glass) {
  if (const auto* item = table.find("diameter"))
    core::refuse(*item, "a diameter and a boundary were found, allowed is one of them");
  const auto* at = table.find("at");
  const Point fixed = at ? pole_of(*at, core::size(glass.profile)) : lower_pole(table.node(), glass);
  scale_to(glass.profile, volume, fixed);
}

}  // namespace

void scale_to(core::Profile& profile, double volume, const Point& fixed) {
  const double factor = std::cbrt(volume / outline_volume(profile, core::Geometry::axisymmetric));
  for (Segment& segment : profile.segments) {
    for (Point* x : {&segment.start, &segment.end, &segment.centre}) *x = fixed + factor * (*x - fixed);
    segment.radius *= factor;
  }
}

std::vector<Segment> capsule(double volume, double diameter, double pole) {
  const double radius = diameter / 2;
  const double length = std::max(0.0, (volume - sphere_volume(diameter)) / (M_PI * radius * radius));
  const Point below(0, pole + radius), above(0, pole + radius + length);
  const Point low(0, pole), high(0, pole + 2 * radius + length), first(radius, below[1]), second(radius, above[1]);
  std::vector<Segment> segments{arc_of(below, radius, -M_PI / 2, 0, low, first)};
  if (length > tolerance::joined * diameter) segments.push_back({first, second});
  segments.push_back(arc_of(above, radius, 0, M_PI / 2, segments.back().end, high));
  segments.push_back({high, low});
  return segments;
}

std::vector<std::string> gob_keys() {
  return {"mass", "diameter", "at", "in"};
}

void read_gob(const CaseNode& node, core::Geometry geometry, Glass& glass) {
  const CaseTable table(node, gob_keys());
  const auto *in = table.find("in"), *at = table.find("at");
  if (in && at) core::refuse(*in, "\"at\" and \"in\" were found, allowed is one of them");
  if (!in && !at && glass.boundaries.empty())
    core::refuse(
        node,
        "neither \"in\" nor \"at\" was found, allowed is in = \"blank\", the tool into which the gob is laid, or "
        "at = \"(0, 20) mm\", its lower pole");
  if (geometry != core::Geometry::axisymmetric)
    core::refuse(node, "a gob was found in a planar scene, allowed is a boundary");
  const double mass = core::positive(table.get("mass"), mass_dimension), volume = mass / glass.density();
  constexpr double least = 1e-15, most = 1e3;  // m3
  if (!(volume >= least && volume <= most))
    core::refuse(table.get("mass"),
                 fmt::format("a gob of {:.3g} cm3 was found, allowed are volumes from {:g} to {:g} cm3", 1e6 * volume,
                             1e6 * least, 1e6 * most));
  if (glass.boundaries.empty())
    draw_capsule(table, volume, glass);
  else
    scale_outline(table, volume, glass);
}

GobSkin read_skin(const CaseNode& node, const Glass& glass) {
  const CaseTable table(node, {"temperature", "depth"});
  if (!glass.thermal) core::refuse(node, "the glass carries no heat, this key is allowed only where it does");
  const auto& temperature = table.get("temperature");
  const GobSkin skin{core::quantity(temperature, dimension::temperature),
                     core::positive(table.get("depth"), dimension::length)};
  if (glass.flow && !glass.flow->viscosity.constant && skin.temperature <= glass.flow->viscosity.T0)
    core::refuse(temperature,
                 fmt::format("\"{}\" was found, allowed are temperatures above T0 of the viscosity", temperature.text));
  return skin;
}

void check_gob(const Scene& scene, const CaseNode& glass) {
  for (const auto& item : glass.items) {
    if (item.name != "gob") continue;
    const auto& plan = scene.container;
    if (plan && !plan->misfit.empty()) core::refuse(item, fmt::format("{}; allowed is {}", plan->misfit, plan->remedy));
  }
}

}  // namespace parison::forming
