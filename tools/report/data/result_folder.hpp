#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// A CSV file of a result folder by its columns; a text that is no number is NaN among the numbers.
struct ResultTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> numbers;     ///< of each column
  std::vector<std::vector<std::string>> texts;  ///< of each column whose first row is no number, else empty

  std::size_t rows() const { return numbers.empty() ? 0 : numbers[0].size(); }
  /// The place of a column, -1 where there is none.
  int find(const std::string& name) const;
  /// The numbers of a column; null where there is none.
  const std::vector<double>* column(const std::string& name) const;
};

/// Reads a CSV file, without a last line that a run is still writing; empty where there is no such file.
ResultTable read_table(const std::string& path);

/// What has become of a run.
enum class RunState { running, completed, stopped, failed, ended };

/// A stage as far as it has run.
struct StageSpan {
  std::string name;
  double start, end;     ///< s
  std::string ended_by;  ///< empty while it is not known
};

/// The folder that a run writes, as far as it has been written.
struct ResultFolder {
  std::string path, name;
  ResultTable history;   ///< of round glass, then of glass in space as far as it has the same columns
  double round_end = 0;  ///< s, of the last step of round glass
  std::string summary;   ///< text of summary.json where it belongs to the last row of the history, else empty
  RunState state = RunState::ended;
  std::string told;  ///< a sentence on the state: why it stopped, what to do
  std::vector<StageSpan> stages;
};

/// Reads a result folder; throws core::CaseError where it is no folder or none of a run.
ResultFolder read_folder(const std::string& path);

/// Whether a folder holds the history of a run.
bool is_result_folder(const std::string& path);

/// Whether glass in space that starts at a time, s, is that of this run and not of an earlier one in its folder.
bool starts_where_round_ended(const ResultFolder& folder, double time);

/// Whether another process is writing the history of a run just now.
bool is_written(const std::string& path);

/// A word for a state, as the page has it.
std::string name_of(RunState state);

}  // namespace parison::tools
