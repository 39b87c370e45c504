#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of a DXF file and where they are inserted; private to the reading of drawings.
#include <map>
#include <string>
#include <vector>

#include "core/mesh/profile.hpp"
#include "forming/scene/read/drawing/dxf_file.hpp"

namespace parison::forming {

/// Entities that a drawing inserts as one, in their own frame.
struct DxfBlock {
  core::Point base;  ///< the point that comes to the place of the insertion, drawing units
  std::vector<DxfEntity> entities;
};

/// Gathers the blocks of a file from the entities of its section BLOCKS.
class DxfBlocks {
 public:
  explicit DxfBlocks(const DxfFile& file) : file_(file) {}
  void take(const DxfEntity& entity);
  /// The block that an INSERT names; refuses one that the file does not have.
  const DxfBlock& inserted(const DxfEntity& insert) const;

 private:
  const DxfFile& file_;
  std::map<std::string, DxfBlock, std::less<>> blocks_;
  DxfBlock* open_ = nullptr;
  std::size_t groups_ = 0;
};

/// A shift, a turn, one scale and perhaps a reflection.
struct DxfPlacement {
  core::Point base, place;  ///< m
  double turn, scale;       ///< rad, above zero
  bool mirrored;            ///< about the y axis, before the turn

  core::Segment operator()(const core::Segment& segment) const;
};

/// Where an INSERT puts its block; refuses arrays and scales that would bend circles.
DxfPlacement placement_of(const DxfFile& file, const DxfEntity& insert, const DxfBlock& block, double unit);

}  // namespace parison::forming
