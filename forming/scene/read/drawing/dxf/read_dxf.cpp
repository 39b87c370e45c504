// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "core/case/given_file.hpp"
#include "forming/scene/read/drawing/dxf/dxf_curves.hpp"
#include "forming/scene/read/drawing/dxf/dxf_file.hpp"
#include "forming/scene/read/drawing/dxf/dxf_layers.hpp"
#include "forming/scene/read/drawing/read_section.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using core::Segment;
using Entity = DxfEntity;

/// Texts, dimensions and the like, and everything in paper space or made invisible.
bool is_annotation(const Entity& entity) {
  static const std::vector<std::string> kinds{"TEXT",     "MTEXT", "DIMENSION", "LEADER", "MULTILEADER", "POINT",
                                              "VIEWPORT", "HATCH", "TOLERANCE", "ATTRIB", "ATTDEF"};
  return std::find(kinds.begin(), kinds.end(), entity.kind) != kinds.end() || text_of(entity, 67) == "1" ||
         text_of(entity, 60) == "1";
}

/// The wanted entities of a drawing, those of inserted blocks in their places.
class Drawing {
 public:
  /// `layer` empty for all that are shown; `unit` of a drawing unit in m, none for that of the file.
  Drawing(const DxfFile& file, const CaseTable& table, const std::string& layer, std::optional<double> unit)
      : curves_(file),
        file_(file),
        table_(table),
        wanted_layer_(in_small_letters(layer)),
        unit_(unit),
        layers_(file, header),
        blocks_(file, header) {}

  void take(const Entity& entity) {
    using Section = Entity::Section;
    if (entity.section == Section::tables) return layers_.take(entity);
    if (entity.section == Section::blocks) return blocks_.take(entity);
    if (!is_begun_) begin();
    add(entity, "", wanted_, 0);
  }

  std::vector<Segment> curves() const {
    curves_.require_end_of_polyline();
    return curves_.all();
  }
  /// The layers with curves, and with how many entities that are not shown.
  std::string names_of_layers() const {
    constexpr std::size_t most = 20;
    std::vector<std::string> names;
    for (const auto& [key, layer] : found_)
      if (names.size() < most)
        names.push_back(fmt::format("\"{}\"{}", layer.name, layer.is_hidden ? " (frozen or switched off)" : ""));
    return fmt::format("{}{}", fmt::join(names, ", "), found_.size() > most ? ", ..." : "");
  }
  std::size_t hidden() const { return hidden_; }
  /// As the boundary_id of the curves counts them.
  const std::vector<std::string>& layers() const { return names_; }

  DxfHeader header;

 private:
  struct Layer {
    std::string name;
    bool is_hidden;
  };

  /// With the first entity: the unit is known by now.
  void begin() {
    is_begun_ = true;
    if (unit_) require_same_unit(file_, header, *unit_);
    if (!unit_) unit_ = unit_of(file_, header);
    if (!unit_)
      core::refuse(table_.node(),
                   fmt::format("unit: missing, and \"{}\" does not say its own ($INSUNITS), allowed is a "
                               "unit such as unit = \"mm\"",
                               file_.path));
    curves_.unit = *unit_;
  }

  bool is_wanted(const Entity& entity, const std::string& layer) {
    if (is_annotation(entity)) return false;
    const bool is_hidden = layers_.is_hidden(layer);
    const std::string key = in_small_letters(layer);
    if (entity.kind != "INSERT") found_[key] = {layer, is_hidden};
    if (!wanted_layer_.empty()) return key == wanted_layer_;
    if (is_hidden && entity.kind != "INSERT") ++hidden_;
    return !is_hidden;
  }

  /// What lies on layer 0 of a block lies on that of its insertion; `wanted` is that of the entity before.
  void add(const Entity& entity, const std::string& of_insertion, bool& wanted, int depth) {
    const std::string own = layers_.layer_of(entity), layer = depth > 0 && own == "0" ? of_insertion : own;
    const bool part = entity.kind == "VERTEX" || entity.kind == "SEQEND";  // of the polyline before
    if (!part) wanted = is_wanted(entity, layer);
    if (!part && wanted) number_layer(layer);
    if (entity.kind == "INSERT" && !is_annotation(entity)) return insert(entity, layer, depth);
    if (wanted) curves_.add(entity);
  }

  void number_layer(const std::string& layer) {
    const auto found = std::find(names_.begin(), names_.end(), layer);
    curves_.layer = static_cast<core::Index>(found - names_.begin());
    if (found == names_.end()) names_.push_back(layer);
  }

  void insert(const Entity& entity, const std::string& layer, int depth) {
    constexpr int deepest = 8, most = 10000;
    if (depth == deepest || ++insertions_ > most)
      file_.refuse(entity.line,
                   fmt::format("blocks within blocks over more than {} levels or more than {} of them were "
                               "found, allowed are fewer",
                               deepest, most));
    if (layers_.is_frozen(layer)) return;
    const DxfBlock& block = blocks_.inserted(entity);
    const Placement placement = placement_of(file_, entity, block, curves_.unit);
    curves_.require_end_of_polyline();
    const std::size_t first = curves_.size();
    bool wanted = false;
    for (const Entity& inside : block.entities) add(inside, layer, wanted, depth + 1);
    curves_.require_end_of_polyline();
    if (curves_.size() > first) curves_.require_flat(entity);
    curves_.place(first, placement);
  }

  DxfCurves curves_;
  const DxfFile& file_;
  const CaseTable& table_;
  std::string wanted_layer_;  ///< in small letters
  std::optional<double> unit_;
  DxfLayers layers_;
  DxfBlocks blocks_;
  std::map<std::string, Layer> found_;  ///< layers with curves, by their names in small letters
  std::vector<std::string> names_;      ///< of the layers of wanted curves
  std::size_t hidden_ = 0;              ///< entities left out since they are not shown
  bool wanted_ = false, is_begun_ = false;
  int insertions_ = 0;
};

std::optional<double> unit_of_case(const CaseTable& table) {
  const auto* unit = table.find("unit");
  if (!unit) return {};
  const auto read = core::parse_quantity("1 " + core::text(*unit), core::dimension::length);
  if (!read.problem.empty()) core::refuse(*unit, read.problem);
  return read.value;
}

}  // namespace

std::vector<Segment> read_dxf(const CaseTable& table, const std::string& path, std::vector<std::string>& layers,
                              std::vector<std::string>& notes) {
  const CaseNode &node = table.get("file"), *layer = table.find("layer");
  const std::string content = core::read_given_file(node, path, "a drawing with its path relative to the case file");
  const DxfFile file{node, path};
  Drawing drawing(file, table, layer ? core::text(*layer) : "", unit_of_case(table));
  read_entities(file, content, drawing.header, [&](const Entity& entity) { drawing.take(entity); });
  std::vector<Segment> curves = drawing.curves();
  layers = drawing.layers();
  const std::string names = drawing.names_of_layers();
  if (curves.empty() && layer)
    core::refuse(*layer, fmt::format("no lines or arcs were found on layer \"{}\" of \"{}\", allowed {}", layer->text,
                                     path, names.empty() ? "is a DXF file with some" : "are " + names));
  if (curves.empty())
    core::refuse(node,
                 fmt::format("no lines or arcs were found in \"{}\", allowed is a DXF file with some{}", path,
                             names.empty() ? "" : ", or layer with the name of a layer that is not shown: " + names));
  if (drawing.hidden() > 0)
    notes.push_back(
        fmt::format("{} entities of \"{}\" on layers that are frozen or switched off were left out (layer "
                    "takes one of them): the layers are {}",
                    drawing.hidden(), node.text, names));
  return curves;
}

}  // namespace parison::forming
