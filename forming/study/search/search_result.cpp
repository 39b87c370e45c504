// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/search_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "core/io/json_read.hpp"
#include "core/math/numbers.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/comparison/finished_run.hpp"
#include "forming/study/search/case/search_case.hpp"

namespace parison::forming {
namespace {

std::string field(double value) {
  return std::isfinite(value) ? fmt::format("{:.9g}", value) : "nan";
}

double quantity(const SearchRow& row, const std::string& name) {
  const Quantity* found = row.outcome.quantities.find(name);
  return found ? found->value : core::none;
}

/// The quantities that any run has, with their units.
std::vector<Quantity> columns(const std::vector<SearchRow>& rows) {
  std::vector<Quantity> found;
  for (const SearchRow& row : rows)
    for (const Quantity& quantity : row.outcome.quantities.values)
      if (std::none_of(found.begin(), found.end(), [&](const Quantity& q) { return q.name == quantity.name; }))
        found.push_back(quantity);
  return found;
}

std::string with_unit(const std::string& name, std::string unit) {
  std::replace(unit.begin(), unit.end(), ' ', '_');
  return core::csv_text(unit.empty() ? name : name + '_' + unit);
}

std::string worth_fields(const std::optional<Worth>& worth) {
  return worth ? field(worth->value) + (worth->holds() ? ",yes" : ",no") : "nan,";
}

void write_runs(const Goal& goal, const SearchResult& result, const std::string& output) {
  const std::vector<Quantity> quantities = columns(result.rows);
  std::string text = "run";
  for (const SearchVariable& variable : goal.variables) text += ',' + with_unit(variable.key, variable.bounds.unit);
  text += ",status,value,limits_hold,corrections,corrected_value,corrected_limits_hold";
  for (const Quantity& quantity : quantities) text += ',' + with_unit(quantity.name, quantity.unit);
  text += ",reason\n";
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    const SearchRow& row = result.rows[i];
    text += row.folder.empty() ? fmt::format("refused_{:04}", i + 1) : row.folder;
    for (std::size_t k = 0; k < goal.variables.size(); ++k)
      text += ',' + field(goal.variables[k].value(row.at[Eigen::Index(k)]));
    text += row.worth ? ",done," + worth_fields(row.worth) : std::string(",failed,nan,");
    text += fmt::format(",{},{}", row.corrections, worth_fields(row.corrected_worth));
    for (const Quantity& column : quantities) text += ',' + field(quantity(row, column.name));
    text += ',' + core::csv_text(row.outcome.reason) + '\n';
  }
  core::replace_file(output + "/runs.csv", text);
}

void add_confirmed(core::JsonWriter& json, const char* key, const Goal& goal, const SearchResult& result,
                   const Confirmed& confirmed) {
  json.open_object(key);
  json.add("run", result.rows[confirmed.row].folder);
  json.add("folder", confirmed.folder);
  json.add("accuracy", goal.confirm);
  json.add("value", confirmed.value);
  json.add("error", confirmed.bar);
  json.add("limits_hold", confirmed.holds);
  json.add("reason", confirmed.reason);
  json.close();
}

void add_row(core::JsonWriter& json, const char* key, const Goal& goal, const SearchResult& result, std::size_t index) {
  const SearchRow& row = result.rows[index];
  json.open_object(key);
  json.add("run", row.folder);
  json.open_object("values");
  for (std::size_t k = 0; k < goal.variables.size(); ++k)
    json.add(goal.variables[k].key, goal.variables[k].text(row.at[Eigen::Index(k)]));
  json.close();
  json.add("value", row.worth ? row.worth->value : core::none);
  json.add("limits_hold", row.worth && row.worth->holds());
  json.open_object("quantities");
  for (const Quantity& quantity : row.outcome.quantities.values) json.add(quantity.name, quantity.value);
  json.close();
  if (row.corrected_worth) {
    json.open_object("corrected");
    json.add("value", row.corrected_worth->value);
    json.add("limits_hold", row.corrected_worth->holds());
    json.close();
  }
  if (const Confirmed* confirmed = result.confirmed_of(index))
    add_confirmed(json, "confirmed", goal, result, *confirmed);
  json.close();
}

void write_json(const Goal& goal, const SearchResult& result, const std::string& output) {
  core::JsonWriter json;
  json.add("case", goal.case_path);
  json.add("accuracy", goal.accuracy);
  json.add("sought", what_is_sought(goal));
  json.add("runs", static_cast<long>(result.rows.size()));
  json.add("failed", static_cast<long>(std::count_if(result.rows.begin(), result.rows.end(),
                                                     [](const SearchRow& row) { return !row.worth; })));
  json.add("ending", result.ending);
  json.add("corrections", static_cast<long>(result.corrections));
  add_row(json, "start", goal, result, 0);
  add_row(json, "best", goal, result, result.best);
  json.open_list("confirmed");
  for (const Confirmed& confirmed : result.confirmed) add_confirmed(json, "", goal, result, confirmed);
  json.close();
  core::replace_file(output + "/result.json", json.finish());
}

/// The wall of the start and of the best run over the outer arc.
bool write_walls(const Goal& goal, const SearchResult& result, const std::string& output) {
  const Wall &start = result.rows.front().outcome.wall, &best = result.rows[result.best].outcome.wall;
  if (start.thickness.empty() || best.thickness.empty()) return false;
  const std::vector<double> shares = area_shares(best, goal.target.part);
  std::string text = "share_of_arc,r_outer_mm,z_outer_mm,start_mm,best_mm,counts\n";
  for (std::size_t i = 0; i < best.thickness.size(); ++i)
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{}\n", double(i) / double(wall_places - 1), best.radius[i],
                        best.height[i], start.thickness[i], best.thickness[i], shares[i] > 0 ? "yes" : "no");
  core::replace_file(output + "/wall.csv", text);
  return true;
}

void add_list(core::JsonWriter& json, const char* key, const std::vector<double>& values) {
  json.open_list(key);
  for (const double value : values) json.add("", value);
  json.close();
}

void add_variable(core::JsonWriter& json, const Goal& goal, const SearchResult& result, std::size_t k) {
  const SearchVariable& variable = goal.variables[k];
  const auto at = [&](const SearchRow& row) { return row.at[Eigen::Index(k)]; };
  json.open_object("");
  json.add("key", variable.key);
  json.add("unit", variable.bounds.unit);
  json.add("from", variable.bounds.from);
  json.add("to", variable.bounds.to);
  json.add("start", variable.value(at(result.rows.front())));
  json.add("answer", variable.value(at(result.rows[result.best])));
  std::vector<double> shares;
  for (const SearchRow& row : result.rows)
    shares.push_back((at(row) - variable.low()) / (variable.high() - variable.low()));
  add_list(json, "share", shares);
  json.close();
}

}  // namespace

std::string course_text(const Goal& goal, const SearchResult& result) {
  core::JsonWriter json;
  json.add("sought", what_is_sought(goal) + (result.corrections > 0 ? ", corrected by " + goal.confirm : ""));
  json.add("good_enough", good_value(goal).value_or(0));
  json.add("ending", result.ending);
  std::vector<double> values, best;
  const SearchRow* leader = nullptr;
  for (const SearchRow& row : result.rows) {
    const auto& worth = row.counted_worth();
    if (worth && (!leader || is_better(*worth, *leader->counted_worth()))) leader = &row;
    values.push_back(worth ? worth->value : core::none);
    best.push_back(leader ? leader->counted_worth()->value : core::none);
  }
  add_list(json, "values", values);
  add_list(json, "best", best);
  json.open_list("holds");
  for (const SearchRow& row : result.rows) json.add("", row.counted_worth() && row.counted_worth()->holds());
  json.close();
  json.open_list("variables");
  for (std::size_t k = 0; k < goal.variables.size(); ++k) add_variable(json, goal, result, k);
  json.close();
  return json.finish();
}

std::size_t best_row(const std::vector<SearchRow>& rows) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto &own = rows[i].counted_worth(), &before = rows[best].counted_worth();
    if (own && (!before || is_better(*own, *before))) best = i;
  }
  return best;
}

const Confirmed* SearchResult::confirmed_of(std::size_t row) const {
  for (const Confirmed& one : confirmed)
    if (one.row == row) return &one;
  return nullptr;
}

std::size_t best_confirmed_row(const SearchResult& result) {
  const Confirmed* best = nullptr;
  for (const Confirmed& one : result.confirmed)
    if (one.worth && (!best || is_better(*one.worth, *best->worth))) best = &one;
  return best ? best->row : result.best;
}

const std::optional<Worth>& worth_of_answer(const SearchResult& result) {
  const Confirmed* confirmed = result.confirmed_of(result.best);
  if (result.corrections > 0 && confirmed && confirmed->worth) return confirmed->worth;
  return result.rows[result.best].counted_worth();
}

Confirmed read_confirmed(const Goal& goal, const std::string& folder) {
  const Outcome own = read_outcome(folder, goal.target.part);
  const auto found = worth(goal, own);
  if (!found) return {core::none, core::none, false, own.reason.empty() ? "it lacks what the goal needs" : own.reason};
  Confirmed confirmed{found->value, core::none, found->holds(), "", own, found};
  std::vector<ValueOfRun> values{{1, found->value}};
  const auto accuracy_of = [](const std::string& run) {
    return core::read_json_file(run + "/summary.json").value_or(core::JsonValue{}).text_of("accuracy");
  };
  for (const char* name : coarse_folders) {
    const std::string coarse = folder + '/' + name;
    if (!std::filesystem::exists(coarse + "/summary.json")) continue;
    const auto other = worth(goal, read_outcome(coarse, goal.target.part));
    const auto factor = coarsening(accuracy_of(coarse), accuracy_of(folder));
    if (other && factor) values.push_back({*factor, other->value});
  }
  confirmed.bar = bar_of_values(values);
  return confirmed;
}

std::vector<std::string> write_search(const Goal& goal, const SearchResult& result, const std::string& output) {
  std::vector<std::string> written{"runs.csv", "result.json"};
  write_runs(goal, result, output);
  write_json(goal, result, output);
  if (write_walls(goal, result, output)) written.push_back("wall.csv");
  if (!result.rows[result.best].worth) return written;
  for (std::string& name : write_case(goal, result.rows[result.best].at, output)) written.push_back(std::move(name));
  return written;
}

}  // namespace parison::forming
