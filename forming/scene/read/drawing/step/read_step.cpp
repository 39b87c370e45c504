// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include "core/case/given_file.hpp"
#include "core/io/files.hpp"
#include "core/process/child_work.hpp"
#include "core/process/gmsh_module.hpp"
#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/drawing/step/measured_sections.hpp"
#include "forming/scene/read/drawing/step/step_curves.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using core::Point;
using core::Segment;

/// A curve as the CAD kernel has it, m.
struct StepCurve {
  enum class Kind { line, arc, spline } kind;
  std::vector<Space> places;  ///< ends of a line; start, middle and end of an arc; control points of a spline
  std::vector<double> weights, knots;
  std::size_t degree = 0;
};

/// The numbers of a line behind its first word; nothing where one is none or not finite.
std::optional<std::vector<double>> numbers_of(std::string_view line) {
  std::vector<double> numbers;
  line.remove_prefix(std::min(line.find(' '), line.size()));
  while (!line.empty()) {
    double number = 0;
    const auto read = std::from_chars(line.data() + 1, line.data() + line.size(), number);
    if (read.ec != std::errc{} || !std::isfinite(number)) return {};
    numbers.push_back(number);
    line.remove_prefix(static_cast<std::size_t>(read.ptr - line.data()));
  }
  return numbers;
}

/// "spline", its degree, the number of control points, these with their weights, the knots.
std::optional<StepCurve> parse_spline(const std::vector<double>& numbers) {
  StepCurve curve{StepCurve::Kind::spline, {}, {}, {}, 0};
  if (numbers.size() < 2) return {};
  curve.degree = static_cast<std::size_t>(numbers[0]);
  const auto count = static_cast<std::size_t>(numbers[1]);
  if (numbers.size() != 2 + 4 * count + count + curve.degree + 1 || count <= curve.degree) return {};
  for (std::size_t i = 0; i < count; ++i) {
    const double* own = &numbers[2 + 4 * i];
    curve.places.push_back({own[0], own[1], own[2]});
    curve.weights.push_back(own[3]);
  }
  curve.knots.assign(numbers.begin() + static_cast<std::ptrdiff_t>(2 + 4 * count), numbers.end());
  return curve;
}

/// A line of what the CAD kernel finds; nothing where a number is missing or not finite.
std::optional<StepCurve> parse_curve(std::string_view line) {
  const auto numbers = numbers_of(line);
  if (!numbers) return {};
  if (line.rfind("spline", 0) == 0) return parse_spline(*numbers);
  const bool is_arc = line.rfind("arc", 0) == 0;
  if (numbers->size() != (is_arc ? 9 : 6)) return {};
  StepCurve curve{is_arc ? StepCurve::Kind::arc : StepCurve::Kind::line, {}, {}, {}, 0};
  for (std::size_t i = 0; i < numbers->size(); i += 3)
    curve.places.push_back({(*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]});
  return curve;
}

/// What a function of the CAD kernel's module finds in a file, which it crashes on where that is damaged: so it works
/// in a process of its own.
std::string text_of_kernel(const CaseNode& file, const std::string& path, const StepCut& cut, const char* function) {
  auto& find = core::gmsh_function<decltype(parison_find_curves)>(function);
  core::ChildWork work;
  const auto text_of_file = [&] {
    std::string text;
    find(path, cut, text);
    return text;
  };
  core::in_gmsh_session([&] { work = core::in_child(text_of_file); });
  if (!work.death.empty())
    core::refuse(file, fmt::format("\"{}\" cannot be read by the CAD kernel ({}), allowed is a whole STEP file with a "
                                   "section",
                                   path, work.death));
  const std::string_view refusal = "refuse ";
  if (work.text.rfind(refusal, 0) == 0) core::refuse(file, work.text.substr(refusal.size()));
  return std::move(work.text);
}

[[noreturn]] void refuse_places(const CaseNode& file, const std::string& path) {
  core::refuse(file,
               fmt::format("\"{}\" contains a curve whose place is no number, allowed are finite coordinates", path));
}

std::vector<StepCurve> parse_curves(const CaseNode& file, const std::string& path, const std::string& text,
                                    bool& is_cut, std::vector<std::string>& notes) {
  const std::string_view note = "note ";
  std::vector<StepCurve> curves;
  core::Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    if (line.rfind(note, 0) == 0) {
      is_cut = true;
      notes.emplace_back(file.text + ": " + std::string(line.substr(note.size())));
      continue;
    }
    auto curve = parse_curve(line);
    if (!curve) refuse_places(file, path);
    curves.push_back(std::move(*curve));
  }
  return curves;
}

/// The two axes of the coordinate plane, or of one parallel to it, that contains all curves: (x, y), (x, z) or (y, z).
std::array<std::size_t, 2> find_plane(const CaseNode& file, const std::string& path,
                                      const std::vector<StepCurve>& curves) {
  Space low = curves.front().places.front(), high = low;
  for (const StepCurve& curve : curves)
    for (const Space& x : curve.places)
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
  const Space extent{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  const double in_plane = tolerance::joined * std::hypot(extent[0], extent[1], extent[2]);
  if (extent[2] < in_plane) return {0, 1};
  if (extent[1] < in_plane) return {0, 2};
  if (extent[0] < in_plane) return {1, 2};
  core::refuse(
      file,
      fmt::format("the curves of \"{}\" lie in no coordinate plane, allowed are x and y, x and z, or y and z", path));
}

Segment arc_through(const Point& start, const Point& mid, const Point& end) {
  const Point a = mid - start, b = end - start;
  const double turn = a[0] * b[1] - a[1] * b[0];  // positive counterclockwise
  Segment arc;
  arc.is_arc = true;
  arc.start = start;
  arc.end = end;
  arc.centre =
      start + Point(b[1] * a.squaredNorm() - a[1] * b.squaredNorm(), a[0] * b.squaredNorm() - b[0] * a.squaredNorm()) /
                  (2 * turn);
  arc.radius = (start - arc.centre).norm();
  arc.from = std::atan2(start[1] - arc.centre[1], start[0] - arc.centre[0]);
  arc.to = std::atan2(end[1] - arc.centre[1], end[0] - arc.centre[0]);
  if (turn > 0 && arc.to <= arc.from) arc.to += 2 * M_PI;
  if (turn < 0 && arc.to >= arc.from) arc.to -= 2 * M_PI;
  return arc;
}

using Flat = std::array<std::size_t, 2>;  ///< which coordinates are x and y of the section

Point flat(const Space& x, const Flat& plane) {
  return {x[plane[0]], x[plane[1]]};
}

void add_curve(const StepCurve& curve, const Flat& plane, double tolerance, std::vector<Segment>& segments) {
  const auto& places = curve.places;
  if (curve.kind == StepCurve::Kind::arc)
    return segments.push_back(arc_through(flat(places[0], plane), flat(places[1], plane), flat(places[2], plane)));
  if (curve.kind == StepCurve::Kind::line) {
    segments.emplace_back();
    segments.back().start = flat(places[0], plane);
    segments.back().end = flat(places[1], plane);
    return;
  }
  Spline spline{curve.degree, curve.knots, {}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point x = curve.weights[i] * flat(places[i], plane);
    spline.points.emplace_back(x[0], x[1], curve.weights[i]);
  }
  const auto arcs = arcs_of_spline(spline, tolerance);
  segments.insert(segments.end(), arcs.begin(), arcs.end());
}

/// The text of a STEP file, which is refused where it is none or is cut.
std::string whole_file(const CaseNode& file, const std::string& path) {
  std::string content = core::read_given_file(file, path, "a drawing with its path relative to the case file");
  if (content.rfind("ISO-10303-21", 0) != 0)
    core::refuse(
        file,
        fmt::format("\"{}\" is no STEP file (its first line does not say ISO-10303-21), allowed is one with a section",
                    path));
  if (content.find("END-ISO-10303-21") == content.npos)
    core::refuse(file,
                 fmt::format("\"{}\" ends without END-ISO-10303-21, so a part of it is missing, allowed is a whole "
                             "STEP file",
                             path));
  return content;
}

/// What the CAD kernel has found in the files that were read last: it takes a second, and the workbench reads a case
/// again at each change.
class FoundTexts {
 public:
  /// What was found by a question, or what `find` finds.
  template <typename Find>
  std::string found(const std::string& question, const Find& find) {
    const std::lock_guard<std::mutex> lock(access_);
    const auto is_same = [&](const auto& one) { return one.first == question; };
    if (const auto known = std::find_if(texts_.begin(), texts_.end(), is_same); known != texts_.end())
      return known->second;
    texts_.emplace_back(question, find());
    if (texts_.size() > most) texts_.pop_front();
    return texts_.back().second;
  }

 private:
  static constexpr std::size_t most = 8;  // contours and sections of the tools of a case
  std::mutex access_;
  std::deque<std::pair<std::string, std::string>> texts_;
};

/// What the CAD kernel finds in the file of a table { file, axis, turn }.
std::string kernel_text(const CaseTable& table, const std::string& path, const char* function) {
  static FoundTexts texts;
  const CaseNode &file = table.get("file"), *axis = table.find("axis"), *turn = table.find("turn");
  const std::string content = whole_file(file, path);
  const StepCut cut{axis ? core::text(*axis) : "", turn ? core::quantity(*turn, core::dimension::none) : 0};
  const std::string question =
      fmt::format("{} {} {} {} {}", function, cut.axis, cut.turn, content.size(), core::fingerprint(content));
  return texts.found(question, [&] {
    std::string text = text_of_kernel(file, path, cut, function);
    if (core::read_given_file(file, path, "a drawing") != content)  // the kernel has read it once more
      core::refuse(file,
                   fmt::format("\"{}\" has changed while it was read, allowed is a file that stays as it is", path));
    return text;
  });
}

}  // namespace

std::vector<Segment> read_step(const CaseTable& table, const std::string& path, bool& is_cut,
                               std::vector<std::string>& notes) {
  const CaseNode& file = table.get("file");
  const auto curves = parse_curves(file, path, kernel_text(table, path, "parison_find_curves"), is_cut, notes);
  const Flat plane = find_plane(file, path, curves);
  double size = 0;
  for (const StepCurve& curve : curves)
    for (const Space& x : curve.places)
      size = std::max(size, (flat(x, plane) - flat(curves.front().places.front(), plane)).norm());
  std::vector<Segment> segments;
  for (const StepCurve& curve : curves) add_curve(curve, plane, curve_tolerance(size), segments);
  if (segments.size() > max_segments)
    core::refuse(
        file, fmt::format("\"{}\" gives {} lines and arcs, allowed are up to {}", path, segments.size(), max_segments));
  return segments;
}

std::vector<Triangle> read_step_triangles(const CaseTable& table, const std::string& path) {
  const std::string text = kernel_text(table, path, "parison_find_triangles");
  std::vector<Triangle> triangles;
  core::Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    const auto numbers = numbers_of(line);
    if (!numbers || numbers->size() != 9) refuse_places(table.get("file"), path);
    Triangle& triangle = triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = core::Vector3(&(*numbers)[3 * i]);
  }
  return triangles;
}

}  // namespace parison::forming
