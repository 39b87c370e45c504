// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/cooling/residual_stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/math/numbers.hpp"
#include "forming/report/container/container_report.hpp"
#include "forming/step/cooling/cooling_step.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

namespace {

constexpr double megapascal = 1e6, nanometre = 1e-9, millilitre = 1e-6;

std::string place(const SurfaceTension& tension) {
  return fmt::format("{:.2f} MPa at ({:.1f}, {:.1f}) mm", tension.stress / megapascal, tension.at[0] / core::millimetre,
                     tension.at[1] / core::millimetre);
}

std::string sides(const SidesTension& tension) {
  const bool has_inner = tension.inner.stress > 0;
  return "outside " + place(tension.outer) + (has_inner ? ", inside " + place(tension.inner) : "");
}

void add_tension(core::JsonWriter& json, const char* key, const SurfaceTension& tension) {
  json.open_object(key);
  json.add("MPa", tension.stress / megapascal);
  json.add("r_mm", tension.at[0] / core::millimetre);
  json.add("z_mm", tension.at[1] / core::millimetre);
  json.add("time_s", tension.time);
  json.close();
}

void add_base(core::JsonWriter& json, const BaseView& base) {
  if (base.radius.empty()) return;
  const std::size_t most = base.largest();
  json.open_object("base");
  json.add("retardation_nm", std::abs(base.retardation[most]) / nanometre);
  json.add("at_r_mm", base.radius[most] / core::millimetre);
  json.add("thickness_mm", base.thickness[most] / core::millimetre);
  json.add("apparent_temper_number", apparent_temper_number(base.retardation[most]));
  json.add("real_temper_number", real_temper_number(base.retardation[most], base.thickness[most]));
  const auto list = [&](const char* key, const std::vector<double>& values, double unit) {
    json.open_list(key);
    for (const double value : values) json.add("", value / unit);
    json.close();
  };
  if (base.at.empty()) {
    list("r_mm", base.radius, core::millimetre);
    list("retardations_nm", base.retardation, nanometre);
  } else {
    std::vector<double> x, y;
    for (const core::Vector3& at : base.at) x.push_back(at[0]), y.push_back(at[1]);
    json.add("sector_deg", base.sector * 180 / M_PI);
    list("x_mm", x, core::millimetre);
    list("y_mm", y, core::millimetre);
    list("on_diagonal_nm", base.on_diagonal, nanometre);
  }
  json.close();
}

/// A stress of the wall, in one direction along it.
struct StressOfWall {
  double stress = 0;  ///< Pa
  const char* direction = "";
  Point outer = Point::Zero();  ///< m
};

/// The part of the stress through the wall that is largest, by sign of `better`.
template <typename Part, typename Better>
StressOfWall largest_of(const std::vector<WallStress>& wall, const Part& part, const Better& better) {
  StressOfWall largest;
  for (const WallStress& row : wall)
    for (const auto& [direction, stress] : {std::pair{"hoop", row.hoop}, {"meridional", row.meridional}})
      if (const double found = part(stress); better(found, largest.stress)) largest = {found, direction, row.outer};
  return largest;
}

/// The largest tension of the mean through the wall, and the largest pressure or tension that is left at a surface.
std::array<StressOfWall, 2> parts_of(const std::vector<WallStress>& wall) {
  const auto is_more = [](double a, double b) { return std::abs(a) > std::abs(b); };
  const auto at_surface = [&](const StressThroughWall& one) {
    return is_more(one.inner, one.outer) ? one.inner : one.outer;
  };
  return {largest_of(
              wall, [](const StressThroughWall& one) { return one.mean; }, std::greater<>{}),
          largest_of(wall, at_surface, is_more)};
}

std::string place(const StressOfWall& part) {
  return fmt::format("{:.2f} MPa ({}) at ({:.1f}, {:.1f}) mm", part.stress / megapascal, part.direction,
                     part.outer[0] / core::millimetre, part.outer[1] / core::millimetre);
}

void add_part(core::JsonWriter& json, const char* key, const StressOfWall& part) {
  json.open_object(key);
  json.add("MPa", part.stress / megapascal);
  json.add("direction", part.direction);
  json.add("r_mm", part.outer[0] / core::millimetre);
  json.add("z_mm", part.outer[1] / core::millimetre);
  json.close();
}

/// Stress at the nodes, MPa: around the axis, and the circle of Mohr of that in the section.
struct NodalStress {
  Eigen::ArrayXd hoop, mean, radius;

  explicit NodalStress(const GlassState& glass) {
    const Eigen::VectorXd stress = nodal_stress(glass) / megapascal;
    const Eigen::Map<const Eigen::ArrayXXd> in(stress.data(), 4, stress.size() / 4);
    hoop = in.row(2).transpose();
    mean = 0.5 * (in.row(0) + in.row(1)).transpose();
    radius = (0.25 * (in.row(0) - in.row(1)).square() + in.row(3).square()).sqrt().transpose();
  }
  Eigen::ArrayXd principal() const { return hoop.max(mean + radius); }  ///< the largest
};

std::string container_text(const CoolingSeen& seen, const CooledContainer& cold) {
  std::string text = fmt::format(
      "{:.5g} mm high and {:.4g} mm wide, hot {:.5g} and {:.4g} mm; shrunk by {:.2f} %, "
      "sunk by {:.2f} %",
      cold.height / core::millimetre, cold.diameter / core::millimetre, seen.height / core::millimetre,
      seen.diameter / core::millimetre, 100 * (1 - std::cbrt(cold.volume / seen.volume)),
      100 * seen.sag(cold.height, cold.volume));
  if (cold.capacity && seen.capacity > 0)
    text = fmt::format("{:.5g} ml, hot {:.5g} ml ({:+.2f} %); ", *cold.capacity / millilitre,
                       seen.capacity / millilitre, 100 * (*cold.capacity / seen.capacity - 1)) +
           text;
  return text;
}

}  // namespace

std::optional<CooledContainer> cooled_container(const Scene& scene, const State& state, bool has_wall) {
  if (!remembers(state)) return {};
  CooledContainer cold;
  cold.tension = surface_tension(state);
  cold.largest_tension = megapascal * std::max(0.0, NodalStress(state.glass).principal().maxCoeff());
  cold.base = base_view(scene, state.glass, scene.stages.back().gravity > 0 ? -1 : 1);
  cold.volume = core::volume(state.glass.mesh, scene.geometry);
  if (const auto container = container_report(scene, state, has_wall)) {
    cold.height = container->size.height;
    cold.diameter = container->size.diameter;
    cold.capacity = container->capacity;
  }
  return cold;
}

void add_stress_fields(const Scene& scene, const GlassState& glass, core::VtuFields& fields) {
  if (glass.branch_stress.size() == 0) return;
  const NodalStress stress(glass);
  // On a surface one of the two in the section vanishes, the other is along the meridian.
  const Eigen::ArrayXd meridional = (stress.mean < 0).select(stress.mean - stress.radius, stress.mean + stress.radius);
  fields.nodal.push_back({"stress_hoop_MPa", stress.hoop.matrix()});
  fields.nodal.push_back({"stress_meridional_MPa", meridional.matrix()});
  fields.nodal.push_back({"stress_principal_MPa", stress.principal().matrix()});
  fields.nodal.push_back({"fictive_temperature_degC",
                          (nodal_fictive_temperature(scene, glass).array() - thermal::content_reference).matrix()});
}

void add_cooling(core::JsonWriter& json, const Summary& summary) {
  if (!summary.cold) return;
  const CooledContainer& cold = *summary.cold;
  const CoolingSeen& seen = summary.run.diagnostics.cooling;
  json.open_object("cooling");
  if (seen.capacity > 0) json.add("hot_capacity_ml", seen.capacity / millilitre);
  if (seen.height > 0) json.add("hot_height_mm", seen.height / core::millimetre);
  if (seen.diameter > 0) json.add("hot_diameter_mm", seen.diameter / core::millimetre);
  json.add("contraction", 1 - std::cbrt(cold.volume / seen.volume));
  if (cold.height > 0 && seen.height > 0) json.add("sag", seen.sag(cold.height, cold.volume));
  add_tension(json, "residual_outer", cold.tension.outer);
  add_tension(json, "residual_inner", cold.tension.inner);
  add_tension(json, "largest_outer", seen.largest.outer);
  add_tension(json, "largest_inner", seen.largest.inner);
  if (!summary.wall_stress.empty()) {
    const auto [membrane, through_wall] = parts_of(summary.wall_stress);
    add_part(json, "membrane", membrane);
    add_part(json, "through_wall", through_wall);
  }
  add_base(json, cold.base);
  json.close();
}

void add_cooling_quantities(const Scene& scene, const State& state, const Summary& summary, Quantities& found) {
  if (!summary.cold) return;
  constexpr double hardly_any = 0.1;  // MPa; tension that does not matter to the strength of glass
  const auto add = [&](const char* name, const char* unit, double value, double least_scale) {
    found.values.push_back({name, unit, value, std::max(value, least_scale)});
  };
  const auto add_tension = [&](const char* name, double tension) { add(name, "MPa", tension, hardly_any); };
  const auto on_surface = [](const SidesTension& at) {
    return std::max(at.outer.stress, at.inner.stress) / megapascal;
  };
  if (const BaseView& base = summary.cold->base; !base.radius.empty()) {
    const std::size_t most = base.largest();
    add("temper_number", "", real_temper_number(base.retardation[most], base.thickness[most]), 1);
  }
  add_tension("residual_tension", summary.cold->largest_tension / megapascal);
  add_tension("residual_tension_surface", on_surface(summary.cold->tension));
  add_tension("cooling_tension_surface", on_surface(summary.run.diagnostics.cooling.largest));
  for (std::size_t i = 0; i < summary.run.stages.size(); ++i)
    if (scene.stages[i].cools) {
      const double time = state.time - summary.run.stages[i].start;
      return add("cooling_time", "s", time, time);
    }
}

std::vector<std::pair<const char*, const char*>> cooling_quantities_of(const Scene& scene) {
  const auto cools = [](const Stage& stage) { return stage.cools; };
  if (std::none_of(scene.stages.begin(), scene.stages.end(), cools)) return {};
  return {{"temper_number", ""},
          {"residual_tension", "MPa"},
          {"residual_tension_surface", "MPa"},
          {"cooling_tension_surface", "MPa"},
          {"cooling_time", "s"}};
}

std::vector<LabelledText> cooling_lines(const Summary& summary) {
  if (!summary.cold) return {};
  const CooledContainer& cold = *summary.cold;
  const CoolingSeen& seen = summary.run.diagnostics.cooling;
  std::vector<LabelledText> lines;
  if (cold.height > 0 && seen.height > 0) lines.push_back({"cold container", container_text(seen, cold)});
  lines.push_back({"residual tension", sides(cold.tension)});
  lines.push_back(
      {"tension while cooling", fmt::format("{}, after {:.0f} s", sides(seen.largest), seen.largest.outer.time)});
  if (!summary.wall_stress.empty()) {
    const auto [membrane, through_wall] = parts_of(summary.wall_stress);
    lines.push_back({"through the wall", fmt::format("mean at most {}; left without it at a side at most {}",
                                                     place(membrane), place(through_wall))});
  }
  if (const BaseView& base = cold.base; !base.radius.empty()) {
    const std::size_t most = base.largest();
    lines.push_back(
        {"temper number",
         fmt::format("{:.2g} real, {:.2g} apparent: {:.0f} nm at r = {:.1f} mm through "
                     "{:.1f} mm of base",
                     real_temper_number(base.retardation[most], base.thickness[most]),
                     apparent_temper_number(base.retardation[most]), std::abs(base.retardation[most]) / nanometre,
                     base.radius[most] / core::millimetre, base.thickness[most] / core::millimetre)});
  }
  return lines;
}

}  // namespace parison::forming
