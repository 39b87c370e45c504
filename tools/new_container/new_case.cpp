// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/new_container/new_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/scene/scene.hpp"
#include "tools/program/bundled_cases.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

void check_name(const std::string& folder, const std::string& name) {
  const auto allowed = [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '_' || c == '-'); };
  constexpr std::size_t longest = 100;  // of a case's name
  if (name.empty() || name.size() > longest || !std::all_of(name.begin(), name.end(), allowed))
    throw core::CaseError(
        fmt::format("{}: the name \"{}\" was found, allowed are names of up to {} letters, digits, _ and -", folder,
                    name, longest));
  std::error_code error;
  if (fs::exists(folder, error))
    throw core::CaseError(fmt::format("{}: exists already, allowed is a new folder", folder));
  if (error) throw core::CaseError(fmt::format("{}: the folder cannot be made: {}", folder, error.message()));
}

/// Takes away the comments with figures, which hold for the dimensions of the old case alone; whether there were some.
bool drop_old_figures(std::string& text) {
  static const std::regex line(R"(\n[ \t]*#[^"\n]*[0-9][^"\n]*(?=\n))"), end(R"([ \t]*#[^"\n]*[0-9][^"\n]*(?=\n))");
  const auto before = text.size();
  text = std::regex_replace(std::regex_replace(text, line, ""), end, "");
  return text.size() < before;
}

/// The lines with which a new case begins.
std::string head_of(const std::string& name, const std::string& origin, const std::string& folder) {
  return fmt::format(
      "# {0}: begun {1}. Change the paths of the tools, the mass of the gob and the times.\n"
      "#   parison check {2} --picture {0}.svg    draws it and says weight, capacity and where the plunger stops\n"
      "#   parison run {2} --accuracy draft       runs it; results/{0} has the results\n"
      "# Every key: cases/README.md. Dimensions that several paths share may have names: [dimension] r_body = \"37 "
      "mm\".\n",
      name, origin, folder);
}

/// The text of a bundled case without its own figures; whether there were some.
std::string text_like(const forming::Scene& scene, const std::string& name, bool& had_figures) {
  std::string text = core::read_text(scene.file);
  while (!text.empty() && text.front() == '#') text.erase(0, text.find('\n') + 1);
  const std::string old = fmt::format("case = \"{}\"", scene.name);
  if (const auto at = text.find(old); at != text.npos) text.replace(at, old.size(), fmt::format("case = \"{}\"", name));
  had_figures = drop_old_figures(text);
  return text;
}

/// Copies the files beside a case that a text of it names.
void copy_named_files(const forming::Scene& scene, const std::string& text, const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(scene.directory)) {
    const fs::path file = entry.path().lexically_relative(scene.directory);
    if (text.find("\"" + file.string() + "\"") == text.npos) continue;
    fs::create_directories((folder / file).parent_path());
    fs::copy_file(entry.path(), folder / file);
  }
}

}  // namespace

std::string write_new_case(const NewRequest& request) {
  const fs::path folder = fs::path(request.folder).lexically_normal();
  const std::string name = folder.filename().string(), file = (folder / "case.toml").string();
  check_name(request.folder, name);
  if (!request.wish.process.empty()) {
    const auto& [process, weight, capacity, height, finish] = request.wish;
    const std::string origin = fmt::format("as {}, {}, {} to the rim, {} high", process, weight, capacity, height);
    const std::string text = head_of(name, origin, request.folder) + container_text(request.wish, name);
    fs::create_directories(folder);
    core::write_text(file, text);
    forming::read_scene(folder.string(), "draft");
    return file + "\n";
  }
  const forming::Scene scene = forming::read_scene(find_case(request.like), "draft");
  bool had_figures = false;
  const std::string text = text_like(scene, name, had_figures);
  fs::create_directories(folder);
  copy_named_files(scene, text, folder);
  core::write_text(file, head_of(name, "like the bundled case " + scene.name, request.folder) + text);
  forming::read_scene(folder.string(), "draft");
  return file + "\n" + (had_figures ? fmt::format("  comments with figures of {} were left out\n", scene.name) : "");
}

int new_case(const NewRequest& request) {
  fmt::print("{}", write_new_case(request));
  return 0;
}

}  // namespace parison::tools
