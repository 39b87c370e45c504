// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/step/measured_sections.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "contact/solid/section_surface.hpp"
#include "core/solid/section_table.hpp"
#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using core::Point;
using core::Vector3;

constexpr int rows = 180;                 // even steps of a quarter turn: 0.5 mm on a mould of 60 mm radius
constexpr double step = M_PI_2 / rows;    // rad
constexpr double stretch = 5e-4;          // m along the outline
constexpr double symmetric = 5e-5;        // m: what moulds are worked to
constexpr double least_apart = 2e-5;      // m, of two heights
constexpr double longest_missing = 2e-3;  // m
constexpr double bearable = 1e-3;         // m, from the sections to the solid

/// Where a ray from the axis first comes into the solid, and first out of it, m; infinite where it does not.
struct Crossing {
  double in = HUGE_VAL, out = HUGE_VAL;
};

/// The crossings of a whole turn of rays at a height, the first `shift` steps from the half plane.
class Turn {
 public:
  Turn(const std::vector<Triangle>& solid, double height, double shift) : shift_(shift), rays_(4 * rows) {
    for (const Triangle& triangle : solid) add(triangle, height);
  }
  /// The rays that symmetry makes the same as one of the first quarter, that one first.
  std::array<Crossing, 4> alike(int row) const {
    const int odd = shift_ > 0 ? 1 : 0;
    const auto at = [&](int ray) { return rays_[static_cast<std::size_t>(ray % (4 * rows))]; };
    return {at(row), at(4 * rows - odd - row), at(2 * rows - odd - row), at(2 * rows + row)};
  }
  /// The first of these that comes into the solid.
  Crossing first(int row) const {
    for (const Crossing& crossing : alike(row))
      if (std::isfinite(crossing.in)) return crossing;
    return {};
  }

 private:
  void add(const Triangle& triangle, double height) {
    Point ends[2];
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 &a = triangle[i], &b = triangle[(i + 1) % 3];
      if ((a[2] <= height) == (b[2] <= height)) continue;
      ends[count++] = (a + (height - a[2]) / (b[2] - a[2]) * (b - a)).head<2>();
    }
    if (count < 2) return;
    const Vector3 outward = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    cross(ends[0], ends[1], outward.head<2>());
  }

  void cross(const Point& a, const Point& b, const Point& outward) {
    const double from = std::atan2(a[1], a[0]), turn = std::remainder(std::atan2(b[1], b[0]) - from, 2 * M_PI);
    constexpr double rounding = 1e-6;  // of a step
    constexpr double on_axis = 1e-6;   // m: where the halves of a mould meet
    const auto first = std::ceil(std::min(from, from + turn) / step - shift_ - rounding);
    const auto last = std::floor(std::max(from, from + turn) / step - shift_ + rounding);
    for (double ray = first; ray <= last; ++ray) {
      const double angle = (ray + shift_) * step;
      const Point along(std::cos(angle), std::sin(angle));
      const double across = along[0] * (b - a)[1] - along[1] * (b - a)[0];
      if (std::abs(across) <= rounding * (b - a).norm()) continue;
      const double far = (a[0] * b[1] - a[1] * b[0]) / across;
      Crossing& crossing = rays_[static_cast<std::size_t>(ray + 8 * rows) % rays_.size()];
      double& nearest = outward.dot(along) < 0 ? crossing.in : crossing.out;
      if (far > on_axis) nearest = std::min(nearest, far);
    }
  }

  double shift_;
  std::vector<Crossing> rays_;
};

/// Heights along the contact boundaries of a tool, ascending.
std::vector<double> heights_of(const Tool& tool) {
  const auto contact = contact_boundaries(tool);
  std::vector<double> all, heights;
  for (const core::Segment& segment : tool.profile.segments) {
    if (!contact[segment.boundary_id]) continue;
    constexpr int least = 4;
    const int count = std::max(least, static_cast<int>(std::ceil(core::length(segment) / stretch)));
    for (int i = 0; i <= count; ++i) all.push_back(core::point_at(segment, double(i) / count)[1]);
  }
  std::sort(all.begin(), all.end());
  constexpr double inside = 1e-6;  // m, of the ends, where the solid has a face across the axis
  all.front() += inside;
  all.back() -= inside;
  for (const double height : all)
    if (heights.empty() || height > heights.back() + least_apart) heights.push_back(height);
  return heights;
}

std::string place_text(double height, double row) {
  return fmt::format("z = {:.1f} mm, {:.1f} deg from the half plane", 1e3 * height, row * step * 180 / M_PI);
}

/// Refuses a turn whose rays differ where two planes of symmetry make them the same.
void check_symmetry(const CaseNode& file, const Turn& turn, double height) {
  for (int row = 0; row <= rows; ++row) {
    const double first = turn.first(row).in;
    for (const Crossing& other : turn.alike(row))
      if (std::isfinite(other.in) && std::abs(other.in - first) > symmetric)
        core::refuse(file, fmt::format("a cavity {:.2f} and {:.2f} mm from the axis was found at {} and where it is "
                                       "mirrored, allowed are cavities with two planes of symmetry (turn names the "
                                       "first)",
                                       1e3 * first, 1e3 * other.in, place_text(height, row)));
  }
}

/// The borders of a cavity around it and around what stands up in its base, a row for each angle and a column for each
/// height at which its wall is all around; those of the base are infinite where nothing does.
struct Borders {
  std::vector<double> heights;
  Eigen::MatrixXd outer, inner;
};
Borders borders_of(const CaseNode& file, const std::vector<Triangle>& solid, const std::vector<double>& heights) {
  const auto count = static_cast<Eigen::Index>(heights.size());
  Borders borders{{}, Eigen::MatrixXd(rows + 1, count), Eigen::MatrixXd(rows + 1, count)};
  for (const double height : heights) {
    const auto column = static_cast<Eigen::Index>(borders.heights.size());
    const Turn turn(solid, height, 0);
    check_symmetry(file, turn, height);
    for (int row = 0; row <= rows; ++row) {
      const Crossing crossing = turn.first(row);
      borders.outer(row, column) = crossing.in;
      borders.inner(row, column) = crossing.out < crossing.in ? crossing.out : HUGE_VAL;
    }
    const double last = borders.heights.empty() ? heights.front() : borders.heights.back();
    if (borders.outer.col(column).allFinite()) {
      borders.heights.push_back(height);
    } else if (height - last > longest_missing) {
      Eigen::Index row = 0;
      borders.outer.col(column).maxCoeff(&row);
      core::refuse(file, fmt::format("no wall of the cavity was found at {}, allowed is one all around at the heights "
                                     "of the contact boundaries",
                                     place_text(height, static_cast<double>(row))));
    }
  }
  if (borders.heights.size() < 2)
    core::refuse(file, "no cavity was found at the heights of the contact boundaries, allowed is one");
  return borders;
}

/// The base of a cavity: the heights from one of its ends at which something stands up in it all around.
std::optional<core::ReachTable> base_of(const Borders& borders) {
  const auto is_inside = [&](Eigen::Index column) { return borders.inner.col(column).allFinite(); };
  const auto count = static_cast<Eigen::Index>(borders.heights.size());
  Eigen::Index first = 0, last = count;
  if (is_inside(count - 1))
    for (first = count; first > 0 && is_inside(first - 1);) --first;
  else
    for (last = 0; last < count && is_inside(last);) ++last;
  if (last - first < 2) return {};
  return core::ReachTable({borders.heights.begin() + first, borders.heights.begin() + last},
                          borders.inner.middleCols(first, last - first));
}

/// How far the surface that sections make is from the solid between their entries.
struct Off {
  double distance = 0, height = 0, row = 0;
};
Off farthest(const std::vector<Triangle>& solid, const std::vector<double>& heights, const Tool& tool,
             const core::SectionFamily& family) {
  const contact::SectionSurface surface(tool.profile, contact_boundaries(tool), family);
  constexpr double shift = 0.5;  // steps
  Off worst;
  for (std::size_t i = 1; i < heights.size(); i += 2) {
    const double height = (heights[i - 1] + heights[i]) / 2;
    const Turn turn(solid, height, shift);
    constexpr int stride = 6;
    for (int row = 0; row < rows; row += stride) {
      const Crossing crossing = turn.first(row);
      const double angle = (row + shift) * step;
      for (const double far : {crossing.in, std::min(crossing.in, crossing.out)}) {  // and of a base that is pushed up
        if (!std::isfinite(far)) continue;
        const double off = surface.gap({far * std::cos(angle), far * std::sin(angle), height}).distance;
        if (std::abs(off) > std::abs(worst.distance)) worst = {off, height, row + shift};
      }
    }
  }
  return worst;
}

}  // namespace

core::SectionFamily measured_sections(const CaseTable& table, const std::string& directory, Tool& tool) {
  const CaseNode &file = table.get("file"), *origin = table.find("origin");
  std::vector<Triangle> solid =
      read_step_triangles(table, (std::filesystem::path(directory) / core::text(file)).string());
  const double base = origin ? read_point(*origin)[1] : 0;
  for (Triangle& triangle : solid)
    for (Vector3& corner : triangle) corner[2] -= base;
  const Borders borders = borders_of(file, solid, heights_of(tool));
  const auto& heights = borders.heights;
  const auto columns = static_cast<Eigen::Index>(heights.size());
  core::SectionFamily family;
  family.measured = std::make_shared<core::MeasuredSections>(
      core::MeasuredSections{core::ReachTable(heights, borders.outer.leftCols(columns)), base_of(borders)});
  const Off off = farthest(solid, heights, tool, family);
  const std::string where =
      fmt::format("{:.3f} mm, furthest at {}", 1e3 * std::abs(off.distance), place_text(off.height, off.row));
  if (std::abs(off.distance) > bearable)
    core::refuse(file, fmt::format("the solid is away from its outline with its sections by {}, allowed is {:g} mm (an "
                                   "outline as the half plane cuts it, all of it in sight of the axis)",
                                   where, 1e3 * bearable));
  tool.drawing_notes.push_back(
      fmt::format("sections of \"{}\" were measured at {} heights; the cavity is that of the "
                  "solid within {}",
                  file.text, heights.size(), where));
  return family;
}

}  // namespace parison::forming
