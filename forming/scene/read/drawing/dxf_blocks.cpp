// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/dxf_blocks.hpp"

#include <fmt/core.h>

#include <cmath>

namespace parison::forming {
namespace {

using core::Point;

double value_of(const DxfFile& file, const DxfEntity& entity, int code, double otherwise) {
  for (const DxfGroup& group : entity.groups)
    if (group.code == code) return file.number(group);
  return otherwise;
}

std::string name_of(const DxfEntity& entity) {
  for (const DxfGroup& group : entity.groups)
    if (group.code == 2) return std::string(group.value);
  return "";
}

}  // namespace

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
    file_.refuse(
        insert.line,
        fmt::format("an INSERT of the block \"{}\" was found, allowed are blocks of the same file", name_of(insert)));
  return found->second;
}

core::Segment DxfPlacement::operator()(const core::Segment& segment) const {
  const auto turned = [&](const Point& x) {
    const Point own(mirrored ? -x[0] : x[0], x[1]);
    return Point(std::cos(turn) * own[0] - std::sin(turn) * own[1], std::sin(turn) * own[0] + std::cos(turn) * own[1]);
  };
  const auto placed = [&](const Point& x) -> Point { return place + scale * turned(x - base); };
  core::Segment result = segment;
  result.start = placed(segment.start);
  result.end = placed(segment.end);
  if (!segment.is_arc) return result;
  result.centre = placed(segment.centre);
  result.radius = scale * segment.radius;
  const Point first = turned({std::cos(segment.from), std::sin(segment.from)});
  result.from = std::atan2(first[1], first[0]);
  result.to = result.from + (mirrored ? -1 : 1) * (segment.to - segment.from);
  return result;
}

DxfPlacement placement_of(const DxfFile& file, const DxfEntity& insert, const DxfBlock& block, double unit) {
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
  const double turn = value(50, 0) * M_PI / 180 + (y < 0 ? M_PI : 0);
  return {unit * block.base, unit * Point(value(10, 0), value(20, 0)), turn, std::abs(x), x * y < 0};
}

}  // namespace parison::forming
