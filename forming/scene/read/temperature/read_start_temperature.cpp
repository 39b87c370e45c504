// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "core/io/hdf5.hpp"
#include "core/io/mesh_hdf5.hpp"
#include "core/mesh/element.hpp"
#include "forming/scene/kept_results.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/temperature/temperature_table.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using core::Point;
namespace dimension = core::dimension;

struct Box {
  Point low, high;
};

Box box_of(const std::vector<Point>& points) {
  Box box{points.front(), points.front()};
  for (const Point& x : points) box = {box.low.cwiseMin(x), box.high.cwiseMax(x)};
  return box;
}

constexpr int across = 40;  ///< places along each side of a body

std::vector<Point> outline_places(const core::Profile& profile) {
  return core::polyline(profile, core::size(profile) / across, 1e-3 * core::size(profile));
}

/// Evenly over a body, closer where it fills little of its box.
std::vector<Point> inner_places(const core::Profile& profile) {
  constexpr std::size_t enough = across * across / 4;
  constexpr int closest = 16 * across;
  const Box box = box_of(outline_places(profile));
  std::vector<Point> points;
  for (int n = across; points.size() < enough && n <= closest; n *= 2) {
    points.clear();
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const Point x = box.low + Point(i + 0.5, k + 0.5).cwiseProduct(box.high - box.low) / n;
        if (core::contains(profile, x)) points.push_back(x);
      }
  }
  if (points.empty()) points = outline_places(profile);  // too thin for them
  return points;
}

/// Places on an outline and inside it.
std::vector<Point> places(const core::Profile& profile) {
  std::vector<Point> points = outline_places(profile), inner = inner_places(profile);
  points.insert(points.end(), inner.begin(), inner.end());
  return points;
}

/// The temperature of "1150 degC - 80 K*r/(26 mm)" at a place, by its r and z.
double value_of(const CaseNode& formula, const Point& x) {
  core::NamedQuantities known;
  if (formula.known) known.names = formula.known->names;
  known.names.insert(known.names.end(), {"r", "z"});
  known.find = [&](std::string_view name) -> std::optional<core::Measure> {
    if (name == "r") return core::Measure{x[0], dimension::length};
    if (name == "z") return core::Measure{x[1], dimension::length};
    return formula.known ? formula.known->find(name) : std::nullopt;
  };
  const auto parsed = core::parse_formula_as(formula.text, dimension::temperature, known);
  const std::string place = fmt::format(" at ({:g}, {:g}) mm", 1e3 * x[0], 1e3 * x[1]);
  if (!parsed.problem.empty()) core::refuse(formula, parsed.problem + place);
  if (parsed.value <= 0)
    core::refuse(formula, fmt::format("{:g} K was found{}, allowed are temperatures above zero", parsed.value, place));
  return parsed.value;
}

StartField read_formula(const CaseNode& node) {
  StartField field;
  field.source = fmt::format("\"{}\"", core::text(node));
  field.at = [node](const Point& x) { return value_of(node, x); };
  return field;
}

/// Looked for beside the case file, then in the working folder.
std::string result_folder(const CaseNode& node, const std::string& directory) {
  const auto beside = std::filesystem::path(directory) / core::text(node);
  std::error_code unreadable;
  return std::filesystem::exists(beside, unreadable) ? beside.string() : node.text;
}

/// The group of a body in a checkpoint.
std::string group_of(const core::Hdf5Group& file, const CaseNode& place, const std::string& body) {
  if (body == "glass") return "glass";
  std::vector<std::string> names{"glass"};
  for (int i = 0; file.has(fmt::format("tool_name_{}", i)); ++i) {
    names.push_back(file.read_string(fmt::format("tool_name_{}", i)));
    if (names.back() == body) return fmt::format("tool_{}", i);
  }
  core::refuse(place, fmt::format("that result has no body \"{}\"{}, allowed are {}", body,
                                  core::did_you_mean(body, names), fmt::join(names, ", ")));
}

std::string text_of(const Box& box) {
  return fmt::format("({:g}, {:g}) to ({:g}, {:g}) mm", 1e3 * box.low[0], 1e3 * box.low[1], 1e3 * box.high[0],
                     1e3 * box.high[1]);
}

/// Temperatures are handed over between bodies of one shape.
void refuse_other_shape(const CaseNode& node, const core::Profile& profile, const core::Mesh& mesh) {
  constexpr double allowed = 0.02;
  const Box here = box_of(core::polyline(profile, core::size(profile), 1e-3 * core::size(profile))),
            there = box_of(mesh.nodes);
  const double off = std::max((here.low - there.low).norm(), (here.high - there.high).norm());
  if (off > allowed * core::size(profile))
    core::refuse(node,
                 fmt::format("the body lies from {} at the end of that result but from {} here, allowed is one that "
                             "lies in the same place within 2 % of its size",
                             text_of(there), text_of(here)));
}

StartField read_result(const CaseTable& table, const BodyContext& context, const Body& body) {
  const CaseNode& from = *table.find("from");
  const std::string folder = result_folder(from, context.directory);
  const std::string kept = kept_results(context.directory, core::text(from));
  std::error_code unreadable;
  const std::string path = (std::filesystem::exists(kept, unreadable) ? kept : folder) + "/checkpoint.h5";
  const auto* name = table.find("body");
  if (const std::string problem = core::read_hdf5(path).problem; !problem.empty())
    core::refuse(from, fmt::format("{} {}; allowed is the folder of a result", path, problem));
  const core::Hdf5Group file = core::open_hdf5(path);
  const core::Hdf5Group state = file.open("state");
  const std::string which = name ? core::text(*name) : body.name;
  const core::Hdf5Group group = state.open(group_of(file, name ? *name : from, which));
  StartField field;
  field.source = fmt::format("{} at {:.4g} s of {}", which, state.read_double("time"), folder);
  field.mesh = core::read_mesh(group.open("mesh"));
  field.temperature = group.read_vector("temperature");
  if (field.temperature.size() != field.mesh.node_count())
    core::refuse(from,
                 fmt::format("\"{}\" of that result has no temperatures, allowed is one that carries heat", which));
  refuse_other_shape(from, body.profile, field.mesh);
  return field;
}

/// The same field, warmer by a temperature difference everywhere.
void warm(StartField& field, double by) {
  if (auto* grid = field.at.target<TemperatureGrid>())
    for (double& T : grid->T) T += by;
  else if (field.at)
    field.at = [at = std::move(field.at), by](const Point& x) { return at(x) + by; };
  field.temperature.array() += by;
  field.source += fmt::format(", {:+g} K", by);
}

void set_range(StartField& field, const core::Profile& profile) {
  if (!field.at) {
    field.min = field.temperature.minCoeff();
    field.max = field.temperature.maxCoeff();
    return;
  }
  field.min = std::numeric_limits<double>::infinity();
  field.max = 0;
  for (const Point& x : places(profile)) {
    const double T = field.at(x);
    field.min = std::min(field.min, T);
    field.max = std::max(field.max, T);
  }
}

/// A table of another place, or in another unit than its heading says, would give one temperature to all.
void refuse_table_elsewhere(const CaseNode& node, const Body& body, core::Geometry geometry) {
  constexpr double least = 1e-3;
  if (share_beyond_table(body, geometry) <= 1 - least) return;
  const TemperatureGrid& grid = *body.start_field->at.target<TemperatureGrid>();
  const Box there = box_of(outline_places(body.profile));
  const auto range = [](const char* along, const std::vector<double>& axis) {
    return axis.size() > 1 ? fmt::format(" {} from {:g} to {:g} mm", along, 1e3 * axis.front(), 1e3 * axis.back()) : "";
  };
  core::refuse(node, fmt::format("a table with{}{} was found and the body lies from {}, allowed is a table that covers "
                                 "the body or a part of it",
                                 range("r", grid.r), range("z", grid.z), text_of(there)));
}

}  // namespace

double start_mean(const Body& body, core::Geometry geometry, const std::function<double(double)>& f) {
  if (!body.start_field) return f(body.initial_temperature);
  const StartField& field = *body.start_field;
  double sum = 0, volume = 0;
  const auto add = [&](double weight, double T) {
    sum += weight * f(T);
    volume += weight;
  };
  if (field.at)
    for (const Point& x : inner_places(body.profile)) add(geometry == core::Geometry::planar ? 1 : x[0], field.at(x));
  for (Index c = 0; c < field.mesh.cell_count(); ++c)
    for (const auto& rule : core::triangle_rule(4)) {
      const auto at = core::map_cell_point(field.mesh, c, geometry, rule);
      double T = 0;
      for (int i = 0; i < 6; ++i) T += at.shape[i] * field.temperature[field.mesh.cells()[c][i]];
      add(at.volume, T);
    }
  return sum / volume;
}

double share_beyond_table(const Body& body, core::Geometry geometry) {
  const auto* grid = body.start_field ? body.start_field->at.target<TemperatureGrid>() : nullptr;
  if (!grid) return 0;
  double beyond = 0, all = 0;
  for (const Point& x : inner_places(body.profile)) {
    const double weight = geometry == core::Geometry::planar ? 1 : x[0];
    all += weight;
    if (!grid->covers(x, 1e-6 * core::size(body.profile))) beyond += weight;
  }
  return beyond / all;
}

void read_start_temperature(const CaseNode& node, const BodyContext& context, Body& body) {
  if (node.kind != CaseNode::Kind::table) {
    body.initial_temperature = core::quantity(node, dimension::temperature);
    return;
  }
  const CaseTable table(node, {"formula", "csv", "from", "body", "plus"});
  const auto *formula = table.find("formula"), *csv = table.find("csv"), *from = table.find("from");
  if (!body.thermal) core::refuse(node, "a field of temperatures was found, allowed only where the glass carries heat");
  if ((formula != nullptr) + (csv != nullptr) + (from != nullptr) != 1)
    core::refuse(node, "allowed is one of formula, csv and from");
  if (const auto* other = table.find("body"); other && !from)
    core::refuse(*other, "a body was found, allowed only together with \"from\"");
  StartField field = formula ? read_formula(*formula)
                     : csv   ? read_temperature_table(*csv, context.directory)
                             : read_result(table, context, body);
  if (const auto* plus = table.find("plus")) warm(field, core::quantity(*plus, dimension::temperature_difference));
  set_range(field, body.profile);
  if (field.min <= 0)
    core::refuse(node, fmt::format("{:g} K was found, allowed are temperatures above zero", field.min));
  body.start_field = std::move(field);
  body.initial_temperature = start_mean(body, context.geometry, [](double T) { return T; });
  if (csv) refuse_table_elsewhere(*csv, body, context.geometry);
}

std::string start_field_text(const StartField& field, const core::Profile& profile) {
  std::string text = field.source + "\n";
  if (field.at)
    for (const Point& x : places(profile)) text += fmt::format("{} ", field.at(x));
  for (Index i = 0; i < field.temperature.size(); ++i) text += fmt::format("{} ", field.temperature[i]);
  return text;
}

}  // namespace parison::forming
