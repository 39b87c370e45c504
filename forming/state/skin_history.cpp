// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/skin_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/numbers.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

namespace {

using thermal::SkinLoad;

/// Intervals of one history; the first of more pulses stand for all.
constexpr std::size_t max_intervals = 1000;

/// A curve and the time, s, at which its own time begins.
struct Curve {
  const core::TimeFunction* value;
  double start;
  double operator()(double time) const { return (*value)(time - start); }
};

/// A surface's exchange with surroundings: by a conductance, W/m2/K, and by radiation of an emissivity.
struct Exchange {
  Curve h, temperature, ambient;
  double emissivity = 0;
};

const core::TimeFunction nothing(0), prescribed(std::numeric_limits<double>::infinity());

Exchange of_air(const Body& data, const Air& air, double stage_start) {
  const double start = air.of_stage ? stage_start : 0;
  const double emissivity = thermal::has_light(*data.thermal) ? 0 : data.emissivity;
  return {{&air.h, start}, {&air.air_temperature, start}, {&air.ambient_temperature, start}, emissivity};
}

/// The load at a time of the run for a surface of a temperature, K, whose radiation is linear in it.
SkinLoad load_of(const Exchange& exchange, double surface, double time) {
  const double h = exchange.h(time);
  if (exchange.emissivity == 0) return {h, exchange.temperature(time)};
  const double ambient = exchange.ambient(time);
  const double radiated = 4 * exchange.emissivity * thermal::stefan_boltzmann * std::pow(std::max(surface, ambient), 3);
  return {h + radiated, (h * exchange.temperature(time) + radiated * ambient) / (h + radiated)};
}

/// The air in which a boundary of the body would lose most.
Exchange strongest_air(const Body& data, const Stage& stage, bool is_glass, double stage_start) {
  Exchange strongest = of_air(data, stage.air, stage_start);
  if (!is_glass || !stage.inner_air) return strongest;
  const Exchange inner = of_air(data, *stage.inner_air, stage_start);
  return inner.h.value->max() > strongest.h.value->max() ? inner : strongest;
}

/// What a boundary exchanges heat with in a stage, by its number, that starts at a time, s.
Exchange exchange_in(const Scene& scene, Index body, std::size_t boundary, Index number, double stage_start) {
  const Stage& stage = scene.stages[number];
  const Body& data = body_of(scene, body);
  const Boundary& given = data.boundaries[boundary];
  const Exchange none{{&nothing, 0}, {&nothing, 0}, {&nothing, 0}};
  if (body != glass_body && is_waiting(scene, number, body - body_of_tool(0))) return none;
  if (given.kind == BoundaryKind::temperature) return {{&prescribed, 0}, {&given.temperature, 0}, {&nothing, 0}};
  const bool sees_air = given.kind == BoundaryKind::contact || given.kind == BoundaryKind::air;
  Exchange exchange = none;
  if (sees_air) exchange = strongest_air(data, stage, body == glass_body, stage_start);
  if (given.kind == BoundaryKind::cooled)
    exchange = {{&given.cooling.h, 0}, {&given.cooling.air_temperature, 0}, {&nothing, 0}};
  for (const StageCooling& cooling : stage.cooling)
    if (body_of_tool(cooling.tool) == body && cooling.boundary == boundary) {
      exchange.h = {&cooling.h, stage_start};
      exchange.temperature = {&cooling.air_temperature, stage_start};
    }
  return exchange;
}

double next_bend(const Exchange& exchange, double time) {
  double next = std::numeric_limits<double>::infinity();
  for (const Curve& curve : {exchange.h, exchange.temperature, exchange.ambient})
    next = std::min(next, curve.start + curve.value->next_corner(time - curve.start + core::same_time));
  return next;
}

}  // namespace

void add_interval(thermal::SkinHistory& history, const thermal::SkinInterval& interval) {
  const auto same = [](const SkinLoad& a, const SkinLoad& b) { return a.h == b.h && a.temperature == b.temperature; };
  if (!(interval.duration > 0)) return;
  if (!history.empty() && same(history.back().start, history.back().end) && same(history.back().end, interval.start) &&
      same(interval.start, interval.end))
    history.back().duration += interval.duration;
  else
    history.push_back(interval);
}

void add_pressed_intervals(const Stage& stage, const SkinLoad& closed, double lowest, thermal::SkinHistory& history) {
  std::vector<const core::TimeFunction*> loads;
  const auto include = [&](const core::TimeFunction& load) {
    if (load.max() > load.min()) loads.push_back(&load);
  };
  for (const auto& [name, pressure] : stage.pressure) include(pressure);
  for (const StageTool& tool : stage.tools)
    if (const auto* driven = std::get_if<ForceMotion>(&tool.motion)) include(driven->force);
  const auto load_at = [&](double time) {
    double share = loads.empty() ? 1 : 0;
    for (const auto* load : loads) share = std::max(share, std::abs((*load)(time)) / load->max_size());
    return SkinLoad{lowest + share * (closed.h - lowest), closed.temperature};
  };
  for (double time = 0; time < stage.duration && history.size() < max_intervals;) {
    double next = stage.duration;
    for (const auto* load : loads) next = std::min(next, load->next_corner(time + core::same_time));
    add_interval(history, {next - time, load_at(time), load_at(next)});
    time = next;
  }
}

thermal::SkinHistory surroundings_history(const Scene& scene, Index body, std::size_t boundary,
                                          const std::vector<double>& durations) {
  thermal::SkinHistory history;
  const double surface = body_of(scene, body).initial_temperature;
  double time = 0;
  for (std::size_t s = 0; s < durations.size(); ++s) {
    const double end = time + durations[s];
    const Exchange exchange = exchange_in(scene, body, boundary, static_cast<Index>(s), time);
    while (time < end && history.size() < max_intervals) {
      const double next = std::min(end, next_bend(exchange, time));
      add_interval(history, {next - time, load_of(exchange, surface, time), load_of(exchange, surface, next)});
      time = next;
    }
    time = end;
  }
  return history;
}

}  // namespace parison::forming
