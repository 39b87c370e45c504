// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/case/units.hpp"
#include "forming/scene/read/read_density.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

Boundary read_boundary(const CaseNode& node) {
  const CaseTable table = boundary_table(node);
  Boundary boundary{core::identifier(table.get("name")), BoundaryKind::contact, {}, {}};
  const auto& condition = table.get("condition");
  if (condition.kind != CaseNode::Kind::table) {
    constexpr BoundaryKind kinds[] = {BoundaryKind::contact, BoundaryKind::symmetry, BoundaryKind::fixed,
                                      BoundaryKind::air, BoundaryKind::insulated};
    boundary.kind = kinds[core::choice(condition, {"contact", "symmetry", "fixed", "air", "insulated"})];
    return boundary;
  }
  const CaseTable given(condition, {"cooled", "temperature"});
  if (const auto* cooled = given.find("cooled")) {
    if (given.find("temperature")) core::refuse(condition, "two conditions were found, allowed is one");
    const CaseTable exchange(*cooled, {"h", "temperature"});
    boundary.kind = BoundaryKind::cooled;
    boundary.cooling.h = core::not_negative_over_time(exchange.get("h"), dimension::conductance);
    boundary.cooling.air_temperature = core::quantity_over_time(exchange.get("temperature"), dimension::temperature);
  } else {
    boundary.kind = BoundaryKind::temperature;
    boundary.temperature = core::quantity_over_time(given.get("temperature"), dimension::temperature);
  }
  return boundary;
}

MeshSpec::Mapped read_mapped(const CaseTable& mesh, const Body& body) {
  const auto& node = *mesh.find("mapped");
  if (core::list(node).size() != 2)
    core::refuse(node, fmt::format("{} members were found, allowed are the divisions along the first and the second "
                                   "boundary",
                                   node.items.size()));
  if (body.boundaries.size() != 4 || core::signed_area(body.profile) < 0)
    core::refuse(node, "a mapped mesh was found, allowed only on a body whose four boundaries run counterclockwise");
  MeshSpec::Mapped mapped{core::count(node.items[0]), core::count(node.items[1])};
  if (const auto* ratio = mesh.find("ratio")) {
    if (core::list(*ratio).size() != 2)
      core::refuse(*ratio, fmt::format("{} members were found, allowed are two ratios of the last division to the "
                                       "first",
                                       ratio->items.size()));
    mapped.ratio_first = core::positive(ratio->items[0], dimension::none);
    mapped.ratio_second = core::positive(ratio->items[1], dimension::none);
  }
  return mapped;
}

MeshSpec read_mesh(const CaseNode& node, const Body& body) {
  const CaseTable table(node, {"size", "contact_size", "growth", "mapped", "ratio"});
  MeshSpec mesh;
  if (const auto* item = table.find("size")) mesh.size = core::positive(*item, dimension::length);
  if (const auto* item = table.find("contact_size")) mesh.contact_size = core::positive(*item, dimension::length);
  if (const auto* item = table.find("growth")) mesh.growth = core::positive(*item, dimension::none);
  if (table.find("mapped")) mesh.mapped = read_mapped(table, body);
  if (const auto* ratio = table.find("ratio"); ratio && !mesh.mapped)
    core::refuse(*ratio, "a ratio was found, allowed only together with mapped");
  return mesh;
}

/// Refuses a segment on the axis that is not a symmetry boundary.
void check_axis(const Body& body, core::Geometry geometry, const CaseNode& boundaries) {
  if (geometry == core::Geometry::planar) return;
  const double on_axis = tolerance::joined * core::size(body.profile);
  for (const auto& segment : body.profile.segments) {
    const auto off = [&](double t) { return core::point_at(segment, t)[0] > on_axis; };
    if (off(0) || off(0.5) || off(1) || body.boundaries[segment.boundary_id].kind == BoundaryKind::symmetry) continue;
    core::refuse(boundaries.items[segment.boundary_id],
                 fmt::format("\"{}\" runs along the axis, allowed there is only the condition symmetry",
                             body.boundaries[segment.boundary_id].name));
  }
}

/// Whether a segment can be a symmetry boundary: it is straight and, in an axisymmetric scene, on the axis or normal
/// to it.
bool is_symmetric(const core::Segment& segment, core::Geometry geometry) {
  const core::Point first = core::point_at(segment, 0), along = core::point_at(segment, 1) - first;
  const double slack = 1e-6 * along.norm();
  if ((core::point_at(segment, 0.5) - first - 0.5 * along).norm() > slack) return false;
  if (geometry == core::Geometry::planar) return true;
  return (std::abs(first[0]) <= slack && std::abs(along[0]) <= slack) || std::abs(along[1]) <= slack;
}

void check_symmetry(const Body& body, core::Geometry geometry, const CaseNode& boundaries) {
  for (const auto& segment : body.profile.segments) {
    if (body.boundaries[segment.boundary_id].kind != BoundaryKind::symmetry || is_symmetric(segment, geometry))
      continue;
    const core::Point x = core::point_at(segment, 0.5);
    core::refuse(
        boundaries.items[segment.boundary_id],
        fmt::format("\"{}\" has the condition symmetry near ({:g}, {:g}) mm, allowed is symmetry on straight lines{}",
                    body.boundaries[segment.boundary_id].name, 1e3 * x[0], 1e3 * x[1],
                    geometry == core::Geometry::planar ? "" : " on the axis or across it"));
  }
}

/// Outline, boundaries and mesh; the outline is turned counterclockwise.
void read_shape(const CaseTable& table, const BodyContext& context, Body& body) {
  const auto& boundaries = table.get("boundary");
  refuse_repeated_names(table.tables("boundary"));
  body.profile = read_outline(boundaries, context.directory, body.drawing_notes);
  for (const auto& boundary : boundaries.items) body.boundaries.push_back(read_boundary(boundary));
  check_outline(body.profile, context.geometry, boundaries);
  check_axis(body, context.geometry, boundaries);
  check_symmetry(body, context.geometry, boundaries);
  if (const auto* mesh = table.find("mesh")) body.mesh = read_mesh(*mesh, body);
  if (core::signed_area(body.profile) < 0) body.profile = core::reversed(body.profile);
}

/// Names for a message: the case's own materials, and of the bundled ones the glasses or those of tools.
std::vector<std::string> fitting_names(const BodyContext& context, bool flows) {
  std::vector<std::string> names;
  const auto bundled = library_names();
  for (const auto& material : context.materials)
    if (std::find(bundled.begin(), bundled.end(), material.name) == bundled.end()) names.push_back(material.name);
  for (const auto& material : library_materials())
    if (material.flow.has_value() == flows) names.push_back(material.name);
  return names;
}

const NamedMaterial& find_material(const CaseNode& node, const BodyContext& context, bool flows) {
  const std::string name = core::text(node);
  const auto found = std::find_if(context.materials.begin(), context.materials.end(),
                                  [&](const auto& material) { return material.name == name; });
  if (found != context.materials.end()) return *found;
  const auto names = fitting_names(context, flows);
  core::refuse(node, fmt::format("\"{}\" was found{}, allowed are {}", name, core::did_you_mean(name, names),
                                 fmt::join(names, ", ")));
}

/// Pairs of a temperature of the glass at the contact and a coefficient, as ln beta over K.
core::Table read_friction_table(const CaseNode& node, bool with_heat) {
  if (!with_heat)
    core::refuse(node, "a table over temperature was found and the glass carries no heat, allowed is one coefficient");
  core::Table table = core::quantity_table(node, dimension::temperature, dimension::friction);
  for (std::size_t i = 0; i < table.y.size(); ++i)
    table.y[i] = std::log(core::positive(node.items[i].items[1], dimension::friction));
  return table;
}

flow::Friction read_friction(const CaseNode& node, bool with_heat) {
  using Law = flow::Friction::Law;
  flow::Friction friction;
  if (node.kind != CaseNode::Kind::table) {
    constexpr Law laws[] = {Law::slip, Law::stick, Law::grip};
    if (core::text(node) == "navier")
      core::refuse(node,
                   "\"navier\" lacks its coefficient, allowed is { law = \"navier\", coefficient = \"1e6 Pa.s/m\" }");
    constexpr const char* names[] = {"slip", "stick", "grip"};
    const auto* law = std::find(std::begin(names), std::end(names), core::text(node));
    if (law == std::end(names))
      core::refuse(node, fmt::format("\"{}\" was found, allowed are \"slip\", \"stick\", \"grip\" or a table {{ law = "
                                     "\"navier\", coefficient = \"1e6 Pa.s/m\" }}",
                                     node.text));
    friction.law = laws[law - std::begin(names)];
    return friction;
  }
  const CaseTable table(node, {"law", "coefficient", "coulomb"});
  core::choice(table.get("law"), {"navier"});
  friction.law = Law::navier;
  const CaseNode& coefficient = table.get("coefficient");
  if (coefficient.kind == CaseNode::Kind::list)
    friction.by_temperature = read_friction_table(coefficient, with_heat);
  else
    friction.coefficient = core::positive(coefficient, dimension::friction);
  if (const auto* coulomb = table.find("coulomb")) friction.coulomb = core::positive(*coulomb, dimension::none);
  return friction;
}

FilmLimit read_film(const CaseNode& node) {
  const CaseTable table(node, {"min_thickness", "then"});
  FilmLimit film;
  if (const auto* item = table.find("min_thickness")) film.min_thickness = core::positive(*item, dimension::length);
  if (const auto* item = table.find("then"))
    film.then = core::choice(*item, {"stop", "freeze"}) == 0 ? FilmLimit::Then::stop : FilmLimit::Then::freeze;
  return film;
}

}  // namespace

std::vector<std::string> glass_keys() {
  return {"material", "temperature", "skin", "gob", "mesh", "film", "boundary"};
}

void read_glass_temperature(const CaseTable& table, const BodyContext& context, Glass& glass) {
  const bool expands = !glass.relative_density().x.empty();
  const bool needed = glass.thermal || !glass.flow->viscosity.constant || expands;
  const auto* item = needed ? &table.get("temperature") : table.find("temperature");
  if (item) read_start_temperature(*item, context, glass);
  const double coldest = glass.start_field ? glass.start_field->min : glass.initial_temperature;
  if (item && glass.flow && !glass.flow->viscosity.constant && coldest <= glass.flow->viscosity.T0)
    core::refuse(*item, fmt::format("{} was found, allowed are temperatures above T0 of the viscosity",
                                    glass.start_field ? fmt::format("{:.4g} degC", coldest - core::zero_celsius)
                                                      : fmt::format("\"{}\"", item->text)));
  const auto* skin = table.find("skin");
  if (skin && glass.start_field)
    core::refuse(*skin, "a skin and a field of temperatures were found, allowed is one of them");
  if (skin) glass.skin = read_skin(*skin, glass);
  relate_density(
      [&](const core::Table& density) {
        return start_mean(glass, context.geometry, [&](double T) { return density(T); });
      },
      glass);
}

/// Relates the density of a gob that is given by its mass to the temperature at which it is to have it.
void relate_gob_density(const CaseTable& table, Glass& glass) {
  if (glass.relative_density().x.empty()) return;
  const CaseNode& temperature = table.get("temperature");
  const auto* skin = table.find("skin");
  if (skin || temperature.kind == CaseNode::Kind::table)
    core::refuse(skin ? *skin : temperature,
                 "a gob by its mass was found with a density over temperature, allowed is one temperature of all of "
                 "it, or its outline by a boundary");
  const double of_gob = core::quantity(temperature, dimension::temperature);
  relate_density([&](const core::Table& density) { return density(of_gob); }, glass);
}

Glass read_glass(const CaseNode& node, const BodyContext& context) {
  const CaseTable table(node, glass_keys());
  Glass glass;
  glass.name = "glass";
  const auto& material = find_material(table.get("material"), context, true);
  glass.thermal = material.thermal;
  glass.flow = material.flow;
  glass.annealing = material.annealing;
  if (material.emissivity.y.size() > 1)
    core::refuse(
        table.get("material"),
        fmt::format("\"{}\" has an emissivity over temperature, allowed for the glass is one value", material.name));
  glass.emissivity = material.emissivity.y.front();
  if (!glass.thermal && !glass.flow)
    core::refuse(table.get("material"),
                 fmt::format("\"{}\" has neither viscosity nor conductivity and heat_capacity, allowed is a material "
                             "that flows or carries heat",
                             material.name));
  if (const auto* item = table.find("film")) glass.film = read_film(*item);
  const auto* gob = table.find("gob");
  if (!gob || table.find("boundary")) read_shape(table, context, glass);
  if (gob) relate_gob_density(table, glass);
  if (gob) read_gob(*gob, context.geometry, glass);
  if (const auto* mesh = table.find("mesh"); mesh && !table.find("boundary")) glass.mesh = read_mesh(*mesh, glass);
  const bool has_its_place = !gob || !CaseTable(*gob, gob_keys()).find("in");
  if (has_its_place) read_glass_temperature(table, context, glass);
  return glass;
}

Swab read_swab(const CaseNode& node) {
  const CaseTable table(node, {"every", "heat", "time"});
  Swab swab{core::count(table.get("every")), core::positive(table.get("heat"), dimension::heat_per_area)};
  if (const auto* item = table.find("time")) swab.seconds = core::positive(*item, dimension::time);
  return swab;
}

Tool read_tool(const CaseNode& node, const BodyContext& context) {
  const CaseTable table(node, {"name", "material", "temperature", "temperature_at", "friction", "swabbing", "swab",
                               "position", "mesh", "boundary", "section"});
  Tool tool;
  tool.name = core::identifier(table.get("name"));
  if (tool.name == "glass")
    core::refuse(table.get("name"), "\"glass\" was found, allowed is any other name for a tool");
  if (context.with_heat) {
    const auto& item = table.get("material");
    const auto& material = find_material(item, context, false);
    if (!material.thermal)
      core::refuse(item,
                   fmt::format("\"{}\" has no conductivity and heat_capacity, allowed is a material that carries heat, "
                               "because the glass does",
                               material.name));
    if (!material.thermal->relative_density.x.empty())
      core::refuse(item,
                   fmt::format("\"{}\" has a density over temperature, which only the glass can have", material.name));
    if (thermal::has_light(*material.thermal))
      core::refuse(
          item,
          fmt::format("\"{}\" has radiation in bands, which only the glass can have; allowed are the models none and "
                      "rosseland",
                      material.name));
    if (context.with_light && !material.has_emissivity)
      core::refuse(item,
                   fmt::format("\"{}\" has no emissivity, allowed is a material with one, because light of the glass "
                               "reaches the tool (oxidised iron: 0.8)",
                               material.name));
    if (thermal::is_rosseland(*material.thermal) && material.thermal->radiation->thin_wall)
      core::refuse(item,
                   fmt::format("\"{}\" has radiation with thin_wall = true, which only the glass can have; allowed is "
                               "thin_wall = false or no radiation",
                               material.name));
    tool.thermal = material.thermal;
    table.get("temperature");
  }
  if (context.with_flow) tool.friction = read_friction(table.get("friction"), context.with_heat);
  if (const auto* item = table.find("swabbing")) tool.swabbing = core::positive(*item, dimension::none);
  if (const auto* item = table.find("temperature_at")) tool.waits = core::choice(*item, {"start", "first use"}) == 1;
  if (const auto* item = table.find("swab")) tool.swab = read_swab(*item);
  if (const auto* item = table.find("position")) tool.position = core::quantity(*item, dimension::length);
  read_shape(table, context, tool);
  if (const auto* item = table.find("section")) tool.section = read_sections(*item, context, tool);
  if (!tool.thermal) return tool;
  read_start_temperature(table.get("temperature"), context, tool);
  tool.emissivity = find_material(table.get("material"), context, false).emissivity(tool.initial_temperature);
  return tool;
}

}  // namespace parison::forming
