#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of a DXF file and where they are inserted; private to the reading of drawings.
#include <map>
#include <string>
#include <vector>

#include "forming/scene/read/drawing/dxf/dxf_file.hpp"
#include "forming/scene/read/drawing/placement.hpp"

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

}  // namespace parison::forming
