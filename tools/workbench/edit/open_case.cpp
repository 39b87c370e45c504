// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/edit/open_case.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "core/case/case_error.hpp"
#include "core/case/text/case_edit.hpp"
#include "core/io/files.hpp"
#include "core/io/input_file.hpp"
#include "tools/workbench/folder/left_files.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = 4'000'000;  // of a case file, as the reader has it
constexpr std::size_t most_kept = 64'000'000;  // bytes of all former texts

const std::string passing = ".parison_workbench_";  // begin of the name of a file until it has its own

std::string text_of(const std::string& file) {
  const core::InputFile content = core::read_input_file(file, most_bytes);
  if (!content.problem.empty()) throw core::CaseError(fmt::format("{}: {}", file, content.problem));
  return content.content;
}

}  // namespace

void write_users_file(const std::string& file, const std::string& text) {
  const fs::path path(file);
  const std::string beside = (path.parent_path() / passing_name(passing, path.filename().string())).string();
  try {
    core::write_text(beside, text);
    if (fs::exists(path)) fs::permissions(beside, fs::status(path).permissions());
    core::sync_to_disk(beside);
    fs::rename(beside, path);
  } catch (...) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw;
  }
  core::sync_to_disk(path.parent_path().string());
}

OpenCase::OpenCase(std::string file) : file_(std::move(file)), text_(text_of(file_)) {
  remove_left(Left::file, fs::path(file_).parent_path().string(), passing);
}

void OpenCase::keep(const std::string& text) {
  before_.push_back(text_);
  std::size_t bytes = 0, first = before_.size();
  while (first > 0 && bytes + before_[first - 1].size() < most_kept) bytes += before_[--first].size();
  before_.erase(before_.begin(), before_.begin() + static_cast<std::ptrdiff_t>(first));
  text_ = text;
  ++version_;
}

void OpenCase::look() {
  const std::string now = text_of(file_);
  if (now == text_) return;
  keep(now);
  after_.clear();
}

void OpenCase::write(const std::string& text) {
  if (text.size() > most_bytes)
    throw core::CaseError(fmt::format("{}: {} bytes were given, allowed are {}", file_, text.size(), most_bytes));
  if (text_of(file_) != text_)
    throw core::CaseError(fmt::format("{}: another program has changed the file meanwhile", file_));
  write_users_file(file_, text);
}

void OpenCase::set(const std::vector<std::string>& assignments) {
  std::string text = text_;
  for (const std::string& assignment : assignments) text = core::edited_case_text(text, file_, assignment);
  replace(text);
}

void OpenCase::replace(const std::string& text) {
  if (text == text_) return;
  write(text);
  keep(text);
  after_.clear();
}

void OpenCase::undo() {
  if (before_.empty()) return;
  const std::string text = before_.back();
  write(text);
  before_.pop_back();
  after_.push_back(std::exchange(text_, text));
  ++version_;
}

void OpenCase::redo() {
  if (after_.empty()) return;
  const std::string text = after_.back();
  write(text);
  after_.pop_back();
  before_.push_back(std::exchange(text_, text));
  ++version_;
}

}  // namespace parison::tools
