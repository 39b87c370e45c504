// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/read_section.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/placement.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using core::Point;
using core::Segment;

/// "; ... reaches from (0, -200) mm to (70, 0) mm".
std::string extent_of(const Chain& chain) {
  Point low = chain.front().start, high = low;
  for (const Segment& segment : chain)
    for (const double t : {0.0, 0.5, 1.0})
      low = low.cwiseMin(core::point_at(segment, t)), high = high.cwiseMax(core::point_at(segment, t));
  return fmt::format("; in the frame of the case the outline next to it reaches from {} to {}", in_mm(low),
                     in_mm(high));
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
    core::refuse(node, fmt::format("{} is {:.3g} mm away from the drawing, allowed are points on it{}", in_mm(x),
                                   1e3 * best, best > tolerance::drawing_gap * size_of(chain) ? extent_of(chain) : ""));
  return place;
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

}  // namespace

DrawnCurves read_drawing(const CaseTable& table, const std::string& directory, std::vector<std::string>& notes) {
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
    DrawnCurves drawing;
    drawing.curves = read_step(table, path.string(), drawing.is_cut, notes);
    return drawing;
  }
  DrawnCurves drawing;
  drawing.curves = read_dxf(table, path.string(), drawing.layers, notes);
  check_curves(file, drawing.curves);
  drawing.curves = with_length(std::move(drawing.curves));
  if (drawing.curves.empty())
    core::refuse(file,
                 fmt::format("no lines or arcs with a length were found in \"{}\", allowed is a DXF file with some",
                             path.string()));
  return drawing;
}

namespace {

/// How far apart the ends of curves may be, m.
double gap_of(const CaseTable& table, double size) {
  constexpr double usual = 1e-5;  // m
  const auto* gap = table.find("gap");
  if (!gap) return std::min(usual, 0.1 * tolerance::drawing_gap * size);
  const double value = core::not_negative(*gap, core::dimension::length);
  if (value > tolerance::drawing_gap * size)
    core::refuse(*gap, fmt::format("{} was found, allowed are up to {:.3g} mm in this drawing", gap->text,
                                   1e3 * tolerance::drawing_gap * size));
  return value;
}

/// A curve that a place lies on; null without one.
const Segment* curve_at(const Chain& curves, const Point& x, double near) {
  const auto is_at = [&](const Segment& curve) { return core::distance(curve, x, 2 * near) < near; };
  const auto found = std::find_if(curves.begin(), curves.end(), is_at);
  return found == curves.end() ? nullptr : &*found;
}

/// Refuses a drawing of several outlines where it is not clear which is meant: two go through the first place, or the
/// one that does is open and does not come to the last.
void check_choice(const CaseTable& table, const Chained& drawn, const std::vector<std::string>& layers) {
  if (drawn.rest.empty()) return;
  const CaseNode &file = table.get("file"), &first = table.get("from"), *last = table.find("to");
  const double near = 2 * tolerance::on_drawing * size_of(drawn.chain);
  const Point from = read_point(first);
  if (const auto* other = curve_at(drawn.rest, from, near)) {
    std::string of_layers;
    if (const auto* own = curve_at(drawn.chain, from, near); own && !layers.empty())
      of_layers = fmt::format(", on layer \"{}\" and on layer \"{}\" (layer takes one alone)", layers[own->boundary_id],
                              layers[other->boundary_id]);
    refuse_several(file, drawn, fmt::format("{} lies on two{}, allowed is a place on one", first.text, of_layers));
  }
  if (!is_closed(drawn.chain) && !(last && curve_at(drawn.chain, read_point(*last), near)))
    refuse_several(file, drawn,
                   fmt::format("the one next to {} is open and ends at {} and {}, allowed is a closed one "
                               "or one from \"from\" to \"to\"",
                               first.text, in_mm(drawn.chain.front().start), in_mm(drawn.chain.back().end)));
}

/// Without straight lines along the axis at an end of which no curve goes on, such as centre lines, where the places of
/// the case lie on other curves.
Chain without_centre_lines(const CaseTable& table, const Chain& curves) {
  const double joined = tolerance::joined * size_of(curves), near = 2 * tolerance::on_drawing * size_of(curves);
  const auto is_free = [&](const Point& end) {
    const auto has_end = [&](const Segment& curve) {
      return (curve.start - end).norm() <= joined || (curve.end - end).norm() <= joined;
    };
    return std::count_if(curves.begin(), curves.end(), has_end) == 1;
  };
  Chain others;
  for (const Segment& curve : curves) {
    const bool is_on_axis = !curve.is_arc && std::max(std::abs(curve.start[0]), std::abs(curve.end[0])) <= joined;
    if (!is_on_axis || !(is_free(curve.start) || is_free(curve.end))) others.push_back(curve);
  }
  for (const auto* place : {&table.get("from"), table.find("to")})
    if (place && !curve_at(others, read_point(*place), near)) return curves;
  return others;
}

/// Of curves that branch, those on the way that is wanted.
Chain way_past_branches(const CaseTable& table, const Chain& curves, const Point& branch, double gap) {
  const CaseNode &file = table.get("file"), &first = table.get("from"), *last = table.find("to");
  const std::string meet = fmt::format("more than two curves of the drawing meet at {}", in_mm(branch));
  if (!last)
    core::refuse(file, meet + ", allowed is one outline without branches, or a \"to\" up to which it is taken");
  for (const auto* place : {&first, last}) place_on(*place, curves, read_point(*place));
  const auto ways = ways_between(curves, read_point(first), read_point(*last), gap);
  if (!ways) core::refuse(file, meet + " and at many other places, allowed are fewer (layer takes one layer alone)");
  if (ways->empty())
    core::refuse(
        *last, fmt::format("no curves lead from {} to this point, allowed are two points of one outline", first.text));
  if (ways->size() == 1) return ways->front();
  if (auto way = wanted_way(table, *ways)) return *std::move(way);
  core::refuse(file,
               fmt::format("{}, so {} ways lead from \"from\" to \"to\", allowed is one, or a \"via\": a point on "
                           "the part that is wanted",
                           meet, ways->size()));
}

/// How many curves have a part beside the axis, at positive radii: the mirrored half of a full section has none.
std::size_t count_right(const Chain& curves, double joined) {
  return static_cast<std::size_t>(std::count_if(curves.begin(), curves.end(), [&](const Segment& curve) {
    return std::max({curve.start[0], core::point_at(curve, 0.5)[0], curve.end[0]}) > joined;
  }));
}

/// The outline of the drawing at the first place as one chain of curves in the frame of the case; where curves branch,
/// the wanted part of it.
Chained read_chain(const CaseTable& table, const std::string& directory, std::vector<std::string>& notes) {
  const CaseNode& file = table.get("file");
  auto [curves, layers, is_cut] = read_drawing(table, directory, notes);
  check_curves(file, curves);
  place(table, is_cut, curves);
  const double size = size_of(curves), gap = gap_of(table, size);
  const Chain outlines = without_centre_lines(table, curves);
  const CaseNode& first = table.get("from");
  Chained drawn = chained(file, outlines, read_point(first), gap);
  if (const auto branch = drawn.branch) {
    drawn = chained(file, way_past_branches(table, outlines, *branch, gap), read_point(first), gap);
    drawn.branch = branch;
    notes.push_back(fmt::format("of \"{}\" {} curves from {} to {} were taken, others that meet them were left out",
                                file.text, drawn.chain.size(), first.text, table.get("to").text));
  } else {
    check_choice(table, drawn, layers);
    const double joined = tolerance::joined * size;
    if (const std::size_t all = count_right(curves, joined), taken = count_right(drawn.chain, joined); all > taken)
      notes.push_back(fmt::format("of \"{}\" the outline through {} was taken, {} curves of others were left out",
                                  file.text, first.text, all - taken));
  }
  const ClosedGaps& closed = drawn.closed;
  // The CAD kernel finds where a plane cuts a curved surface within less than that.
  const bool is_of_kernel = is_cut && closed.widest <= curve_tolerance(size);
  if (closed.count > 0 && !is_of_kernel)
    notes.push_back(
        fmt::format("gaps between curves of \"{}\" were closed, {} in all, the widest of {:.2g} mm at {}; with gap = "
                    "\"0 mm\" they are refused",
                    file.text, closed.count, 1e3 * closed.widest, in_mm(closed.where)));
  clean(drawn.chain);
  return drawn;
}

/// The whole outline from a place on it, or the whole drawn line from one of its ends.
Chain whole(const CaseTable& table, const Chain& curves, bool closed) {
  const CaseNode& first = table.get("from");
  const double count = static_cast<double>(curves.size()), from = place_on(first, curves, read_point(first));
  if (closed) return interval(curves, from, from + count);
  if (from == 0 || from == count) return from == 0 ? curves : turned(curves);
  refuse_nearly_closed(table.get("file"), curves, gap_of(table, size_of(curves)));
  core::refuse(
      first,
      fmt::format("{} is not an end of the drawn line, allowed are its ends, or any point together with a \"to\"",
                  first.text));
}

/// The two ways round a closed outline from one position to another.
std::vector<Chain> ways_round(const Chain& curves, double from, double to) {
  const double count = static_cast<double>(curves.size());
  if (to <= from) to += count;
  return {interval(curves, from, to), interval(turned(curves), count - from, 2 * count - to)};
}

}  // namespace

Segment part_of(const Segment& segment, double from, double to) {
  Segment part = segment;
  if (from > 0) part.start = core::point_at(segment, from);
  if (to < 1) part.end = core::point_at(segment, to);
  part.from = segment.from + from * (segment.to - segment.from);
  part.to = to < 1 ? segment.from + to * (segment.to - segment.from) : segment.to;
  return part;
}

std::vector<Segment> read_section(const CaseNode& node, const std::string& directory, std::vector<std::string>& notes) {
  const CaseTable table(node, {"file", "from", "via", "to", "unit", "layer", "origin", "axis", "turn", "gap"});
  const auto drawn = read_chain(table, directory, notes);
  const Chain& curves = drawn.chain;
  const bool closed = is_closed(curves);
  const CaseNode &first = table.get("from"), *via = table.find("via"), *last = table.find("to");
  if (via && !closed && !drawn.branch) {
    refuse_nearly_closed(table.get("file"), curves, gap_of(table, size_of(curves)));
    core::refuse(*via, "a via was found, allowed only where the drawn outline is closed or branches");
  }
  if (!last) return whole(table, curves, closed);
  const double count = static_cast<double>(curves.size()), from = place_on(first, curves, read_point(first)),
               to = place_on(*last, curves, read_point(*last));
  if (!closed) return to > from ? interval(curves, from, to) : interval(turned(curves), count - from, count - to);
  if (auto way = wanted_way(table, ways_round(curves, from, to))) return *std::move(way);
  core::refuse(*last,
               "a closed outline can be followed to this point in two directions, allowed is \"to\" together with a "
               "\"via\": a point on the part that is wanted");
}

}  // namespace parison::forming
