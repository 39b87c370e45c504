#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/io/json.hpp"
#include "tools/workbench/folder/open_folder.hpp"

namespace parison::tools {

/// Runs of cases as processes of their own, which end with a checkpoint where the workbench ends before them.
class Runs {
 public:
  explicit Runs(const OpenFolder& folder) : folder_(folder) {}

  /// The names of the results of a case, newest first.
  std::vector<std::string> of_case(const std::string& case_file) const;
  /// Starts a run and returns the name of its results. Refuses more at once than the machine has processors.
  std::string start(const std::string& case_file, const std::string& accuracy);
  /// Starts runs of a case and of changes of it, key=value, which end with a report of their differences.
  std::string start_what_if(const std::string& case_file, const std::string& accuracy,
                            const std::vector<std::string>& changes);
  /// Starts a search for values of a case between bounds, "key=from to to", that give a wall as a goal file has it,
  /// counted from a height on, or from the rim where that is empty.
  std::string start_search(const std::string& case_file, const std::string& accuracy, const std::string& wall,
                           const std::string& from, const std::vector<std::string>& bounds);
  /// Goes on with one from its last checkpoint.
  void resume(const std::string& results);
  /// Asks one to end with a checkpoint.
  void stop(const std::string& results);
  /// What has become of one: state, time, stage, and the end of what it printed.
  void add_state(const std::string& results, core::JsonWriter& json);

 private:
  void begin(const std::vector<std::string>& words, const std::string& results);
  bool is_alive(const std::string& results);
  /// What has become of runs that are compared: their report is made once they have ended.
  void add_study(const std::string& results, bool alive, core::JsonWriter& json);

  const OpenFolder& folder_;
  std::map<std::string, int> children_;  ///< by the name of the results
  std::set<std::string> reported_;       ///< results for which a report was begun
};

}  // namespace parison::tools
