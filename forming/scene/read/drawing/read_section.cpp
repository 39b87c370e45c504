// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/read_section.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using core::Point;
using core::Segment;
using Chain = std::vector<Segment>;

/// Whether two ends in a drawing of this size meet.
bool meet(const Point& a, const Point& b, double size) {
  return (a - b).norm() <= tolerance::joined * size;
}

Chain turned(const Chain& chain) {
  return core::reversed({chain, {}}).segments;
}

std::string in_mm(const Point& x) {
  return fmt::format("({:.6g}, {:.6g}) mm", 1e3 * x[0], 1e3 * x[1]);
}

bool is_closed(const Chain& chain, double size) {
  return chain.size() > 1 && meet(chain.front().start, chain.back().end, size);
}

/// Moves the curves that follow the chain's end, one after the other, from `left` to it.
void extend(const CaseNode& file, Chain& chain, Chain& left, double size) {
  while (!is_closed(chain, size)) {
    const Point end = chain.back().end;
    const auto follows = [&](const Segment& s) { return meet(s.start, end, size) || meet(s.end, end, size); };
    const auto next = std::find_if(left.begin(), left.end(), follows);
    if (next == left.end()) return;
    if (std::count_if(left.begin(), left.end(), follows) > 1)
      core::refuse(
          file, fmt::format("more than two curves of the drawing meet at {}, allowed is one outline without branches",
                            in_mm(end)));
    chain.push_back(meet(next->start, end, size) ? *next : turned({*next})[0]);
    left.erase(next);
  }
}

/// Says why curves are left over: a gap where an end of theirs is near one of the chain, else several outlines.
[[noreturn]] void refuse_rest(const CaseNode& file, const Chain& chain, const Chain& left, double size) {
  double nearest = std::numeric_limits<double>::infinity();
  Point where = Point::Zero();
  if (!is_closed(chain, size))
    for (const Segment& segment : left)
      for (const Point& x : {segment.start, segment.end})
        for (const Point& end : {chain.front().start, chain.back().end})
          if ((x - end).norm() < nearest) nearest = (x - end).norm(), where = end;
  if (nearest < tolerance::drawing_gap * size)
    core::refuse(
        file,
        fmt::format("the curves of the drawing leave a gap of {:.3g} mm at {}, allowed are ends that meet to {:.1g} mm",
                    1e3 * nearest, in_mm(where), 1e3 * tolerance::joined * size));
  core::refuse(
      file, fmt::format("several outlines were found in the drawing, one with {} curves and {} more curves, allowed is "
                        "one (in a DXF file a layer can select it)",
                        chain.size(), left.size()));
}

/// A position on a chain: the index of the segment plus the parameter on it, 0 to 1.
double place_on(const CaseNode& node, const Chain& chain, const Point& x) {
  const double on_drawing = tolerance::on_drawing * size_of(chain);
  double best = std::numeric_limits<double>::infinity(), place = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    double t = core::closest_parameter(chain[i], x);
    for (const double end : {0.0, 1.0})
      if (core::length(chain[i]) * std::abs(t - end) < on_drawing) t = end;
    const double distance = (core::point_at(chain[i], t) - x).norm();
    if (distance < best) best = distance, place = static_cast<double>(i) + t;
  }
  if (best > 2 * on_drawing)
    core::refuse(node,
                 fmt::format("{} is {:.3g} mm away from the drawing, allowed are points on it", in_mm(x), 1e3 * best));
  return place;
}

/// The part of a segment between two parameters, 0 to 1.
Segment part_of(const Segment& segment, double from, double to) {
  Segment part = segment;
  if (from > 0) part.start = core::point_at(segment, from);
  if (to < 1) part.end = core::point_at(segment, to);
  part.from = segment.from + from * (segment.to - segment.from);
  part.to = to < 1 ? segment.from + to * (segment.to - segment.from) : segment.to;
  return part;
}

/// The segments from one position to a later one, around a closed chain if need be.
Chain interval(const Chain& chain, double from, double to) {
  Chain result;
  for (double at = from; at < to;) {
    const double whole = std::floor(at), next = std::min(whole + 1, to);
    result.push_back(part_of(chain[static_cast<std::size_t>(whole) % chain.size()], at - whole, next - whole));
    at = next;
  }
  return result;
}

/// Coordinates that vanish but for round-off are made zero, so that curves meet axes exactly.
void clean(Chain& chain) {
  const double zero = tolerance::drawing_round_off * size_of(chain);
  for (Segment& segment : chain)
    for (Point* x : {&segment.start, &segment.end, &segment.centre})
      for (double& component : *x)
        if (std::abs(component) < zero) component = 0;
}

/// Drops what has no length, such as the side between two equal vertices of a polyline.
Chain with_length(Chain curves) {
  const double least = tolerance::joined * size_of(curves);
  const auto is_point = [&](const Segment& segment) { return core::length(segment) <= least; };
  curves.erase(std::remove_if(curves.begin(), curves.end(), is_point), curves.end());
  return curves;
}

/// Refuses curves far from any container and arcs so flat that round-off bends them.
void check_curves(const CaseNode& file, const Chain& curves) {
  constexpr double farthest = 1e6, largest_radius = 1e7;  // m; of the drawing's size
  const double size = size_of(curves);
  for (const Segment& curve : curves) {
    const double reach = std::max({curve.start.norm(), curve.end.norm(), curve.centre.norm() / largest_radius});
    if (!(reach <= farthest))
      core::refuse(
          file, fmt::format("a curve of the drawing reaches {:.3g} m, allowed are up to {:g} m from the origin", reach,
                            farthest));
    if (curve.is_arc && !(curve.radius <= largest_radius * size))
      core::refuse(file,
                   fmt::format("an arc with a radius of {:.3g} m was found, allowed are up to {:g} times the size "
                               "of the drawing (draw a straight line)",
                               curve.radius, largest_radius));
  }
}

Chain read_drawing(const CaseTable& table, const std::string& directory) {
  const CaseNode& file = table.get("file");
  const auto path = std::filesystem::path(directory) / core::text(file);
  std::string kind = path.extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(), [](unsigned char c) { return std::tolower(c); });
  const bool is_step = kind == ".step" || kind == ".stp";
  if (!is_step && kind != ".dxf")
    core::refuse(file, fmt::format("\"{}\" was found, allowed are drawings named .step, .stp or .dxf", file.text));
  if (is_step) {
    for (const char* key : {"unit", "layer"})
      if (const auto* node = table.find(key))
        core::refuse(
            *node,
            fmt::format("a {} was found, allowed only for DXF files; a STEP file has its own unit and no layers", key));
    Chain curves = read_step(file, path.string());
    check_curves(file, curves);
    return curves;
  }
  const auto unit = core::parse_quantity("1 " + core::text(table.get("unit")), core::dimension::length);
  if (!unit.problem.empty()) core::refuse(table.get("unit"), unit.problem);
  const auto* layer = table.find("layer");
  Chain curves = read_dxf(file, path.string(), layer ? core::text(*layer) : "", unit.value);
  check_curves(file, curves);
  curves = with_length(std::move(curves));
  if (curves.empty())
    core::refuse(layer ? *layer : file,
                 fmt::format("no lines or arcs were found in \"{}\", allowed is a DXF file with some{}", path.string(),
                             layer ? " on this layer" : ""));
  return curves;
}

/// Brings curves into one chain, each end meeting the next start; refuses gaps, branches and several chains.
Chain chained(const CaseNode& file, Chain curves) {
  const double size = size_of(curves);
  Chain one{curves.front()};
  curves.erase(curves.begin());
  extend(file, one, curves, size);
  one = turned(one);
  extend(file, one, curves, size);
  if (!curves.empty()) refuse_rest(file, one, curves, size);
  return one;
}

}  // namespace

/// core::size takes the end of each segment for the start of another.
double size_of(Chain curves) {
  const Chain back = turned(curves);
  curves.insert(curves.end(), back.begin(), back.end());
  return core::size(core::Profile{std::move(curves), {}});
}

std::vector<Segment> read_section(const CaseNode& node, const std::string& directory) {
  const CaseTable table(node, {"file", "from", "via", "to", "unit", "layer"});
  Chain curves = chained(table.get("file"), read_drawing(table, directory));
  clean(curves);
  const bool closed = is_closed(curves, size_of(curves));
  const CaseNode &first = table.get("from"), *via = table.find("via"), *last = table.find("to");
  const double count = static_cast<double>(curves.size()), from = place_on(first, curves, read_point(first));
  if (via && !closed) core::refuse(*via, "a via was found, allowed only where the drawn outline is closed");
  if (!last && closed) return interval(curves, from, from + count);
  if (!last && from != 0 && from != count)
    core::refuse(
        first,
        fmt::format("{} is not an end of the drawn line, allowed are its ends, or any point together with a \"to\"",
                    first.text));
  double to = last ? place_on(*last, curves, read_point(*last)) : count - from;
  if (!closed) return to > from ? interval(curves, from, to) : interval(turned(curves), count - from, count - to);
  if (!via)
    core::refuse(*last,
                 "a closed outline can be followed to this point in two directions, allowed is \"to\" together with a "
                 "\"via\": a "
                 "point on the part that is wanted");
  double via_place = place_on(*via, curves, read_point(*via));
  if (to <= from) to += count;
  if (via_place < from) via_place += count;
  return via_place < to ? interval(curves, from, to) : interval(turned(curves), count - from, 2 * count - to);
}

}  // namespace parison::forming
