// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <filesystem>

#include "core/case/case_error.hpp"
#include "tools/new_container/new_case.hpp"
#include "tools/program/bundled_cases.hpp"
#include "tools/workbench/answers/workbench_state.hpp"
#include "tools/workbench/folder/recent_folders.hpp"
#include "tools/workbench/runs/expected.hpp"

namespace parison::tools {
namespace {

/// The first so many names.
void add_names(const std::string& key, const std::vector<std::string>& names, core::JsonWriter& json) {
  constexpr std::size_t most = 200;
  json.open_list(key);
  for (std::size_t i = 0; i < names.size() && i < most; ++i) json.add("", names[i]);
  json.close();
}

/// The texts of a list of what was asked.
std::vector<std::string> texts_of(const Asked& asked, const char* name) {
  std::vector<std::string> texts;
  if (const Asked* list = asked.find(name))
    for (const Asked& one : list->items) texts.push_back(one.text);
  return texts;
}

}  // namespace

void add_start(WorkbenchState& state, const Asked&, core::JsonWriter& json) {
  json.add("folder", state.folder.path());
  json.open_list("bundled");
  for (const BundledCase& one : bundled_cases()) {
    json.open_object("");
    json.add("name", one.name);
    json.add("title", one.title);
    json.add("picture", !one.picture.empty());
    json.close();
  }
  json.close();
  const FolderContent content = state.folder.content();
  add_names("cases", content.cases, json);
  add_names("results", content.results, json);
  add_names("recent", recent_folders(), json);
}

void open_recent(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  json.add("address", state.address_of(asked.text_of("folder")));
}

void make_case(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  NewRequest request;
  const std::string name = asked.text_of("name");
  request.folder = state.folder.new_folder(name);
  request.like = asked.text_of("like");
  request.wish = {asked.text_of("process"), asked.text_of("weight"), asked.text_of("capacity"), asked.text_of("height"),
                  asked.text_of("finish")};
  const std::lock_guard<std::mutex> lock(state.reading);
  write_new_case(request);
  json.add("case", name + "/case.toml");
}

void start_run(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  const OpenCase& one = state.open(asked.text_of("case"));
  json.add("results", state.runs.start(one.file(), asked.text_of("accuracy")));
}

void start_what_if(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  const OpenCase& one = state.open(asked.text_of("case"));
  json.add("results", state.runs.start_what_if(one.file(), asked.text_of("accuracy"), texts_of(asked, "set")));
}

void start_search(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  const OpenCase& one = state.open(asked.text_of("case"));
  const std::string table = wanted_wall_of(state, asked), wall = table.empty() ? asked.text_of("wall") : table;
  if (table.empty() && wall.find(".csv") != wall.npos)
    throw core::CaseError(fmt::format("\"{}\" was found, allowed are even and a thickness such as 2.5 mm", wall));
  const std::vector<std::string> bounds = texts_of(asked, "bounds");
  json.add("results",
           state.runs.start_search(one.file(), asked.text_of("accuracy"), wall, asked.text_of("from"), bounds));
}

void stop_run(WorkbenchState& state, const Asked& asked, core::JsonWriter&) {
  state.runs.stop(asked.text_of("results"));
}

void resume_run(WorkbenchState& state, const Asked& asked, core::JsonWriter&) {
  state.runs.resume(asked.text_of("results"));
}

void start_sketch(WorkbenchState& state, const Asked& asked, core::JsonWriter&) {
  const OpenCase& one = state.open(asked.text_of("case"));
  state.sketch.start(one.file(), one.version());
}

void add_results(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  const std::string file = state.open(asked.text_of("case")).file();
  const std::vector<std::string> names = state.runs.of_case(file);
  add_names("results", names, json);
  std::vector<EndedRun> known;
  if (const std::string sketch = state.sketch.ended_of(file); !sketch.empty()) known.push_back({"sketch", sketch});
  for (const std::string& name : names) known.push_back({name, state.folder.existing(name)});
  const std::lock_guard<std::mutex> lock(state.reading);
  add_expected(file, texts_of(asked, "accuracies"), known, json);
}

void add_outline(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  add_finished_wall(state.folder.existing(asked.text_of("results")), wanted_wall_of(state, asked), json);
}

}  // namespace parison::tools
