// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/checkpoint.hpp"

#include <fmt/format.h>

#include "core/case_error.hpp"
#include "core/files.hpp"
#include "core/hdf5.hpp"

namespace parison::forming {
namespace {

using core::Hdf5Group;

constexpr std::int64_t format_version = 1;

void write_points(Hdf5Group& group, const std::string& name, const std::vector<Point>& points) {
  std::vector<double> values;
  for (const Point& x : points) values.insert(values.end(), x.data(), x.data() + core::dim);
  group.write(name, values, core::dim);
}

std::vector<Point> read_points(const Hdf5Group& group, const std::string& name) {
  const std::vector<double> values = group.read_doubles(name);
  std::vector<Point> points(values.size() / core::dim);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = Eigen::Map<const Point>(values.data() + core::dim * i);
  return points;
}

void write_mesh(Hdf5Group group, const core::Mesh& mesh) {
  write_points(group, "nodes", mesh.nodes);
  group.write("vertex_count", std::int64_t{mesh.vertex_count});
  std::vector<int> cells, boundary;
  for (const auto& cell : mesh.cells) cells.insert(cells.end(), cell.begin(), cell.end());
  for (const core::BoundaryEdge& edge : mesh.boundary)
    for (const Index value : {edge.nodes[0], edge.nodes[1], edge.nodes[2], edge.cell, edge.piece})
      boundary.push_back(value);
  group.write("cells", cells, 6);
  group.write("boundary", boundary, 5);
  group.write("piece_count", static_cast<std::int64_t>(mesh.pieces.size()));
  for (std::size_t i = 0; i < mesh.pieces.size(); ++i) group.write(fmt::format("piece_{}", i), mesh.pieces[i]);
}

core::Mesh read_mesh(const Hdf5Group& group) {
  core::Mesh mesh;
  mesh.nodes = read_points(group, "nodes");
  mesh.vertex_count = static_cast<Index>(group.read_integer("vertex_count"));
  const std::vector<int> cells = group.read_integers("cells"), boundary = group.read_integers("boundary");
  mesh.cells.resize(cells.size() / 6);
  for (std::size_t i = 0; i < cells.size(); ++i) mesh.cells[i / 6][i % 6] = cells[i];
  for (std::size_t i = 0; i + 5 <= boundary.size(); i += 5)
    mesh.boundary.push_back({{boundary[i], boundary[i + 1], boundary[i + 2]}, boundary[i + 3], boundary[i + 4]});
  for (std::int64_t i = 0; i < group.read_integer("piece_count"); ++i)
    mesh.pieces.push_back(group.read_string(fmt::format("piece_{}", i)));
  return mesh;
}

/// One list of the plain numbers of a structure serves writing and reading.
struct Writer {
  Hdf5Group group;
  void operator()(const char* name, double value) { group.write(name, value); }
  void operator()(const char* name, int value) { group.write(name, std::int64_t{value}); }
  void operator()(const char* name, long value) { group.write(name, std::int64_t{value}); }
  void operator()(const char* name, const Eigen::VectorXd& value) { group.write(name, value); }
  void operator()(const char* name, const std::vector<int>& value) { group.write(name, value); }
  void operator()(const char* name, const std::vector<Point>& value) { write_points(group, name, value); }
  void operator()(const char* name, const core::Mesh& value) { write_mesh(group.create(name), value); }
  Writer part(const std::string& name) { return {group.create(name)}; }
};

struct Reader {
  Hdf5Group group;
  void operator()(const char* name, double& value) { value = group.read_double(name); }
  void operator()(const char* name, int& value) { value = static_cast<int>(group.read_integer(name)); }
  void operator()(const char* name, long& value) { value = static_cast<long>(group.read_integer(name)); }
  void operator()(const char* name, Eigen::VectorXd& value) { value = group.read_vector(name); }
  void operator()(const char* name, std::vector<int>& value) { value = group.read_integers(name); }
  void operator()(const char* name, std::vector<Point>& value) { value = read_points(group, name); }
  void operator()(const char* name, core::Mesh& value) { value = read_mesh(group.open(name)); }
  Reader part(const std::string& name) { return {group.open(name)}; }
};

template <typename Visitor, typename Body>
void visit_body(Visitor visit, Body& body) {
  visit("mesh", body.mesh);
  visit("temperature", body.temperature);
  visit("offset", body.offset);
  visit("velocity", body.velocity);
  visit("force", body.force);
  visit("heat_received", body.heat_received);
  visit("hottest_surface", body.hottest_surface);
}

template <typename Visitor, typename Sums>
void visit_totals(Visitor visit, Sums& totals) {
  visit("to_air", totals.to_air);
  visit("to_tools", totals.to_tools);
  visit("dissipation", totals.dissipation);
  visit("content_change", totals.content_change);
  visit("remesh_heat", totals.remesh_heat);
  visit("remesh_volume", totals.remesh_volume);
  visit("steps", totals.steps);
  visit("rejected", totals.rejected);
  visit("remeshes", totals.remeshes);
  visit("table_holds", totals.table_holds);
  visit("deepest", totals.deepest);
  visit("largest_drift", totals.largest_drift);
  visit("largest_reynolds", totals.largest_reynolds);
}

template <typename Visitor, typename Whole>
void visit_state(Visitor& visit, Whole& state) {
  visit("time", state.time);
  visit("stage", state.stage);
  visit("stage_time", state.stage_time);
  visit("next_step", state.next_step);
  visit("heat_substep", state.heat_substep);
  visit("last_step", state.last_step);
  visit("mass_nodes", state.mass_nodes);
  visit("density", state.density);
  visit("first_volume", state.first_volume);
  visit("first_heat", state.first_heat);
  visit("velocity", state.velocity);
  visit("contact_tool", state.contact.tool);
  visit("contact_pressure", state.contact.pressure);
  visit("contact_closed_node", state.contact.closed.node);
  visit("contact_closed_tool", state.contact.closed.tool);
  visit("contact_closed_normal", state.contact.closed.normal);
  visit("probes", state.probes);
  visit_totals(visit.part("totals"), state.totals);
  for (std::size_t i = 0; i < state.bodies.size(); ++i) visit_body(visit.part(fmt::format("body_{}", i)), state.bodies[i]);
}

void require_match(const std::string& path, const Scene& scene, const Hdf5Group& file) {
  const std::int64_t version = file.has("version") ? file.read_integer("version") : 0;
  if (version != format_version)
    throw core::CaseError(fmt::format("{}: a checkpoint of version {} was found, allowed is version {}", path, version,
                                      format_version));
  if (static_cast<std::uint64_t>(file.read_integer("fingerprint")) != scene.fingerprint)
    throw core::CaseError(fmt::format(
        "{}: a checkpoint of the case \"{}\" with another case file was found, allowed is one of \"{}\" as it is now",
        path, file.read_string("case"), scene.name));
}

}  // namespace

void write_checkpoint(const std::string& path, const Scene& scene, const State& state) {
  core::replace_file(path, [&](const std::string& temporary) {
    {
      Writer writer{core::create_hdf5(temporary)};
      writer.group.write("version", format_version);
      writer.group.write("case", scene.name);
      writer.group.write("fingerprint", static_cast<std::int64_t>(scene.fingerprint));
      visit_state(writer, state);
    }
    core::sync_to_disk(temporary);
  });
}

State read_checkpoint(const std::string& path, const Scene& scene) {
  Reader reader{core::open_hdf5(path)};
  require_match(path, scene, reader.group);
  State state;
  state.bodies.resize(scene.tools.size() + 1);
  visit_state(reader, state);
  return state;
}

}  // namespace parison::forming
