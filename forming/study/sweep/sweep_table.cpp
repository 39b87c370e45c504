// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/sweep/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/case/given_file.hpp"
#include "core/case/number.hpp"
#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "core/io/json_read.hpp"
#include "core/math/numbers.hpp"
#include "forming/study/comparison/finished_run.hpp"

namespace parison::forming {
namespace {

using Status = SweepState::Status;

struct Measure {
  double number;
  std::string unit;
};

/// "440 degC" in its parts; nothing for what does not begin with a number or goes on with another.
std::optional<Measure> measure(const std::string& text) {
  const auto read = core::leading_number(text);
  if (!read || read->rest.find_first_of(" ()\"',+=") != read->rest.npos) return std::nullopt;
  return Measure{read->value, std::string(read->rest)};
}

std::string with_unit(const std::string& name, std::string unit) {
  std::replace(unit.begin(), unit.end(), ' ', '_');
  return unit.empty() ? name : name + '_' + unit;
}

SweepColumn variable_column(const SweepPlan& plan, std::size_t variable) {
  SweepColumn column{plan.sweep.variables[variable].key, "", {}, {}};
  std::optional<std::string> unit;
  bool have_unit = true;
  for (const SweepRun& run : plan.runs) {
    const auto read = measure(run.values[variable]);
    have_unit = have_unit && read && (!unit || *unit == read->unit);
    if (!have_unit) break;
    unit = read->unit;
    column.numbers.push_back(read->number);
  }
  if (!have_unit) column.numbers.clear();
  if (have_unit && unit) column.unit = *unit;
  column.heading = with_unit(column.heading, column.unit);
  for (std::size_t i = 0; i < plan.runs.size(); ++i)
    column.fields.push_back(have_unit ? fmt::format("{:.9g}", column.numbers[i])
                                      : core::csv_text(plan.runs[i].values[variable]));
  return column;
}

QuantityColumn& column_of(SweepTable& table, const Quantity& quantity) {
  for (QuantityColumn& column : table.quantities)
    if (column.name == quantity.name) return column;
  const std::vector<double> empty(table.states.size(), core::none);
  return table.quantities.emplace_back(QuantityColumn{quantity.name, quantity.unit, empty, empty});
}

std::string number_field(double value) {
  return std::isfinite(value) ? fmt::format("{:.9g}", value) : "nan";
}

const char* name_of(Status status) {
  return status == Status::done ? "done" : status == Status::failed ? "failed" : "not run";
}

std::string csv_header(const SweepPlan& plan, const SweepTable& table) {
  std::string line = "run";
  for (const SweepColumn& column : table.variables) line += ',' + core::csv_text(column.heading);
  line += ",status";
  for (const QuantityColumn& column : table.quantities) {
    line += ',' + core::csv_text(with_unit(column.name, column.unit));
    if (plan.sweep.error_bars) line += ',' + core::csv_text(with_unit(column.name + "_error", column.unit));
  }
  return line + ",trustworthy,cpu_s,reason\n";
}

std::string csv_line(const SweepPlan& plan, const SweepTable& table, std::size_t run) {
  const SweepState& state = table.states[run];
  std::string line = plan.runs[run].name;
  for (const SweepColumn& column : table.variables) line += ',' + column.fields[run];
  line += fmt::format(",{}", name_of(state.status));
  for (const QuantityColumn& column : table.quantities) {
    line += ',' + number_field(column.values[run]);
    if (plan.sweep.error_bars) line += ',' + number_field(column.errors[run]);
  }
  const char* trusted = state.status != Status::done ? "" : table.trustworthy[run] ? "yes" : "no";
  return line + fmt::format(",{},{},{}\n", trusted, number_field(table.cpu_seconds[run]), core::csv_text(state.reason));
}

void write_variables(const SweepPlan& plan, const SweepTable& table, core::Hdf5Group& root) {
  core::Hdf5Group variables = root.create("variables");
  for (std::size_t i = 0; i < table.variables.size(); ++i) {
    const SweepColumn& column = table.variables[i];
    core::Hdf5Group group = variables.create(plan.sweep.variables[i].key);
    group.write("unit", column.unit);
    if (!column.numbers.empty())
      group.write("value", column.numbers);
    else
      group.write("text", fmt::format("{}", fmt::join(column.fields, "\n")));
  }
}

/// The walls of all runs, a row each, those without one as NaN.
void write_profiles(const SweepTable& table, core::Hdf5Group& root) {
  if (std::all_of(table.profiles.begin(), table.profiles.end(), [](const auto& one) { return one.empty(); })) return;
  std::vector<double> all;
  for (const auto& profile : table.profiles) {
    all.insert(all.end(), profile.begin(), profile.end());
    all.insert(all.end(), static_cast<std::size_t>(profile_points) - profile.size(), core::none);
  }
  root.write("thickness_profile_mm", all, profile_points);
}

void fill_hdf5(const SweepPlan& plan, const SweepTable& table, core::Hdf5Group& root) {
  std::vector<int> done, trusted;
  for (std::size_t i = 0; i < table.states.size(); ++i) {
    done.push_back(table.states[i].status == Status::done ? 1 : table.states[i].status == Status::failed ? -1 : 0);
    trusted.push_back(table.trustworthy[i] ? 1 : 0);
  }
  root.write("case", plan.sweep.case_path);
  root.write("accuracy", plan.sweep.accuracy);
  root.write("done", done);
  root.write("trustworthy", trusted);
  root.write("cpu_s", table.cpu_seconds);
  write_variables(plan, table, root);
  core::Hdf5Group quantities = root.create("quantities");
  for (const QuantityColumn& column : table.quantities) {
    core::Hdf5Group group = quantities.create(column.name);
    group.write("unit", column.unit);
    group.write("value", column.values);
    if (plan.sweep.error_bars) group.write("error", column.errors);
  }
  write_profiles(table, root);
}

}  // namespace

std::vector<SweepColumn> variable_columns(const SweepPlan& plan) {
  std::vector<SweepColumn> columns;
  for (std::size_t i = 0; i < plan.sweep.variables.size(); ++i) columns.push_back(variable_column(plan, i));
  return columns;
}

SweepTable read_results(const SweepPlan& plan, const std::vector<SweepState>& states) {
  const std::size_t count = plan.runs.size();
  SweepTable table{
      variable_columns(plan), states, std::vector<bool>(count), std::vector<double>(count, core::none), {}, {}};
  table.profiles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (states[i].status != Status::done) continue;
    FinishedRun run = read_finished_run(plan.folder(plan.runs[i]));
    table.trustworthy[i] = run.trustworthy;
    table.cpu_seconds[i] = run.cpu_seconds;
    for (const Quantity& quantity : run.quantities.values) {
      QuantityColumn& column = column_of(table, quantity);
      column.values[i] = quantity.value;
      column.errors[i] = quantity.error;
    }
    table.profiles[i] = std::move(run.quantities.profile);
  }
  return table;
}

void write_results(const SweepPlan& plan, const SweepTable& table) {
  std::string text = csv_header(plan, table);
  for (std::size_t i = 0; i < plan.runs.size(); ++i) text += csv_line(plan, table, i);
  core::replace_file(plan.output + "/results.csv", text);
  core::write_hdf5(plan.output + "/results.h5", [&](core::Hdf5Group& root) { fill_hdf5(plan, table, root); });
}

}  // namespace parison::forming
