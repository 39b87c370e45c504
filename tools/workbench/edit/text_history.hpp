#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// A text with what it was before, and what was undone.
struct TextHistory {
  std::string now;
  std::vector<std::string> before, after;  ///< the next one last

  void change(const std::string& text);
  void undo();
  void redo();
};

/// The history of a text in a file beside it, to which each change is appended: it outlives the program. A file that is
/// broken, as by a kill, counts up to there; one that cannot be written is left out.
class HistoryFile {
 public:
  explicit HistoryFile(std::string path) : path_(std::move(path)) {}

  /// What the file has, and `now` as the last change where that is another.
  TextHistory read(const std::string& now);
  /// The last change of a history; one by another program does not begin a file.
  void add_change(const TextHistory& history, bool begins);
  void add_undo() { append("undo 0\n\n"); }
  void add_redo() { append("redo 0\n\n"); }

 private:
  void append(const std::string& record);
  void write_whole(const TextHistory& history);
  bool is_there() const;

  std::string path_;
};

}  // namespace parison::tools
