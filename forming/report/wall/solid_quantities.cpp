// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/wall/solid_quantities.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/numbers.hpp"
#include "core/solid/hex_geometry.hpp"
#include "forming/report/wall/meridian.hpp"
#include "forming/solid/solid_memory.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

namespace {

Point in_plane(const core::Vector3& at) {
  return {std::hypot(at[0], at[1]), at[2]};
}

constexpr std::size_t meridians = 3, places = (profile_points - meridians + 1) / meridians;

/// Thickness, mm, at even shares of the arc of each meridian.
std::vector<double> profile_of(const SolidState& solid, const SolidWall& wall) {
  std::vector<double> profile;
  for (const EvenMeridian& meridian : even_meridians(solid, wall, places)) {
    if (!profile.empty()) profile.push_back(core::none);
    for (const MeridianPoint& point : meridian.points) profile.push_back(1e3 * point.thickness);
  }
  profile.resize(profile_points, core::none);
  return profile;
}

/// Of the outer side, by area, K.
double skin_temperature(const SolidWall& wall) {
  double sum = 0, area = 0;
  for (const SolidWallPoint& point : wall.points) {
    sum += point.area * point.outer_temperature;
    area += point.area;
  }
  return sum / area;
}

void set(Quantities& quantities, const char* name, double value) {
  for (Quantity& quantity : quantities.values)
    if (quantity.name == name) quantity.value = value;
}

}  // namespace

std::optional<MeridianPlace> meridian_place(std::size_t profile_point) {
  const std::size_t meridian = profile_point / (places + 1), place = profile_point % (places + 1);
  if (meridian >= meridians || place == places) return {};
  return MeridianPlace{static_cast<int>(meridian), double(place) / double(places - 1)};
}

void put_solid(const SolidState& solid, const SolidWall& wall, Summary& summary) {
  GlassFacts& glass = summary.glass;
  glass.volume = whole_volume(solid);
  glass.mass = solid.point_mass.sum() / solid.share;
  glass.mean = mean_temperature(solid);
  glass.lowest = solid.glass.temperature.minCoeff();
  glass.highest = solid.glass.temperature.maxCoeff();
  const SolidWallPoint &thinnest = wall.points[wall.thinnest], &thickest = wall.points[wall.thickest];
  summary.thickness = {thinnest.thickness, wall.mean, thickest.thickness, in_plane(thinnest.at), in_plane(thickest.at)};
  summary.beside_finish = thickness_range({});
  summary.no_wall.clear();
  summary.outer_within_02mm = remembers(solid) ? core::none : wall.near_tools;
  summary.capacity_in_space = wall.capacity;
  summary.heat_lost.to_tools += solid.totals.to_tools / solid.share;
  summary.heat_lost.to_air += solid.totals.to_air / solid.share;
  summary.heat_lost.light_to_air += solid.totals.light_to_air / solid.share;
  // What is known of the round part alone would be misread.
  for (const SolidTool& tool : solid.tools) {
    ToolSummary& told = summary.tools[static_cast<std::size_t>(tool.tool)];
    told.heat_received += tool.heat_received / solid.share;
    told.energy_imbalance.reset();
    told.faces.clear();
  }
  for (ToolSummary& tool : summary.tools) tool.radiated.reset();
}

Quantities solid_quantities(const Scene& scene, const State& state, const Summary& summary, const SolidState& solid,
                            const SolidWall& wall) {
  Quantities found = quantities(scene, state, summary, {});
  const double mean = 1e3 * wall.mean, least = 1e3 * wall.points[wall.thinnest].thickness;
  found.values.insert(found.values.begin(),
                      {{"thickness_mean", "mm", mean, mean},
                       {"thickness_min", "mm", least, least, core::none, in_plane(wall.points[wall.thinnest].at)}});
  found.profile = profile_of(solid, wall);
  set(found, "glass_skin", skin_temperature(wall) - thermal::content_reference);
  const SolidExtent extent = extent_of(solid);
  set(found, "extent_r_max", 1e3 * extent.radius);
  set(found, "extent_z_min", 1e3 * extent.low);
  set(found, "extent_z_max", 1e3 * extent.high);
  return found;
}

}  // namespace parison::forming
