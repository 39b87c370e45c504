#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "tools/workbench/edit/text_history.hpp"

namespace parison::tools {

/// A case file as the page has read it, with what it was before, also before the program began; the file itself is the
/// truth.
class OpenCase {
 public:
  explicit OpenCase(std::string file);

  const std::string& file() const { return file_; }
  const std::string& text() const { return history_.now; }
  /// Rises with each change of the text.
  long version() const { return version_; }
  std::size_t undoable() const { return history_.before.size(); }
  std::size_t redoable() const { return history_.after.size(); }

  /// Takes over what another program has written.
  void look();
  /// Replaces values as core::override_value does, in place.
  void set(const std::vector<std::string>& assignments);
  /// Replaces the whole text.
  void replace(const std::string& text);
  void undo();
  void redo();

 private:
  void keep(const std::string& text, bool is_own);
  void write(const std::string& text);

  std::string file_;
  HistoryFile kept_;
  TextHistory history_;
  long version_ = 1;
};

/// Replaces a file of the user atomically, with the rights that it has; a reader sees the old text or the new one.
void write_users_file(const std::string& file, const std::string& text);

/// Another text of a case in a file beside it, as long as this lives: what it names beside it is found.
class PassingCopy {
 public:
  PassingCopy(const std::string& case_file, const std::string& text);
  ~PassingCopy();
  PassingCopy(const PassingCopy&) = delete;
  PassingCopy& operator=(const PassingCopy&) = delete;

  const std::string& file() const { return file_; }

 private:
  std::string file_;
};

}  // namespace parison::tools
