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

const std::string passing = ".parison_workbench_";  // begin of the name of a file until it has its own

std::string text_of(const std::string& file) {
  const core::InputFile content = core::read_input_file(file, most_bytes);
  if (!content.problem.empty()) throw core::CaseError(fmt::format("{}: {}", file, content.problem));
  return content.content;
}

/// The name of a file beside a case that is there as long as this process needs it.
std::string beside_of(const fs::path& file) {
  return (file.parent_path() / passing_name(passing, file.filename().string())).string();
}

}  // namespace

void write_users_file(const std::string& file, const std::string& text) {
  const fs::path path(file);
  const std::string beside = beside_of(path);
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

PassingCopy::PassingCopy(const std::string& case_file, const std::string& text) : file_(beside_of(case_file)) {
  core::write_text(file_, text);
}

PassingCopy::~PassingCopy() {
  std::error_code ignored;
  fs::remove(file_, ignored);
}

OpenCase::OpenCase(std::string file)
    : file_(std::move(file)),
      kept_((fs::path(file_).parent_path() / (".parison_undo_" + fs::path(file_).filename().string())).string()),
      history_(kept_.read(text_of(file_))) {
  remove_left(Left::file, fs::path(file_).parent_path().string(), passing);
}

void OpenCase::keep(const std::string& text, bool is_own) {
  history_.change(text);
  kept_.add_change(history_, is_own);
  ++version_;
}

void OpenCase::look() {
  const std::string now = text_of(file_);
  if (now != text()) keep(now, false);
}

void OpenCase::write(const std::string& text) {
  if (text.size() > most_bytes)
    throw core::CaseError(fmt::format("{}: {} bytes were given, allowed are {}", file_, text.size(), most_bytes));
  if (text_of(file_) != history_.now)
    throw core::CaseError(fmt::format("{}: another program has changed the file meanwhile", file_));
  write_users_file(file_, text);
}

void OpenCase::set(const std::vector<std::string>& assignments) {
  std::string text = history_.now;
  for (const std::string& assignment : assignments) text = core::edited_case_text(text, file_, assignment);
  replace(text);
}

void OpenCase::replace(const std::string& text) {
  if (text == history_.now) return;
  write(text);
  keep(text, true);
}

void OpenCase::undo() {
  if (history_.before.empty()) return;
  write(history_.before.back());
  history_.undo();
  kept_.add_undo();
  ++version_;
}

void OpenCase::redo() {
  if (history_.after.empty()) return;
  write(history_.after.back());
  history_.redo();
  kept_.add_redo();
  ++version_;
}

}  // namespace parison::tools
