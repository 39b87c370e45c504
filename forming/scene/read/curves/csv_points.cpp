// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/curves/csv_points.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "core/case/given_file.hpp"
#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/read_section.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::Point;
using core::Segment;
namespace dimension = core::dimension;

struct Column {
  std::size_t coordinate;  ///< 0 for r or x, 1 for z or y
  std::string unit;
};

/// What each column has, by its heading: r_mm, or r_outer_mm, in small letters or capitals.
std::vector<Column> columns_of(const CaseNode& row, std::string_view line,
                               const std::vector<std::string_view>& headings) {
  std::vector<Column> columns;
  for (const auto cell : headings) {
    const std::string heading = core::in_small_ascii(core::trimmed(cell)), name = heading.substr(0, heading.find('_'));
    const auto coordinate = name == "r" || name == "x" ? 0U : name == "z" || name == "y" ? 1U : 2U;
    if (name.size() == heading.size() || coordinate >= core::dim)
      core::refuse(
          row, fmt::format("the heading is missing (\"{}\" was found), allowed is a heading such as r_mm,z_mm", line));
    columns.push_back({coordinate, heading.substr(heading.find_last_of('_') + 1)});
  }
  if (columns[0].coordinate == columns[1].coordinate)
    core::refuse(row, fmt::format("the heading \"{}\" names one coordinate twice, allowed is a heading such as "
                                  "r_mm,z_mm",
                                  line));
  return columns;
}

}  // namespace

std::vector<Segment> read_csv_points(const CaseNode& node, const std::string& directory) {
  const auto path = std::filesystem::path(directory) / core::text(node);
  const std::string content =
      core::read_given_file(node, path.string(), "a CSV file with its path relative to the case file");
  CaseNode row = node;
  row.file = path.string();
  std::vector<Column> columns;
  std::vector<Segment> parts;
  core::Lines lines(content);
  for (std::string_view line; lines.next(line);) {
    row.line = lines.number();
    if (core::trimmed(line).empty()) continue;
    auto cells = core::split(line);
    if (cells.size() == core::dim + 1 && core::trimmed(cells.back()).empty()) cells.pop_back();
    if (cells.size() != core::dim)
      core::refuse(row, fmt::format("\"{}\" has {} columns, allowed are {}", line, cells.size(), core::dim));
    if (columns.empty()) {
      columns = columns_of(row, line, cells);
      continue;
    }
    if (parts.size() == max_segments) core::refuse(row, fmt::format("allowed are up to {} points", max_segments));
    parts.emplace_back();
    for (std::size_t i = 0; i < core::dim; ++i)
      parts.back().end[columns[i].coordinate] =
          core::text_quantity(row, fmt::format("{} {}", cells[i], columns[i].unit), dimension::length);
  }
  if (parts.empty())
    core::refuse(node, fmt::format("no points were found in \"{}\", allowed is a heading such as r_mm,z_mm and rows "
                                   "of numbers",
                                   path.string()));
  return parts;
}

std::vector<Segment> smoothed(const CaseNode& node, const std::vector<Segment>& points) {
  std::vector<Point> places;
  for (const Segment& point : points)
    if (places.empty() || point.end != places.back()) places.push_back(point.end);
  if (places.size() < 3)
    core::refuse(node, fmt::format("{} different points were found, allowed are at least 3", places.size()));
  double size = 0;
  for (const Point& x : places) size = std::max(size, (x - places.front()).norm());
  std::vector<Segment> parts(1);
  parts.front().start = parts.front().end = places.front();
  for (const Segment& arc : smooth_through(places, curve_tolerance(size))) parts.push_back(arc);
  return parts;
}

}  // namespace parison::forming
