#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::core {

/// A comma-separated table as text: its cells have no blanks at their ends, blank lines do not count.
struct CsvTable {
  struct Row {
    int line;  ///< of the file, from 1
    std::vector<std::string> cells;
  };
  std::string path, heading_line;
  std::vector<std::string> heading;
  std::vector<Row> rows;

  /// The column with this heading, -1 without one.
  int find(const std::string& name) const;
  /// A cell as a number; NaN where it is none.
  double number(const Row& row, int column) const;
};

/// Throws CaseError where a row has more or fewer cells than the heading, SystemError where the file cannot be read.
CsvTable read_csv(const std::string& path);

}  // namespace parison::core
