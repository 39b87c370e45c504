#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/case/case_error.hpp"
#include "core/io/json.hpp"
#include "core/io/json_read.hpp"
#include "tools/report/watched_folder.hpp"
#include "tools/workbench/edit/open_case.hpp"
#include "tools/workbench/folder/open_folder.hpp"
#include "tools/workbench/runs/runs.hpp"
#include "tools/workbench/runs/sketch.hpp"

namespace parison::tools {

/// What the page asks for and what it gets.
using Asked = core::JsonValue;

/// All that the server knows: the folder, and of it the cases that were opened.
class WorkbenchState {
 public:
  explicit WorkbenchState(const std::string& path) : folder(path), runs(folder) {}

  /// A case by its name, read anew where another program has changed it.
  OpenCase& open(const std::string& name);
  /// The live report of results.
  WatchedFolder& watched(const std::string& results);

  /// The address of a workbench of its own for one of the recent folders, which ends with this one.
  std::string address_of(const std::string& recent);

  OpenFolder folder;
  Runs runs;
  Sketch sketch;
  std::mutex reading;  ///< held while a scene is read: gmsh has one state

 private:
  std::map<std::string, std::unique_ptr<OpenCase>> cases_;       ///< by their file
  std::map<std::string, std::unique_ptr<WatchedFolder>> shown_;  ///< by their folder; of the slow thread
  std::map<std::string, std::pair<int, std::string>>
      neighbours_;  ///< other workbenches and their logs, by their folder
};

/// The answers to one kind of question; each adds to the object that is open.
void add_start(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void add_case(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void add_news(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void change_values(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void change_text(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void undo_change(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void redo_change(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void add_check(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
/// The words that the reader allows in place of a word, `probe`, of a text that is not written: keys of a table, names.
void add_allowed(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void add_handles(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void open_recent(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void make_case(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void start_run(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void start_what_if(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void start_search(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void stop_run(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void resume_run(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void start_sketch(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void add_results(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void add_drawings(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void add_drawing(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void take_wanted_wall(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);
void add_outline(WorkbenchState& state, const Asked& asked, core::JsonWriter& json);

/// The values that are to be set, as override_value takes them: given as such, by a corner and its new place, or by the
/// contour of a drawing. The lock is held.
std::vector<std::string> assignments_of(const OpenCase& one, const Asked& asked);

/// The table of the wanted wall beside a case, `wanted`; empty where none is asked for.
std::string wanted_wall_of(WorkbenchState& state, const Asked& asked);

/// Adds an error with the place in the text that it is about.
void add_error(const core::CaseError& error, const std::string& text, core::JsonWriter& json);

}  // namespace parison::tools
