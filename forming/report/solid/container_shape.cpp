// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/container_shape.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/case/number.hpp"
#include "core/io/csv.hpp"
#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "core/math/numbers.hpp"

namespace parison::forming {
namespace {

using core::Point;

/// Such columns of a table that Parison has written.
class Columns {
 public:
  Columns(const std::string& path, const std::vector<std::string>& names) {
    if (!std::filesystem::exists(path))
      throw core::CaseError(
          fmt::format("{}: no such file, allowed is the result folder of a run that has ended", path));
    table_ = core::read_csv(path);
    for (const std::string& name : names) {
      place_.push_back(table_.find(name));
      if (place_.back() < 0) throw core::CaseError(fmt::format("{}: has no column \"{}\"", path, name));
    }
  }

  std::size_t size() const { return table_.rows.size(); }
  const std::string& text(std::size_t row, std::size_t column) const {
    return table_.rows[row].cells[static_cast<std::size_t>(place_[column])];
  }
  double number(std::size_t row, std::size_t column) const {
    const auto value = core::parse_number<double>(text(row, column));
    if (!value)
      throw core::CaseError(fmt::format("{}:{}: \"{}\" was found, allowed is a number", table_.path,
                                        table_.rows[row].line, text(row, column)));
    return *value;
  }

 private:
  core::CsvTable table_;
  std::vector<int> place_;
};

constexpr double on_axis = 1e-7;  ///< m

std::vector<Point> read_outline(const std::string& path) {
  const Columns rows(path, {"loop", "r_mm", "z_mm"});
  std::vector<Point> points;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows.text(i, 0) != "0")
      throw core::CaseError(fmt::format("{}: the glass has several surfaces (a bubble), allowed is one surface", path));
    points.push_back(core::millimetre * Point(rows.number(i, 1), rows.number(i, 2)));
    if (points.back()[0] < on_axis) points.back()[0] = 0;
    if (points.size() > 1 && (points.back() - points[points.size() - 2]).norm() < on_axis) points.pop_back();
  }
  if (points.size() < 4)
    throw core::CaseError(fmt::format("{}: {} points were found, allowed is a surface", path, points.size()));
  return points;
}

/// Adds a point to the middle; points before it that it goes back behind, by less than the wall is thick, are noise of
/// the places on the inner side, and go.
void add_point(const MidPoint& point, std::vector<MidPoint>& middle) {
  while (middle.size() > 1) {
    const Point step = point.position - middle.back().position;
    if (step.norm() > point.thickness || step.dot(middle.back().position - middle[middle.size() - 2].position) > 0)
      break;
    middle.pop_back();
  }
  middle.push_back(point);
}

/// Where two stretches of wall are joined, the middle goes straight from one to the other.
std::vector<MidPoint> read_middle(const std::string& path, double& bridged) {
  const Columns rows(path, {"mark", "r_outer_mm", "z_outer_mm", "r_inner_mm", "z_inner_mm", "thickness_mm"});
  std::vector<MidPoint> middle;
  double length = 0, joined = 0;
  bool was_wall = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_wall = rows.text(i, 0) == "wall";
    if (is_wall) {
      const Point outer = core::millimetre * Point(rows.number(i, 1), rows.number(i, 2)),
                  inner = core::millimetre * Point(rows.number(i, 3), rows.number(i, 4));
      MidPoint point{0.5 * (outer + inner), core::millimetre * rows.number(i, 5), outer[1]};
      if (point.position[0] < on_axis) point.position[0] = 0;
      const double step = middle.empty() ? 0 : (point.position - middle.back().position).norm();
      length += step;
      if (!was_wall) joined += step;
      add_point(point, middle);
    }
    was_wall = is_wall;
  }
  bridged = length > 0 ? joined / length : 0;
  return middle;
}

/// Refuses the results of a planar case, which is a metre deep.
void require_revolution(const std::string& directory) {
  const std::string path = directory + "/summary.json";
  if (!std::filesystem::exists(path)) return;
  if (core::read_json(core::read_text(path), path).text_of("geometry") == "planar")
    throw core::CaseError(fmt::format(
        "{}: a planar case was found, whose glass is no solid of revolution, allowed are axisymmetric cases",
        directory));
}

}  // namespace

ContainerShape read_container_shape(const std::string& directory) {
  require_revolution(directory);
  ContainerShape shape;
  const std::string path = directory + "/contour.csv";
  shape.outline = read_outline(path);
  const double first = shape.outline.front()[0], last = shape.outline.back()[0];
  shape.is_loop = first > 0 && last > 0;
  if (!shape.is_loop && (first > 0 || last > 0))
    throw core::CaseError(
        fmt::format("{}: a surface that begins or ends off the axis was found, allowed are round containers", path));
  shape.middle = read_middle(directory + "/thickness.csv", shape.bridged);
  return shape;
}

double revolved_volume(const ContainerShape& shape) {
  double volume = 0;
  const auto& points = shape.outline;
  for (std::size_t i = 0; i + (shape.is_loop ? 0 : 1) < points.size(); ++i) {
    const Point &a = points[i], &b = points[(i + 1) % points.size()];
    volume += M_PI / 3 * (b[1] - a[1]) * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]);
  }
  return volume;
}

}  // namespace parison::forming
