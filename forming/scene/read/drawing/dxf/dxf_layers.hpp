#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "forming/scene/read/drawing/dxf/dxf_file.hpp"
#include "forming/scene/read/drawing/placement.hpp"

// Names in a DXF file, its layers and what of them is seen; private to the reading of drawings.

namespace parison::forming {

/// Entities that a drawing inserts as one, in their own frame.
struct DxfBlock {
  core::Point base;  ///< the point that comes to the place of the insertion, drawing units
  std::vector<DxfEntity> entities;
};

/// Gathers the blocks of a file from the entities of its section BLOCKS.
class DxfBlocks {
 public:
  DxfBlocks(const DxfFile& file, const DxfHeader& header) : file_(file), header_(header) {}
  void take(const DxfEntity& entity);
  /// The block that an INSERT names; refuses one that the file does not have.
  const DxfBlock& inserted(const DxfEntity& insert) const;

 private:
  /// The name of a block in small letters.
  std::string name_of(const DxfEntity& entity) const;

  const DxfFile& file_;
  const DxfHeader& header_;
  std::map<std::string, DxfBlock, std::less<>> blocks_;
  DxfBlock* open_ = nullptr;
  std::size_t groups_ = 0;
};

/// Where an INSERT puts its block, seen from behind where it says so; refuses arrays and scales that would bend
/// circles.
Placement placement_of(const DxfFile& file, const DxfEntity& insert, const DxfBlock& block, double unit);

/// A name of a DXF file in UTF-8: of files before 2007 by their code page (1252 where they name none that is known),
/// and with the signs that stand as \U+00DC.
std::string decoded(std::string_view name, const DxfHeader& header);
/// A name in UTF-8 in small letters: names do not heed capitals.
std::string in_small_letters(const std::string& name);
/// The value of a group in an entity, empty without it.
std::string_view text_of(const DxfEntity& entity, int code);

/// The layers of a drawing.
class DxfLayers {
 public:
  DxfLayers(const DxfFile& file, const DxfHeader& header) : file_(file), header_(header) {}

  /// An entry of the table of layers.
  void take(const DxfEntity& entry);
  /// The layer that an entity is on, as its drawing writes it.
  std::string layer_of(const DxfEntity& entity) const;
  bool is_frozen(const std::string& layer) const;
  /// Whether its own things are not shown: frozen or switched off.
  bool is_hidden(const std::string& layer) const;

 private:
  struct Layer {
    bool frozen, off;
  };
  const DxfFile& file_;
  const DxfHeader& header_;
  std::map<std::string, Layer> layers_;  ///< by the name in small letters
};

}  // namespace parison::forming
