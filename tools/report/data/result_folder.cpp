// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/result_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/case/case_error.hpp"
#include "core/case/given_file.hpp"
#include "core/case/number.hpp"
#include "core/io/files.hpp"
#include "core/process/run_error.hpp"
#include "tools/report/data/run_names.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

double number_of(std::string_view text) {
  return core::parse_number<double>(text).value_or(std::numeric_limits<double>::quiet_NaN());
}

/// The fields of a line; one in quotes may hold commas, and quotes twice.
std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool pair = quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
    if (line[i] == '"' && !pair)
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += line[i += pair ? 1 : 0];
  }
  return cells;
}

/// Adds a row; the first one tells which columns are of texts.
void add_row(ResultTable& table, const std::vector<std::string>& cells) {
  const bool first = table.rows() == 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    table.numbers[i].push_back(number_of(cells[i]));
    const bool is_text = std::isnan(table.numbers[i].back()) && cells[i] != "nan" && cells[i] != "-nan";
    if (first ? is_text : !table.texts[i].empty()) table.texts[i].push_back(cells[i]);
  }
}

double last_time(const ResultFolder& folder) {
  const auto* times = folder.history.column("time_s");
  return times && !times->empty() ? times->back() : std::numeric_limits<double>::quiet_NaN();
}

/// Appends the steps of glass in space to the history: heat goes on from where round glass ended. Steps of an earlier
/// run in the same folder, which began at another time, are left out.
void append_steps_in_space(ResultFolder& folder) {
  ResultTable& history = folder.history;
  const ResultTable steps = read_table(folder.path + "/solid/history.csv");
  const auto *times = steps.column("time_s"), *lengths = steps.column("dt_s");
  if (!times || !lengths || times->empty() || !starts_where_round_ended(folder, times->front() - lengths->front()))
    return;
  for (std::size_t i = 0; i < history.names.size(); ++i) {
    const int at = steps.find(history.names[i]);
    const auto from = static_cast<std::size_t>(at);
    const bool is_sum = history.names[i].rfind("heat_to_", 0) == 0;
    const double before = is_sum ? history.numbers[i].back() : 0;
    for (std::size_t row = 0; row < steps.rows(); ++row)
      history.numbers[i].push_back(at < 0 ? std::numeric_limits<double>::quiet_NaN()
                                          : before + steps.numbers[from][row]);
    if (at >= 0 && !history.texts[i].empty())
      history.texts[i].insert(history.texts[i].end(), steps.texts[from].begin(), steps.texts[from].end());
    else if (!history.texts[i].empty())
      history.texts[i].resize(history.numbers[i].size());
  }
}

/// A summary is of the whole run where it ends at the same time as the history.
bool belongs(const Json& summary, const ResultFolder& folder) {
  const auto* times = folder.history.column("time_s");
  if (!summary.is_object() || !times || times->empty()) return summary.is_object();
  const auto time = summary.find("time_s");
  return time != summary.end() && time->is_number() &&
         std::abs(time->get<double>() - times->back()) <= 1e-8 * std::max(1.0, times->back());
}

std::string text_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

double number_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0;
}

bool flag_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

void read_state(ResultFolder& folder, const Json& summary) {
  const std::string resume = fmt::format("`parison resume {}` continues it", folder.path);
  if (is_written(folder.path)) {
    folder.state = RunState::running;
    folder.told = "the run is going on";
  } else if (folder.summary.empty()) {
    folder.state = RunState::ended;
    folder.told = "the run ended without a summary, as when it is killed; what it wrote before is shown; " + resume;
  } else if (flag_of(summary, "completed")) {
    folder.state = RunState::completed;
  } else if (flag_of(summary, "stopped")) {
    folder.state = RunState::stopped;
    folder.told =
        fmt::format("the run was stopped on request before its end ({}); {}", text_of(summary, "reason"), resume);
  } else {
    folder.state = RunState::failed;
    folder.told = fmt::format("the run stopped before its end in {}", text_of(summary, "reason"));
  }
}

/// The stages of the summary, or the stretches of the history with one name.
std::vector<StageSpan> stages_of(const ResultFolder& folder, const Json& summary) {
  std::vector<StageSpan> stages;
  const auto listed = summary.is_object() ? summary.find("stages") : summary.end();
  if (!folder.summary.empty() && listed != summary.end() && listed->is_array())
    for (const Json& stage : *listed)
      if (stage.is_object())
        stages.push_back({text_of(stage, "name"), number_of(stage, "start_s"), number_of(stage, "end_s"),
                          text_of(stage, "end_reason")});
  const int names = folder.history.find("stage");
  const auto* times = folder.history.column("time_s");
  if (!stages.empty() || names < 0 || !times) return stages;
  const auto& texts = folder.history.texts[static_cast<std::size_t>(names)];
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (stages.empty() || stages.back().name != texts[i])
      stages.push_back({texts[i], i == 0 ? 0 : (*times)[i - 1], (*times)[i], ""});
    stages.back().end = (*times)[i];
  }
  return stages;
}

}  // namespace

int ResultTable::find(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

const std::vector<double>* ResultTable::column(const std::string& name) const {
  const int at = find(name);
  return at < 0 ? nullptr : &numbers[static_cast<std::size_t>(at)];
}

ResultTable read_table(const std::string& path) {
  ResultTable table;
  std::error_code unreadable;
  if (!fs::is_regular_file(path, unreadable)) return table;
  std::string text = core::read_text(path);
  text.erase(text.find_last_of('\n') + 1);
  core::Lines lines(text);
  std::string_view line;
  if (!lines.next(line)) return table;
  table.names = split(line);
  table.numbers.resize(table.names.size());
  table.texts.resize(table.names.size());
  while (lines.next(line)) {
    if (const auto cells = split(line); cells.size() == table.names.size()) add_row(table, cells);
  }
  return table;
}

bool is_result_folder(const std::string& path) {
  std::error_code unreadable;
  return fs::is_regular_file(fs::path(path) / "history.csv", unreadable);
}

bool starts_where_round_ended(const ResultFolder& folder, double time) {
  return std::abs(time - folder.round_end) <= 1e-6 * std::max(1.0, folder.round_end);
}

bool is_written(const std::string& path) {
  const int file = ::open((path + "/history.csv").c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool written = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  return written;
}

ResultFolder read_folder(const std::string& path) {
  std::error_code unreadable;
  if (fs::status(path, unreadable).type() == fs::file_type::not_found)
    throw core::CaseError(fmt::format("{}: no such folder, allowed is the result folder of a run", path));
  if (unreadable)
    throw core::CaseError(
        fmt::format("{}: {}, allowed is the result folder of a run that can be read", path, unreadable.message()));
  if (!is_result_folder(path)) {
    const std::string runs = run_folders_hint(path);
    throw core::CaseError(fmt::format(
        "{}: no history.csv was found there, allowed is the result folder of a run, which `parison run` makes{}", path,
        runs.empty() ? "" : "; " + runs));
  }
  ResultFolder folder;
  folder.path = path;
  fs::path place = fs::absolute(path).lexically_normal();
  folder.name = (place.has_filename() ? place : place.parent_path()).filename().string();
  folder.history = read_table(path + "/history.csv");
  folder.round_end = last_time(folder);
  append_steps_in_space(folder);
  Json summary;
  if (fs::is_regular_file(path + "/summary.json", unreadable)) {
    const std::string text = core::read_text(path + "/summary.json");
    summary = Json::parse(text, nullptr, false);
    if (belongs(summary, folder)) folder.summary = text;
  }
  read_state(folder, summary);
  folder.stages = stages_of(folder, summary);
  return folder;
}

std::string name_of(RunState state) {
  switch (state) {
    case RunState::running:
      return "running";
    case RunState::completed:
      return "completed";
    case RunState::stopped:
      return "stopped";
    case RunState::failed:
      return "failed";
    case RunState::ended:
      break;
  }
  return "ended";
}

}  // namespace parison::tools
