// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "core/case/case_error.hpp"
#include "core/case/case_file.hpp"
#include "core/case/text/case_text.hpp"
#include "core/io/files.hpp"
#include "forming/scene/read/drawing/placement.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "tools/workbench/answers/workbench_state.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

constexpr double mm = 1e-3;

void check_name(const std::string& name) {
  static const std::regex allowed("[A-Za-z0-9_][A-Za-z0-9_. -]{0,100}\\.[dD][xX][fF]");
  if (!std::regex_match(name, allowed))
    throw core::CaseError(
        fmt::format("\"{}\" was found, allowed are names of letters, digits, _, - and . that end with "
                    ".dxf",
                    name));
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

/// Puts a drawing beside the case; one that is there already must be the same.
void keep(const std::string& path, const std::string& content) {
  if (!fs::exists(fs::symlink_status(path))) return write_users_file(path, content);
  if (!fs::is_regular_file(fs::symlink_status(path)) || core::read_text(path) != content)
    throw core::CaseError(fmt::format("{}: is there already and is another drawing, allowed is another name", path));
}

/// The table of a path with what is known of the drawing so far.
core::CaseNode table_of(const std::string& name, const Asked& asked) {
  std::string text = fmt::format("{{ file = {}, from = \"(0, 0) mm\"", core::quoted(name));
  for (const char* key : {"unit", "origin", "axis"})
    if (const std::string value = asked.text_of(key); !value.empty())
      text += fmt::format(", {} = {}", key, core::quoted(value));
  core::CaseNode place;
  place.file = name;
  return core::parse_value(text + " }", place);
}

void add_layers(const std::vector<std::string>& layers, const std::vector<core::Segment>& curves,
                core::JsonWriter& json) {
  constexpr int chords = 12;  // of an arc
  json.open_list("layers");
  for (std::size_t i = 0; i < layers.size(); ++i) {
    json.open_object("");
    json.add("name", layers[i]);
    json.open_list("curves_mm");
    for (const core::Segment& curve : curves) {
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
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".dxf" || entry.path().extension() == ".DXF")
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  json.open_list("drawings");
  for (const std::string& name : names) json.add("", name);
  json.close();
}

void add_drawing(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  const std::string name = asked.text_of("name"), case_name = asked.text_of("case");
  check_name(name);
  const fs::path path = fs::path(state.open(case_name).file()).parent_path() / name;
  if (const std::string text = asked.text_of("text"); !text.empty()) {
    if (is_bundled(case_name)) throw core::CaseError("a bundled case gets no drawings, allowed is a copy of it");
    keep(path.string(), bytes_of(text));
  }
  if (!is_bundled(case_name)) state.folder.existing(path.lexically_relative(state.folder.path()).string());
  const core::CaseNode node = table_of(name, asked);
  const core::CaseTable table(node, {"file", "from", "to", "unit", "layer", "origin", "axis", "turn"});
  std::vector<std::string> layers, notes;
  std::vector<core::Segment> curves;
  try {
    curves = forming::read_dxf(table, path.string(), layers, notes);
    forming::place(table, false, curves);
  } catch (const core::CaseError& error) {
    json.add("problem", error.what());
  }
  json.add("name", name);
  add_layers(layers, curves, json);
  json.open_list("notes");
  for (const std::string& note : notes) json.add("", note);
  json.close();
}

}  // namespace parison::tools
