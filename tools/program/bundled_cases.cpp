// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/bundled_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "core/case/case_error.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

std::set<std::string> bundled_names() {
  std::set<std::string> names;
  const fs::path cases = shared_file("cases");
  if (cases.empty()) return names;
  for (const auto& entry : fs::directory_iterator(cases))
    if (fs::exists(entry.path() / "case.toml")) names.insert(entry.path().filename().string());
  return names;
}

/// Where the bundled cases were looked for in vain, and what can be given instead.
std::string none_was_found() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  return fmt::format(
      "no bundled cases were found, neither in {} nor in {}, where they are kept beside the program; the folder of a "
      "case "
      "can be given instead of a name, such as /path/to/cases/jar",
      (program.parent_path() / "share/parison/cases").string(), (program / "share/parison/cases").string());
}

/// First line of the case's README without its mark of a heading.
std::string title(const fs::path& folder) {
  std::ifstream readme(folder / "README.md");
  std::string line;
  std::getline(readme, line);
  return line.substr(std::min(line.size(), line.find_first_not_of("# ")));
}

}  // namespace

fs::path shared_file(const std::string& name) {
  std::error_code unknown;  // where there is no /proc
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  if (program.empty()) return {};
  for (const fs::path& place : {program.parent_path(), program})
    if (const fs::path file = place / "share/parison" / name; fs::exists(file)) return file;
  return {};
}

std::string find_case(const std::string& given) {
  std::error_code unknown;  // as of a loop of links: the reading says what it is
  if (fs::exists(given, unknown) || unknown || fs::path(given).has_parent_path() ||
      fs::path(given).extension() == ".toml")
    return given;
  const auto names = bundled_names();
  if (names.count(given)) return (shared_file("cases") / given).string();
  throw core::CaseError(fmt::format(
      "{}: no such case, allowed is a case file, a folder that holds a case.toml or the name of a bundled case ({})",
      given, names.empty() ? none_was_found() : fmt::format("{}", fmt::join(names, ", "))));
}

std::string case_named(const std::string& directory, const std::string& given) {
  const fs::path beside = fs::path(directory) / given;
  std::error_code unknown;
  return fs::exists(beside, unknown) ? beside.string() : find_case(given);
}

std::vector<BundledCase> bundled_cases() {
  const fs::path cases = shared_file("cases");
  std::vector<BundledCase> found;
  for (const std::string& name : bundled_names()) {
    const fs::path picture = cases / name / "pictures/strip.png";
    found.push_back({name, title(cases / name), fs::exists(picture) ? picture.string() : ""});
  }
  return found;
}

std::string bundled_cases_table() {
  std::string table;
  for (const BundledCase& one : bundled_cases()) table += fmt::format("{:<20}{}\n", one.name, one.title);
  return table.empty() ? none_was_found() + "\n" : table + fmt::format("\nin {}\n", shared_file("cases").string());
}

}  // namespace parison::tools
