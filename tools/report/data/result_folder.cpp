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

constexpr const char* in_space_history = "/solid/history.csv";

/// A summary is of the whole run where it ends at the same time as the history.
bool belongs(const Json& summary, const ResultFolder& folder) {
  const ResultTable in_space = read_table(folder.path + in_space_history);
  const auto* round = folder.history.column("time_s");
  const auto* times = in_space.column("time_s") ? in_space.column("time_s") : round;
  if (!summary.is_object() || !times || times->empty()) return summary.is_object();
  const auto time = summary.find("time_s");
  return time != summary.end() && time->is_number() &&
         std::abs(time->get<double>() - times->back()) <= 1e-9 * std::max(1.0, times->back());
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
    if (fs::exists(folder.path + in_space_history))
      folder.told = "the glass became a body in space, where this page does not follow it: solid/wall.svg shows it";
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
