// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "forming/study/sweep/sweep_table.hpp"
#include "forming/study/uncertainty/uncertainty.hpp"

namespace parison::forming {
namespace {

using core::JsonWriter;

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "nan";
}

std::string fields(const Interval& interval) {
  return fmt::format("{},{},{}", number(interval.value), number(interval.low), number(interval.high));
}

/// The bars of a quantity, as CSV.
std::string bar_fields(const UncertainQuantity& quantity) {
  const Interval spread = deviation(quantity.effects);
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}", number(quantity.at_mean), number(quantity.effects.mean),
                     number(quantity.numerical), number(quantity.model), number(quantity.tolerance_bar()),
                     number(2 * spread.low), number(2 * spread.high), number(quantity.bar()), number(quantity.noise),
                     number(quantity.effects.q2()), quantity.effects.runs);
}

constexpr const char* bar_header =
    "at_means,mean,numerical_bar,model_bar,tolerance_bar,tolerance_bar_low,tolerance_bar_high,bar,noise,q2,runs";

std::string quantity_table(const UncertaintyResult& result) {
  std::string text = fmt::format("quantity,unit,{}\n", bar_header);
  for (const UncertainQuantity& quantity : result.quantities)
    text += fmt::format("{},{},{}\n", quantity.name, core::csv_text(quantity.unit), bar_fields(quantity));
  return text;
}

std::string wall_table(const UncertaintyPlan& plan, const UncertaintyResult& result) {
  std::string text = fmt::format("{}share_of_outer_arc,{}", plan.sector ? "angle_deg," : "", bar_header);
  for (const core::Tolerance& tolerance : plan.tolerances)
    text += "," + core::csv_text(fmt::format("total of {}", tolerance.key));
  text += '\n';
  for (const UncertainPlace& place : result.wall) {
    if (plan.sector) text += number(place.angle) + ',';
    text += fmt::format("{},{}", number(place.share), bar_fields(place.thickness));
    for (const Interval& index : sobol_indices(place.thickness.effects).total) text += "," + number(index.value);
    text += '\n';
  }
  return text;
}

void add_index_rows(const UncertaintyPlan& plan, const std::string& name, const std::string& unit,
                    const Effects& effects, bool with_main, std::string& text) {
  const SobolIndices indices = sobol_indices(effects);
  const std::vector<Interval> main = main_effects(effects);
  const Interval no_number{std::nan(""), std::nan(""), std::nan("")};
  for (std::size_t i = 0; i < plan.tolerances.size(); ++i)
    text += fmt::format("{},{},{},{},{},{}\n", name, core::csv_text(unit), core::csv_text(plan.tolerances[i].key),
                        fields(with_main ? main[i] : no_number), fields(indices.first[i]), fields(indices.total[i]));
}

std::string index_table(const UncertaintyPlan& plan, const UncertaintyResult& result) {
  std::string text =
      "quantity,unit,tolerance,main_effect,main_effect_low,main_effect_high,first,first_low,first_high,total,total_low,"
      "total_high\n";
  for (const UncertainQuantity& quantity : result.quantities)
    add_index_rows(plan, quantity.name, quantity.unit, quantity.effects, true, text);
  if (result.wall_effects) add_index_rows(plan, "whole_wall", "", *result.wall_effects, false, text);
  return text;
}

void add_interval(JsonWriter& json, const std::string& key, const Interval& interval) {
  json.open_object(key);
  json.add("value", interval.value);
  json.add("low", interval.low);
  json.add("high", interval.high);
  json.close();
}

void add_tolerances(JsonWriter& json, const UncertaintyPlan& plan) {
  json.open_list("tolerances");
  for (std::size_t i = 0; i < plan.tolerances.size(); ++i) {
    const core::Tolerance& tolerance = plan.tolerances[i];
    const ToleranceRange& range = plan.ranges[i];
    json.open_object("");
    json.add("key", tolerance.key);
    json.add("given", tolerance.given);
    json.add("distribution", tolerance.distribution == core::Distribution::uniform ? "uniform" : "normal");
    json.add("standard_deviation", tolerance.deviation());
    json.add("unit", tolerance.unit);
    json.add("from", value_at(tolerance, range.scatter.low));
    json.add("to", value_at(tolerance, range.scatter.high));
    json.add("refused_below", range.below);
    json.add("refused_above", range.above);
    json.close();
  }
  json.close();
}

void add_effects(JsonWriter& json, const UncertaintyPlan& plan, const Effects& effects, bool with_main) {
  json.add("q2", effects.q2());
  json.add("surrogate", !has_effect(effects) ? "no effect above the noise" : effects.q2() < good_q2 ? "poor" : "good");
  const SobolIndices indices = sobol_indices(effects);
  const std::vector<Interval> main = main_effects(effects);
  json.open_object("tolerances");
  for (std::size_t i = 0; i < plan.tolerances.size(); ++i) {
    json.open_object(plan.tolerances[i].key);
    if (with_main) add_interval(json, "main_effect", main[i]);
    add_interval(json, "first", indices.first[i]);
    add_interval(json, "total", indices.total[i]);
    json.close();
  }
  json.close();
}

void add_quantities(JsonWriter& json, const UncertaintyPlan& plan, const UncertaintyResult& result) {
  json.open_object("quantities");
  for (const UncertainQuantity& quantity : result.quantities) {
    json.open_object(quantity.name);
    json.add("unit", quantity.unit);
    json.add("at_means", quantity.at_mean);
    json.add("mean", quantity.effects.mean);
    json.add("numerical_bar", quantity.numerical);
    json.add("model_bar", quantity.model);
    json.add("tolerance_bar", quantity.tolerance_bar());
    json.add("bar", quantity.bar());
    add_interval(json, "standard_deviation", deviation(quantity.effects));
    json.add("noise", quantity.noise);
    add_effects(json, plan, quantity.effects, true);
    json.close();
  }
  json.close();
}

std::string json_text(const UncertaintyPlan& plan, const UncertaintyResult& result) {
  JsonWriter json;
  json.add("case", plan.study.case_path);
  json.add("accuracy", plan.study.accuracy);
  json.add("runs_done", long(result.done));
  json.add("runs_failed", long(result.failed));
  json.add("runs_not_made", long(result.waiting));
  json.open_list("failures");
  for (const std::string& failure : result.failures) json.add("", failure);
  json.close();
  json.open_list("refused_values");
  for (const RefusedRow& row : plan.refused) {
    json.open_object("");
    json.add("values", fmt::format("{}", fmt::join(row.values, ", ")));
    json.add("reason", row.reason);
    json.close();
  }
  json.close();
  json.open_list("left_out");
  for (const std::string& name : result.left_out) json.add("", name);
  json.close();
  add_tolerances(json, plan);
  add_quantities(json, plan, result);
  if (result.wall_effects) {
    json.open_object("wall");
    add_effects(json, plan, *result.wall_effects, false);
    json.close();
  }
  return json.finish();
}

}  // namespace

void write_uncertainty(const UncertaintyPlan& plan, const UncertaintyResult& result) {
  const std::string& folder = plan.study.output;
  core::replace_file(folder + "/uncertainty.json", json_text(plan, result));
  core::replace_file(folder + "/uncertainty.csv", quantity_table(result));
  core::replace_file(folder + "/sobol_indices.csv", index_table(plan, result));
  if (!result.wall.empty()) core::replace_file(folder + "/wall.csv", wall_table(plan, result));
  core::replace_file(folder + "/uncertainty.svg", uncertainty_picture(plan, result));
  for (const SweepPlan* sweep : {&plan.mean, &plan.noise, &plan.drawn}) {
    std::vector<SweepState> states;
    for (const SweepRun& run : sweep->runs) states.push_back(state_of(*sweep, run));
    write_results(*sweep, read_results(*sweep, states));
  }
}

}  // namespace parison::forming
