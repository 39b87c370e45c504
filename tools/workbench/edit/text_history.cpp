// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/edit/text_history.hpp"

#include <fmt/core.h>

#include <charconv>
#include <exception>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/io/files.hpp"
#include "tools/workbench/edit/open_case.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_kept = 64'000'000;     // bytes of all former texts
constexpr std::size_t most_written = 16'000'000;  // bytes of the file
constexpr std::size_t most_rewritten = 4'000'000;

void drop_oldest(std::vector<std::string>& texts, std::size_t most) {
  std::size_t bytes = 0, first = texts.size();
  while (first > 0 && bytes + texts[first - 1].size() < most) bytes += texts[--first].size();
  texts.erase(texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(first));
}

/// "text 5\nabcde\n".
std::string record_of(const std::string& text) {
  return fmt::format("text {}\n{}\n", text.size(), text);
}

/// Does what the record at a place tells; the place of the next one, npos where it is not whole.
std::size_t replay(const std::string& content, std::size_t at, bool is_first, TextHistory& history) {
  const std::size_t space = at + 4, line = content.find('\n', at);
  if (line == content.npos || line < space + 2 || content[space] != ' ') return content.npos;
  std::size_t size = 0;
  const auto read = std::from_chars(content.data() + space + 1, content.data() + line, size);
  if (read.ec != std::errc() || read.ptr != content.data() + line || size > content.size() ||
      line + 1 + size >= content.size() || content[line + 1 + size] != '\n')
    return content.npos;
  const std::string kind = content.substr(at, 4), text = content.substr(line + 1, size);
  if (kind == "undo")
    history.undo();
  else if (kind == "redo")
    history.redo();
  else if (is_first)
    history.now = text;
  else
    history.change(text);
  return line + 2 + size;
}

}  // namespace

void TextHistory::change(const std::string& text) {
  before.push_back(std::exchange(now, text));
  drop_oldest(before, most_kept);
  after.clear();
}

void TextHistory::undo() {
  if (before.empty()) return;
  after.push_back(std::exchange(now, before.back()));
  before.pop_back();
}

void TextHistory::redo() {
  if (after.empty()) return;
  before.push_back(std::exchange(now, after.back()));
  after.pop_back();
}

bool HistoryFile::is_there() const {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(path_, ignored));
}

TextHistory HistoryFile::read(const std::string& now) {
  TextHistory history;
  history.now = now;
  if (!is_there() || fs::file_size(path_) > 2 * most_written) return history;
  const std::string content = core::read_text(path_);
  std::size_t at = 0;
  while (at < content.size()) {
    const std::size_t next = replay(content, at, at == 0, history);
    if (next == content.npos) break;
    at = next;
  }
  if (at == 0) path_.clear();  // a file of somebody else
  const bool is_new = history.now != now;
  if (is_new) history.change(now);
  if (at < content.size() || is_new) write_whole(history);
  return history;
}

void HistoryFile::add_change(const TextHistory& history, bool begins) {
  if (is_there() && fs::file_size(path_) < most_written)
    append(record_of(history.now));
  else if (begins || is_there())
    write_whole(history);
}

void HistoryFile::append(const std::string& record) {
  if (is_there()) std::ofstream(path_, std::ios::binary | std::ios::app) << record << std::flush;
}

void HistoryFile::write_whole(const TextHistory& history) {
  std::error_code ignored;
  if (path_.empty() || (fs::exists(fs::symlink_status(path_, ignored)) && !is_there())) return;
  std::vector<std::string> before = history.before;
  drop_oldest(before, most_rewritten);
  std::string content;
  for (const std::string& text : before) content += record_of(text);
  content += record_of(history.now);
  for (std::size_t i = history.after.size(); i-- > 0;) content += record_of(history.after[i]);
  for (std::size_t i = 0; i < history.after.size(); ++i) content += "undo 0\n\n";
  try {
    write_users_file(path_, content);
  } catch (const std::exception&) {  // the case itself is written
  }
}

}  // namespace parison::tools
