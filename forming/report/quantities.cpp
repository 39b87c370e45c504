// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/case/case_file.hpp"
#include "core/math/numbers.hpp"
#include "forming/report/cooling/residual_stress.hpp"
#include "forming/report/model_bars.hpp"
#include "forming/report/summary.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

constexpr const char* heat_prefix = "heat_";
constexpr const char* time_prefix = "time_";
constexpr const char* force_prefix = "peak_force_";

double celsius(double kelvin) {
  return kelvin - thermal::content_reference;
}

bool has_wall(const Scene& scene, const std::vector<ThicknessRow>& rows) {
  return scene.has_flow() &&
         std::any_of(rows.begin(), rows.end(), [](const ThicknessRow& row) { return row.is_wall(); });
}

/// Thickness, mm, at even shares of the arc, linear between the rows; NaN beside one that is no wall.
std::vector<double> sample_profile(const ThicknessProfile& wall) {
  const std::vector<ThicknessRow>& rows = wall.rows;
  std::vector<double> profile(profile_points, core::none);
  std::size_t after = 1;
  for (int i = 0; i < profile_points; ++i) {
    const double arc = wall.first_arc + (wall.last_arc - wall.first_arc) * i / (profile_points - 1);
    while (after + 1 < rows.size() && rows[after].arc < arc) ++after;
    const ThicknessRow &a = rows[after - 1], &b = rows[after];
    if (!a.is_wall() || !b.is_wall() || b.arc <= a.arc || arc > b.arc) continue;
    const double t = (arc - a.arc) / (b.arc - a.arc);
    profile[i] = 1e3 * ((1 - t) * a.thickness + t * b.thickness);
  }
  return profile;
}

/// Away from where the wall ends, as the differences of profiles are taken too.
std::vector<int> inner_places(const std::vector<double>& profile) {
  const int margin = static_cast<int>(std::lround(profile_margin * (profile_points - 1)));
  std::vector<int> places;
  const int size = static_cast<int>(profile.size());
  for (int i = 0; i < size; ++i) {
    bool inside = true;
    for (int k = std::max(0, i - margin); k <= std::min(size - 1, i + margin); ++k)
      inside = inside && std::isfinite(profile[k]);
    if (inside) places.push_back(i);
  }
  return places;
}

/// Of the rows, whose lowest is lower than that of the profile where a corner lies between the even shares.
void add_wall(const ThicknessProfile& wall, Quantities& found) {
  found.profile = sample_profile(wall);
  found.profile_start = 1e3 * wall.first_arc;
  found.profile_end = 1e3 * wall.last_arc;
  const ThicknessRange range = thickness_range(wall.rows);
  const double mean = 1e3 * range.mean, lowest = 1e3 * range.lowest;
  const double at = (range.lowest_arc - wall.first_arc) / (wall.last_arc - wall.first_arc);
  found.values.push_back({"thickness_mean", "mm", mean, mean});
  found.values.push_back({"thickness_min", "mm", lowest, lowest});
  found.values.push_back({"thickness_min_at", "of the arc", at, 1, core::none, range.lowest_at});
}

/// Of the outer surface, by area; the wall's where there is one.
double skin_temperature(const std::vector<ThicknessRow>& rows, bool wall) {
  double sum = 0, area = 0;
  for (const ThicknessRow& row : rows)
    if (!wall || row.is_wall()) {
      sum += row.area * row.outer_temperature;
      area += row.area;
    }
  return sum / area;
}

/// A heat below this, J, is nothing: a hundredth of all that the glass gave away or took, and what changes its mean
/// temperature by a tenth of a thousandth of the span of the scene.
double negligible_heat(const Scene& scene, const State& state) {
  constexpr double of_exchange = 1e-2, of_span = 1e-4;
  const TemperatureRange range = temperature_range(scene);
  const double capacity = scene.glass.thermal->heat_capacity(range.max_temperature);
  return std::max(of_exchange * (std::abs(state.totals.to_tools) + std::abs(state.totals.to_air)),
                  of_span * state.glass.density * state.glass.initial_volume * capacity * range.span());
}

void add_heat(const Scene& scene, const State& state, const Summary& summary, const std::vector<ThicknessRow>& rows,
              Quantities& found) {
  const double span = temperature_range(scene).span(), negligible = negligible_heat(scene, state);
  found.values.push_back({"glass_mean", "degC", celsius(summary.glass.mean), span});
  found.values.push_back({"glass_skin", "degC", celsius(skin_temperature(rows, has_wall(scene, rows))), span});
  for (const ToolSummary& tool : summary.tools)
    if (tool.heat_received != 0)
      found.values.push_back(
          {heat_prefix + tool.name, "J", tool.heat_received, std::max(std::abs(tool.heat_received), negligible)});
}

/// How far the glass reaches, as shares of the larger of its width and height.
void add_extent(const State& state, Quantities& found) {
  const core::Mesh& mesh = state.glass.mesh;
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Index node : surface_nodes(mesh)) {
    low = low.cwiseMin(mesh.nodes[node]);
    high = high.cwiseMax(mesh.nodes[node]);
  }
  const double scale = 1e3 * (high - low).maxCoeff();
  found.values.push_back({"extent_r_max", "mm", 1e3 * high[0], scale});
  found.values.push_back({"extent_z_min", "mm", 1e3 * low[1], scale});
  found.values.push_back({"extent_z_max", "mm", 1e3 * high[1], scale});
}

void add_tools(const Scene& scene, const Summary& summary, Quantities& found) {
  for (std::size_t i = 0; i < std::min(scene.stages.size(), summary.run.stages.size()); ++i)
    if (scene.stages[i].may_end_early()) {
      const StageRecord& record = summary.run.stages[i];
      const double lasted = record.end - record.start;
      found.values.push_back({time_prefix + record.name, "s", lasted, lasted});
    }
  const std::vector<double>& peak_force = summary.run.diagnostics.peak_force;
  for (std::size_t i = 0; i < peak_force.size(); ++i)
    if (const double peak = peak_force[i]; peak > 0)
      found.values.push_back({force_prefix + scene.tools[i].name, "N", peak, peak});
}

/// The larger of width and height that the glass has at least, whatever its shape, mm: that of a full cylinder as wide
/// as high. NaN where the scene has no axis.
double least_extent(const Scene& scene) {
  if (scene.geometry != core::Geometry::axisymmetric) return core::none;
  return 1e3 * std::cbrt(dimensionless_numbers(scene).volume / M_PI);
}

/// No wall that a mesh can have is thinner: share of the least extent of the glass.
constexpr double thinnest_wall = 1e-4;

}  // namespace

const Quantity* Quantities::find(const std::string& name) const {
  for (const Quantity& quantity : values)
    if (quantity.name == name) return &quantity;
  return nullptr;
}

Quantities quantities(const Scene& scene, const State& state, const Summary& summary, const ThicknessProfile& wall) {
  Quantities found;
  const std::vector<ThicknessRow>& rows = wall.rows;
  if (has_wall(scene, rows) && rows.size() > 1) add_wall(wall, found);
  if (scene.has_heat()) add_heat(scene, state, summary, rows, found);
  if (scene.has_flow()) {
    add_extent(state, found);
    add_tools(scene, summary, found);
    add_cooling_quantities(scene, state, summary, found);
  }
  add_models(scene, found);
  return found;
}

std::vector<Quantity> possible_quantities(const Scene& scene) {
  std::vector<Quantity> possible;
  const auto add = [&](const std::string& name, const char* unit, double scale = core::none) {
    possible.push_back({name, unit, core::none, scale});
  };
  if (scene.has_flow()) {
    for (const char* wall : {"thickness_mean", "thickness_min"}) add(wall, "mm", thinnest_wall * least_extent(scene));
    add("thickness_min_at", "of the arc", 1);
    for (const char* extent : {"extent_r_max", "extent_z_min", "extent_z_max"}) add(extent, "mm", least_extent(scene));
  }
  const double span = scene.has_heat() ? temperature_range(scene).span() : core::none;
  if (scene.has_heat()) add("glass_mean", "degC", span), add("glass_skin", "degC", span);
  for (std::size_t i = 0; i < scene.tools.size(); ++i) {
    if (scene.has_heat()) add(heat_prefix + scene.tools[i].name, "J");
    if (scene.has_flow() && has_moved_before(scene, static_cast<Index>(scene.stages.size()), static_cast<Index>(i)))
      add(force_prefix + scene.tools[i].name, "N");
  }
  for (const Stage& stage : scene.stages)
    if (scene.has_flow() && stage.may_end_early()) add(time_prefix + stage.name, "s");
  for (const auto& [name, unit] : cooling_quantities_of(scene)) add(name, unit);
  return possible;
}

std::string unknown_quantity(const std::string& name, const std::vector<Quantity>& known) {
  std::vector<std::string> names;
  for (const Quantity& quantity : known) {
    if (quantity.name == name) return {};
    names.push_back(quantity.name);
  }
  return fmt::format("no quantity \"{}\" was found{}, allowed are {}", name, core::did_you_mean(name, names),
                     fmt::join(names, ", "));
}

void add_quantities(core::JsonWriter& json, const Quantities& quantities) {
  json.open_object("quantities");
  for (const Quantity& quantity : quantities.values) {
    json.open_object(quantity.name);
    json.add("unit", quantity.unit);
    json.add("value", quantity.value);
    json.add("scale", quantity.scale);
    if (std::isfinite(quantity.error)) json.add("error", quantity.error);
    json.add("model", quantity.model);
    if (quantity.place.allFinite()) {
      json.add("r_mm", 1e3 * quantity.place[0]);
      json.add("z_mm", 1e3 * quantity.place[1]);
    }
    json.close();
  }
  json.close();
  json.open_object("models");
  for (const ModelUse& model : quantities.models) {
    json.open_object(model.part);
    json.add("used", model.used);
    json.add("best", model.best);
    json.close();
  }
  json.close();
  json.open_list("thickness_profile_mm");
  for (const double thickness : quantities.profile) json.add("", thickness);
  json.close();
  json.open_list("thickness_profile_arc_mm");
  if (!quantities.profile.empty())
    for (const double end : {quantities.profile_start, quantities.profile_end}) json.add("", end);
  json.close();
}

Quantities read_quantities(const core::JsonValue& summary) {
  Quantities found;
  if (const auto* values = summary.find("quantities"))
    for (const core::JsonValue& item : values->items)
      found.values.push_back({item.name,
                              item.text_of("unit"),
                              item.number_of("value"),
                              item.number_of("scale"),
                              item.number_of("error"),
                              {1e-3 * item.number_of("r_mm"), 1e-3 * item.number_of("z_mm")},
                              item.number_of("model")});
  if (const auto* models = summary.find("models"))
    for (const core::JsonValue& item : models->items)
      found.models.push_back({item.name, item.text_of("used"), item.text_of("best")});
  if (const auto* profile = summary.find("thickness_profile_mm"))
    for (const core::JsonValue& item : profile->items) found.profile.push_back(item.number);
  if (const auto* arc = summary.find("thickness_profile_arc_mm"); arc && arc->items.size() == 2) {
    found.profile_start = arc->items[0].number;
    found.profile_end = arc->items[1].number;
  }
  return found;
}

ProfileDifference compare_profiles(const std::vector<double>& profile, const std::vector<double>& reference) {
  if (profile.empty() || profile.size() != reference.size()) return {core::none, core::none, core::none};
  std::vector<double> fraction(profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i) fraction[i] = std::abs(profile[i] - reference[i]) / reference[i];
  const std::vector<int> places = inner_places(fraction);
  if (places.empty()) return {core::none, core::none, core::none};
  double sum = 0;
  int max_index = places.front();
  for (const int i : places) {
    sum += fraction[i];
    if (fraction[i] > fraction[max_index]) max_index = i;
  }
  return {sum / double(places.size()), fraction[max_index], double(max_index) / (profile_points - 1)};
}

double heat_difference(const Quantities& run, const Quantities& reference) {
  double difference = 0, whole = 0;
  bool matters = false;
  for (const Quantity& quantity : reference.values)
    if (quantity.name.rfind(heat_prefix, 0) == 0) {
      const Quantity* found = run.find(quantity.name);
      difference += std::abs((found ? found->value : 0) - quantity.value);
      whole += quantity.scale;
      matters = matters || std::abs(quantity.value) >= quantity.scale;
    }
  return matters ? difference / whole : core::none;
}

}  // namespace parison::forming
