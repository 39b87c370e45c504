// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/written_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/manifest.hpp"
#include "core/process/run_error.hpp"

namespace parison::core {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path) {
  throw CaseError(
      fmt::format("{}: this was not written by parison, or has changed since; allowed is another output, or this one "
                  "once it is moved away",
                  path));
}

[[noreturn]] void fail(const std::string& path, const char* what, const std::error_code& error) {
  throw SystemError(fmt::format("{}: {}: {}", path, what, error.message()), error.value());
}

bool is_reserved(const std::string& name) {
  return name.rfind(reserved_prefix, 0) == 0;
}

std::string name_of(const std::string& path) {
  return fs::path(path).filename().string();
}

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

/// The first file in a folder that is not the program's own; empty where there is none.
std::string foreign_in(const std::string& path) {
  std::error_code error;
  const fs::file_status what = fs::symlink_status(path, error);
  if (what.type() == fs::file_type::not_found || is_reserved(name_of(path))) return {};
  if (error || what.type() != fs::file_type::directory) return is_own(path) ? "" : path;
  for (const auto& entry : fs::directory_iterator(path, error))
    if (std::string foreign = foreign_in(entry.path().string()); !foreign.empty()) return foreign;
  return error ? path : "";
}

/// Whether an entry of a folder may be written to or into: a file of the program, a folder of its files or an empty
/// one.
bool may_be_used(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(path, error))) return is_own(path);
  const bool has_manifest = fs::exists(fs::path(path) / manifest_name, error);
  return has_manifest || fs::is_empty(path, error);
}

/// Whether a name is one of these, of which some may be a beginning with a `*` behind it.
bool is_named(const std::string& name, const std::set<std::string>& names) {
  if (names.count(name) > 0) return true;
  for (std::size_t length = 1; length <= name.size(); ++length)
    if (names.count(name.substr(0, length) + '*') > 0) return true;
  return false;
}

}  // namespace

bool is_own(const std::string& path) {
  std::error_code error;
  if (is_reserved(name_of(path))) return true;
  if (!fs::is_regular_file(fs::symlink_status(path, error)) || error) return false;
  const auto noted = contents_noted(folder_of(path), name_of(path));
  if (noted.empty()) return false;
  if (noted.back().grows) return true;
  const std::string content = read_text(path);
  return std::any_of(noted.rbegin(), noted.rend(),  // the latest is the likely one
                     [&](const NotedContent& one) { return !one.grows && one.fits(content); });
}

bool is_damaged(const std::string& path) {
  std::error_code error;
  if (is_own(path) || !fs::is_regular_file(fs::symlink_status(path, error)) || error) return false;
  const auto noted = contents_noted(folder_of(path), name_of(path));
  const std::uint64_t size = fs::file_size(path, error);
  return !error && std::any_of(noted.begin(), noted.end(), [&](const NotedContent& one) { return one.size == size; });
}

void require_own(const std::string& path) {
  if (path.empty()) return;
  if (const std::string foreign = foreign_in(path); !foreign.empty()) refuse(foreign);
}

void claim_folder(const std::string& folder, const std::string& kind, const std::set<std::string>& names) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
  std::set<std::string> found;
  if (!error)
    for (const auto& entry : fs::directory_iterator(folder, error)) found.insert(entry.path().filename().string());
  if (error || ::access(folder.c_str(), W_OK | X_OK) != 0) {
    const char* what = error ? "made" : "written to";
    if (!error) error = {errno, std::generic_category()};
    throw CaseError(fmt::format("{}: the folder for the results cannot be {}: {}", folder, what, error.message()));
  }
  for (const std::string& name : found)
    if (const std::string path = folder + '/' + name; is_named(name, names) && !may_be_used(path)) refuse(path);
  const std::string before = kind_noted(folder);
  if (before != kind && !before.empty())
    throw CaseError(
        fmt::format("{}: the results of `parison {}` were found, allowed is a folder of its own for `parison {}`",
                    folder, before, kind));
  if (before.empty()) note_kind(folder, kind);
}

void note_written(const std::string& path, const std::string& content, bool on_disk) {
  note_content(folder_of(path), name_of(path), NotedContent::of(content), on_disk);
}

void note_written(const std::string& path, std::uint64_t size, std::uint64_t digest) {
  note_content(folder_of(path), name_of(path), {false, size, {digest}});
}

void note_growing(const std::string& path) {
  const auto noted = contents_noted(folder_of(path), name_of(path));
  if (!noted.empty() && noted.back().grows) return;
  note_content(folder_of(path), name_of(path), {true});
}

void take_made(const std::string& path) {
  const std::string made = unfinished_name(path);
  require_own(path);
  note_written(path, read_text(made));
  std::error_code error;
  fs::rename(made, path, error);
  if (error) fail(path, "cannot be replaced", error);
}

void remove_own(const std::string& path) {
  require_own(path);
  std::error_code error;
  fs::remove_all(path, error);
  if (error) fail(path, "cannot be removed", error);
}

void remove_own_files(const std::string& path) {
  std::error_code error;
  if (foreign_in(path).empty())
    fs::remove_all(path, error);
  else if (fs::is_directory(fs::symlink_status(path, error)))
    for (const auto& entry : fs::directory_iterator(path))
      if (entry.path().filename() != manifest_name) remove_own_files(entry.path().string());
  if (error) fail(path, "cannot be removed", error);
}

void rename_own(const std::string& from, const std::string& to) {
  if (!foreign_in(to).empty()) set_aside(to);
  for (const NotedContent& content : contents_noted(folder_of(from), name_of(from)))
    note_content(folder_of(to), name_of(to), content);
  std::error_code error;
  fs::rename(from, to, error);
  if (error) fail(from, "cannot be renamed", error);
}

void link_own(const std::string& from, const std::string& to) {
  if (!foreign_in(to).empty()) set_aside(to);
  remove_own(to);
  for (const NotedContent& content : contents_noted(folder_of(from), name_of(from)))
    note_content(folder_of(to), name_of(to), content);
  std::error_code error;
  fs::create_hard_link(from, to, error);
  if (error) fs::copy_file(from, to, error);
  if (error) fail(to, "cannot be written", error);
}

void set_aside(const std::string& path) {
  std::error_code error;
  std::string free = path + ".damaged";
  for (int i = 2; fs::exists(fs::symlink_status(free, error)); ++i) free = fmt::format("{}.damaged_{}", path, i);
  fs::rename(path, free, error);
  if (error) fail(path, "cannot be renamed", error);
}

std::string unfinished_name(const std::string& path) {
  const fs::path given(path);
  return (given.parent_path() / (std::string(reserved_prefix) + "unfinished_" + given.filename().string())).string();
}

}  // namespace parison::core
