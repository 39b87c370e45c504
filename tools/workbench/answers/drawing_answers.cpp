// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>

#include "core/case/case_error.hpp"
#include "core/case/case_file.hpp"
#include "core/case/text/case_text.hpp"
#include "core/io/files.hpp"
#include "forming/scene/read/drawing/placement.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/study/search/outcome.hpp"
#include "tools/workbench/answers/workbench_state.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

constexpr double mm = 1e-3;

/// The ending of the name of a drawing or a table in small letters, "dxf", "step", "stp" or "csv"; empty where it is no
/// such name.
std::string kind_of(const std::string& name) {
  static const std::regex allowed("[A-Za-z0-9_][A-Za-z0-9_. -]{0,100}\\.(dxf|step|stp|csv)", std::regex::icase);
  std::smatch match;
  if (!std::regex_match(name, match, allowed)) return "";
  std::string kind = match[1];
  std::transform(kind.begin(), kind.end(), kind.begin(), [](unsigned char c) { return std::tolower(c); });
  return kind;
}

/// The bytes of which each was sent as the letter with its number: drawings have code pages of their own.
std::string bytes_of(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto lead = static_cast<unsigned char>(text[i]);
    if (lead < 0x80 || i + 1 == text.size())
      bytes += text[i];
    else
      bytes += static_cast<char>(((lead & 0x03) << 6) | (static_cast<unsigned char>(text[++i]) & 0x3F));
  }
  return bytes;
}

/// Puts a file beside the case; one that is there already must be the same.
void keep(const std::string& path, const std::string& content) {
  if (!fs::exists(fs::symlink_status(path))) return write_users_file(path, content);
  if (!fs::is_regular_file(fs::symlink_status(path)) || core::read_text(path) != content)
    throw core::CaseError(fmt::format("{}: is there already and is another file, allowed is another name", path));
}

/// The path of a file beside the case, which gets the text that was sent with its name.
std::string file_beside(WorkbenchState& state, const std::string& name, const Asked& asked) {
  const std::string case_name = asked.text_of("case");
  const fs::path path = fs::path(state.open(case_name).file()).parent_path() / name;
  if (const std::string text = asked.text_of("text"); !text.empty()) {
    if (is_bundled(case_name)) throw core::CaseError("a bundled case gets no files, allowed is a copy of it");
    keep(path.string(), bytes_of(text));
  }
  if (!is_bundled(case_name)) state.folder.existing(path.lexically_relative(state.folder.path()).string());
  return path.string();
}

/// The table of a path with what is known of the drawing so far.
core::CaseNode table_of(const std::string& name, const Asked& asked) {
  std::string text = fmt::format("{{ file = {}, from = \"(0, 0) mm\"", core::quoted(name));
  for (const char* key : {"unit", "origin", "axis", "turn"})
    if (const std::string value = asked.text_of(key); !value.empty())
      text += fmt::format(", {} = {}", key, core::quoted(value));
  core::CaseNode place;
  place.file = name;
  return core::parse_value(text + " }", place);
}

/// What a STEP file has is one layer without a name.
void add_layers(const forming::DrawnCurves& drawing, core::JsonWriter& json) {
  constexpr int chords = 12;  // of an arc
  const std::size_t layers = std::max<std::size_t>(drawing.layers.size(), drawing.curves.empty() ? 0 : 1);
  json.open_list("layers");
  for (std::size_t i = 0; i < layers; ++i) {
    json.open_object("");
    json.add("name", drawing.layers.empty() ? "" : drawing.layers[i]);
    json.open_list("curves_mm");
    for (const core::Segment& curve : drawing.curves) {
      if (static_cast<std::size_t>(curve.boundary_id) != i) continue;
      json.open_list("");
      const int count = curve.is_arc ? chords : 1;
      for (int k = 0; k <= count; ++k) {
        const core::Point x = core::point_at(curve, double(k) / count);
        json.add("", x[0] / mm);
        json.add("", x[1] / mm);
      }
      json.close();
    }
    json.close();
    json.close();
  }
  json.close();
}

}  // namespace

void add_drawings(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  const fs::path folder = fs::path(state.open(asked.text_of("case")).file()).parent_path();
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  for (const bool tables : {false, true}) {
    json.open_list(tables ? "tables" : "drawings");
    for (const std::string& name : names)
      if (const std::string kind = kind_of(name); !kind.empty() && (kind == "csv") == tables) json.add("", name);
    json.close();
  }
}

std::string wanted_wall_of(WorkbenchState& state, const Asked& asked) {
  const std::string name = asked.text_of("wanted");
  if (name.empty()) return "";
  if (kind_of(name) != "csv")
    throw core::CaseError(
        fmt::format("\"{}\" was found, allowed are names of letters, digits, _, - and . that end "
                    "with .csv",
                    name));
  return file_beside(state, name, asked);
}

void take_wanted_wall(WorkbenchState& state, const Asked& asked, core::JsonWriter&) {
  forming::read_wall_table(wanted_wall_of(state, asked));
}

void add_drawing(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  const std::string name = asked.text_of("name"), kind = kind_of(name);
  if (kind.empty() || kind == "csv")
    throw core::CaseError(fmt::format(
        "\"{}\" was found, allowed are names of letters, digits, _, - and . that end with .dxf, .step or .stp", name));
  const std::string folder = fs::path(file_beside(state, name, asked)).parent_path().string();
  const core::CaseNode node = table_of(name, asked);
  const core::CaseTable table(node, {"file", "from", "to", "unit", "layer", "origin", "axis", "turn"});
  std::vector<std::string> notes;
  forming::DrawnCurves drawing;
  const std::lock_guard<std::mutex> lock(state.reading);
  try {
    drawing = forming::read_drawing(table, folder, notes);
    forming::place(table, drawing.is_cut, drawing.curves);
  } catch (const core::CaseError& error) {
    drawing = {};
    json.add("problem", error.what());
  }
  json.add("name", name);
  json.add("step", kind != "dxf");
  json.add("cut", drawing.is_cut);
  add_layers(drawing, json);
  json.open_list("notes");
  for (const std::string& note : notes) json.add("", note);
  json.close();
}

}  // namespace parison::tools
