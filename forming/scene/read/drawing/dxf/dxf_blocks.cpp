// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/dxf/dxf_blocks.hpp"

#include <fmt/core.h>

#include <cmath>

#include "forming/scene/read/drawing/dxf/dxf_layers.hpp"

namespace parison::forming {
namespace {

using core::Point;

double value_of(const DxfFile& file, const DxfEntity& entity, int code, double otherwise) {
  for (const DxfGroup& group : entity.groups)
    if (group.code == code) return file.number(group);
  return otherwise;
}

}  // namespace

std::string DxfBlocks::name_of(const DxfEntity& entity) const {
  return in_small_letters(decoded(text_of(entity, 2), header_));
}

void DxfBlocks::take(const DxfEntity& entity) {
  constexpr std::size_t most_groups = 2'000'000;
  if (entity.kind == "BLOCK") {
    open_ = &blocks_[name_of(entity)];
    *open_ = {Point(value_of(file_, entity, 10, 0), value_of(file_, entity, 20, 0)), {}};
  } else if (entity.kind == "ENDBLK") {
    open_ = nullptr;
  } else if (open_) {
    groups_ += entity.groups.size();
    if (groups_ > most_groups)
      file_.refuse(entity.line,
                   fmt::format("blocks with more than {} values were found, allowed are so many", most_groups));
    open_->entities.push_back(entity);
  }
}

const DxfBlock& DxfBlocks::inserted(const DxfEntity& insert) const {
  const auto found = blocks_.find(name_of(insert));
  if (found == blocks_.end())
    file_.refuse(insert.line,
                 fmt::format("an INSERT of the block \"{}\" was found, allowed are blocks of the same file",
                             text_of(insert, 2)));
  return found->second;
}

Placement placement_of(const DxfFile& file, const DxfEntity& insert, const DxfBlock& block, double unit) {
  const auto value = [&](int code, double otherwise) { return value_of(file, insert, code, otherwise); };
  const double x = value(41, 1), y = value(42, 1);
  if (!(std::abs(x) > 1e-9) || std::abs(std::abs(x) - std::abs(y)) > 1e-9 * std::abs(x))
    file.refuse(insert.line,
                fmt::format("an INSERT with the scales {:g} and {:g} was found, allowed is one scale in both "
                            "directions (explode the block in the CAD program)",
                            x, y));
  if (value(70, 1) > 1 || value(71, 1) > 1)
    file.refuse(insert.line, "an INSERT of rows or columns of a block was found, allowed is a single one");
  // A reflection of y alone is one of x and half a turn.
  Placement placement{unit * block.base, unit * Point(value(10, 0), value(20, 0)),
                      value(50, 0) * M_PI / 180 + (y < 0 ? M_PI : 0), std::abs(x), x * y < 0};
  if (value(230, 1) < 0) {
    placement.place[0] = -placement.place[0];
    placement.turn = -placement.turn;
    placement.mirrored = !placement.mirrored;
  }
  return placement;
}

}  // namespace parison::forming
