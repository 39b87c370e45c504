#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <string_view>
#include <vector>

#include "core/case/case_file.hpp"

namespace parison::core {

/// The content of a file that a value of a case names, a regular file of up to 100 MB. Refuses any other, and one that
/// is not there with `allowed`: "a CSV file with its path relative to the case file".
std::string read_given_file(const CaseNode& at, const std::string& path, const std::string& allowed);

/// Gives out a text line by line without its ends of line, nor the mark with which spreadsheets begin a file; false at
/// its end.
class Lines {
 public:
  explicit Lines(std::string_view text);
  bool next(std::string_view& line);
  int number() const { return number_; }  ///< of the last line, from 1

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// A text without the blanks, tabs and line breaks at its ends.
std::string_view trimmed(std::string_view text);

/// A text with small letters for its capitals from A to Z.
std::string in_small_ascii(std::string_view text);

/// The parts of a text between its commas, or another sign; the last has the rest where there are more than a thousand.
std::vector<std::string_view> split(std::string_view text, char sign = ',');

}  // namespace parison::core
