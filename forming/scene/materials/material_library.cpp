// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/materials/material_library.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/case/given_file.hpp"
#include "thermal/radiation/planck.hpp"

namespace parison::forming {

thermal::Band merged_bands(const std::vector<thermal::Band>& bands, double temperature) {
  double emitted = 0, absorbed = 0, from = 0;
  for (const thermal::Band& band : bands) {
    const double power = thermal::emission_between(from, band.up_to, temperature).value;
    emitted += power;
    absorbed += power * band.absorption * (band.relative.x.empty() ? 1 : band.relative(temperature));
    from = band.up_to;
  }
  return {from, absorbed / emitted};
}

/// The text of cases/materials.toml; the build makes the file that defines it.
extern const char* const library_text;

namespace {

using core::CaseNode;

const CaseNode& library() {
  static const CaseNode root = core::parse_case_text(library_text, "materials.toml");
  return root;
}

/// Puts `material.` before the keys of an entry, as in a case.
void place_in_case(CaseNode& node) {
  node.key = "material." + node.key;
  for (CaseNode& item : node.items) place_in_case(item);
}

/// The case's table of materials, made where it has none.
CaseNode& materials_of(core::CaseFile& file) {
  if (CaseNode* found = member(file.root, "material")) return *found;
  CaseNode table;
  table.file = file.path;
  table.line = 1;
  table.key = table.name = "material";
  file.root.items.push_back(table);
  return file.root.items.back();
}

/// Adds a bundled material that a body names and the case has not.
void add_named(const CaseNode& material, core::CaseFile& file, std::vector<std::string>& used) {
  const CaseNode* entry = material.kind == CaseNode::Kind::text ? member(library(), material.text) : nullptr;
  if (!entry) return;
  CaseNode& materials = materials_of(file);
  if (materials.kind != CaseNode::Kind::table || member(materials, entry->name)) return;
  CaseNode copy = *entry;
  place_in_case(copy);
  materials.items.push_back(copy);
  used.push_back(entry->name);
}

/// Adds to a material of the case the values that it does not give itself.
void complete(CaseNode& material, std::vector<std::string>& used) {
  CaseNode* like = member(material, "like");
  if (!like) return;
  const CaseNode* entry = member(library(), core::text(*like));
  if (!entry) core::choice(*like, library_names());
  CaseNode copy = *entry;
  place_in_case(copy);
  const auto is_about = [](const std::string& key) { return key == "about" || key == "source" || key == "assumed"; };
  for (const CaseNode& item : copy.items)
    if (!member(material, item.name) && !is_about(item.name)) material.items.push_back(item);
  used.push_back(entry->name);
}

/// Whether an assignment is to a value of a material.
bool is_of_material(const std::string& assignment) {
  return core::trimmed(assignment).rfind("material.", 0) == 0;
}

/// Whether an assignment is to the top-level key `cooling`.
bool is_of_cooling(const std::string& assignment) {
  return core::trimmed(assignment).rfind("cooling=", 0) == 0;
}

}  // namespace

const std::vector<NamedMaterial>& library_materials() {
  static const std::vector<NamedMaterial> materials = read_materials(library());
  return materials;
}

std::vector<std::string> library_names() {
  std::vector<std::string> names;
  for (const CaseNode& item : library().items) names.push_back(item.name);
  return names;
}

std::string library_entry(const std::string& name) {
  const std::string text = library_text, head = fmt::format("\n[{}]", name);
  const auto at = text.find(head);
  if (at == text.npos) return "";
  const auto end = text.find("\n[", at + 1);
  std::string entry = text.substr(at + 1, end == text.npos ? text.npos : end - at - 1);
  while (!entry.empty() && entry.back() == '\n') entry.pop_back();
  return entry + "\n";
}

std::vector<std::string> add_library_materials(core::CaseFile& file) {
  std::vector<std::string> used;
  if (CaseNode* materials = member(file.root, "material"); materials && materials->kind == CaseNode::Kind::table)
    for (CaseNode& material : materials->items) complete(material, used);
  std::vector<CaseNode> named;
  if (CaseNode* glass = member(file.root, "glass"))
    if (const CaseNode* material = member(*glass, "material")) named.push_back(*material);
  if (CaseNode* tools = member(file.root, "tool"))
    for (CaseNode& tool : tools->items)
      if (const CaseNode* material = member(tool, "material")) named.push_back(*material);
  for (const CaseNode& material : named) add_named(material, file, used);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

core::CaseFile read_case(const std::string& path, const std::vector<std::string>& overrides,
                         std::vector<std::string>* used) {
  core::CaseFile file = core::read_case_file(path);
  std::vector<std::string> names = add_library_materials(file);
  for (const std::string& assignment : overrides)  // its stages may be set themselves
    if (is_of_cooling(assignment)) core::override_value(file, assignment);
  add_standard_cooling(file);
  for (std::string& name : add_library_materials(file)) names.push_back(std::move(name));
  for (const bool in_materials : {false, true}) {  // what names a material goes before what changes it
    for (const std::string& assignment : overrides)
      if (is_of_material(assignment) == in_materials && !is_of_cooling(assignment))
        core::override_value(file, assignment);
    for (std::string& name : add_library_materials(file)) names.push_back(std::move(name));
  }
  file.overrides = overrides;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  if (used) *used = std::move(names);
  return file;
}

void share_materials(core::CaseFile& one, core::CaseFile& other) {
  std::vector<std::string> added;
  for (auto [from, to] : {std::pair(&one, &other), std::pair(&other, &one)})
    if (CaseNode* materials = member(from->root, "material"); materials && materials->kind == CaseNode::Kind::table)
      for (const CaseNode& item : std::vector<CaseNode>(materials->items)) {
        CaseNode name;
        name.kind = CaseNode::Kind::text;
        name.text = item.name;
        add_named(name, *to, added);
      }
}

}  // namespace parison::forming
