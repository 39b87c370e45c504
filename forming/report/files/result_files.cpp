// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/files/result_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
#include <type_traits>

#include "core/case/case_error.hpp"
#include "core/io/manifest.hpp"
#include "core/io/written_files.hpp"
#include "core/mesh/element.hpp"
#include "core/process/run_error.hpp"
#include "forming/report/cooling/residual_stress.hpp"
#include "forming/report/files/case_copy.hpp"
#include "forming/report/files/history.hpp"
#include "forming/report/files/interface_rows.hpp"
#include "remesh/surface/wall_thickness.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

namespace {

void add_temperature(const Body& body, const Eigen::VectorXd& temperature, core::VtuFields& fields) {
  if (body.thermal)
    fields.nodal.push_back({"temperature_degC", (temperature.array() - thermal::content_reference).matrix()});
}

Eigen::VectorXd viscosity_field(const Scene& scene, const GlassState& glass) {
  return glass.temperature.unaryExpr([&](double temperature) { return scene.glass.flow->viscosity(temperature); });
}

void add_declared_fields(const Scene& scene, const GlassState& glass, core::VtuFields& fields) {
  for_each_glass_field([&](const auto& field) {
    const auto& values = glass.*field.values;
    const bool written = field.needs == Needs::gap_law          ? scene.has_gap_law()
                         : field.output == FieldOutput::celsius ? scene.has_heat()
                                                                : scene.has_flow();
    if (field.output == FieldOutput::none || !written) return;
    const double offset = field.output == FieldOutput::celsius ? thermal::content_reference : 0;
    const double scale = field.output == FieldOutput::millimetre ? 1e3 : 1;
    using Stored = typename std::decay_t<decltype(values)>::value_type;
    const Eigen::Map<const Eigen::Array<Stored, Eigen::Dynamic, 1>> stored(values.data(), Index(values.size()));
    fields.nodal.push_back({field.output_name, (scale * (stored.template cast<double>() - offset)).matrix()});
  });
}

double volume_of(const core::Mesh& mesh, core::Geometry geometry, Index cell) {
  double volume = 0;
  for (const core::TriangleRulePoint& at : core::triangle_rule(4))
    volume += core::map_cell_point(mesh, cell, geometry, at).volume;
  return volume;
}

}  // namespace

Eigen::VectorXd conducted_flux(const core::Mesh& mesh, core::Geometry geometry, const thermal::Material& material,
                               const Eigen::VectorXd& temperature, const Eigen::VectorXd& wall_thickness) {
  Eigen::VectorXd flux = Eigen::VectorXd::Zero(core::dim * mesh.node_count());
  Eigen::VectorXd around = Eigen::VectorXd::Zero(mesh.node_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto& nodes = mesh.cells()[cell];
    const double volume = volume_of(mesh, geometry, cell);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, core::triangle_nodes[k]);
      Point gradient = Point::Zero();
      for (std::size_t i = 0; i < nodes.size(); ++i) gradient += temperature[nodes[i]] * point.gradient[i];
      flux.segment<core::dim>(core::dim * nodes[k]) += volume * gradient;
      around[nodes[k]] += volume;
    }
  }
  for (Index node = 0; node < mesh.node_count(); ++node) {
    const double thin_wall =
        material.radiation ? thermal::thin_wall_factor(*material.radiation, wall_thickness[node]) : 1;
    flux.segment<core::dim>(core::dim * node) *=
        -thermal::conductivity(material, temperature[node], thin_wall) / around[node];
  }
  return flux;
}

core::VtuFields glass_output(const Scene& scene, const State& state) {
  const GlassState& glass = state.glass;
  core::VtuFields fields;
  fields.time = state.time;
  add_declared_fields(scene, glass, fields);
  if (scene.has_flow()) fields.nodal.push_back({"viscosity_Pa_s", viscosity_field(scene, glass)});
  const Eigen::VectorXd wall = remesh::wall_thickness(glass.mesh);
  fields.nodal.push_back({"wall_thickness_mm", 1e3 * wall});
  if (scene.has_heat())
    fields.nodal.push_back(
        {"heat_flux_W_m2", conducted_flux(glass.mesh, scene.geometry, *scene.glass.thermal, glass.temperature, wall)});
  add_stress_fields(scene, glass, fields);
  return fields;
}

core::VtuFields tool_output(const Scene& scene, const State& state, Index tool) {
  const ToolState& body = state.tools[tool];
  const bool active = scene.stages.at(state.stage).uses(tool);
  core::VtuFields fields;
  fields.time = state.time;
  fields.displacement = body.offset * core::axis_direction();
  add_temperature(scene.tools[tool], body.temperature, fields);
  fields.cell.push_back({"active", active ? 1.0 : 0.0});
  return fields;
}

namespace {

namespace fs = std::filesystem;

/// A body's name as part of a file name: glass, then the tools.
std::string body_file(const Scene& scene, std::size_t body) {
  return body == 0 ? "glass" : scene.tools[body - 1].name;
}

/// Refuses a folder that holds something, with the name of a file of the user where there is one.
void make_folder(const std::string& directory) {
  std::error_code error;
  const bool is_there = fs::exists(directory, error), is_folder = fs::is_directory(directory, error);
  if (is_there && !(is_folder && fs::is_empty(directory, error)) && !error) {
    core::require_own(directory);
    throw core::CaseError(fmt::format("{}: {} was found, allowed is a new or an empty folder for the results",
                                      directory, is_folder ? "an earlier result" : "a file"));
  }
  core::claim_folder(directory, "run", {});
  core::claim_folder(directory + "/vtu", "run", {});
}

/// A folder with the files of a run up to `written`; refuses one in which a file was changed that would be written
/// anew.
void require_folder(const Scene& scene, const std::string& directory) {
  std::set<std::string> names{"summary.json",  "thickness.csv",       "contour.csv",
                              "heights.csv",   "history.csv",         "tools.csv",
                              "interface.csv", "residual_stress.csv", "NOT_TRUSTWORTHY.txt"};
  for (std::size_t body = 0; body <= scene.tools.size(); ++body) names.insert(body_file(scene, body) + ".pvd");
  core::claim_folder(directory, "run", names);
}

/// Whether there was such a file.
bool remove_file(const std::string& path) {
  const bool found = fs::exists(path);
  if (found) core::remove_own(path);
  return found;
}

}  // namespace

ResultFiles::ResultFiles(const Scene& scene, const std::string& directory)
    : ResultFiles(scene, (make_folder(directory), directory), WrittenFiles{}) {
  history_.append(history_header(scene));
  tools_.append(tool_header(scene));
  interface_.append(interface_header());
}

ResultFiles::ResultFiles(const Scene& scene, const std::string& directory, const WrittenFiles& written)
    : scene_(scene),
      directory_((require_folder(scene, directory), directory)),
      history_(directory + "/history.csv", written.history_size),
      tools_(directory + "/tools.csv", written.tools_size),
      interface_(directory + "/interface.csv", written.interface_size),
      output_times_(written.output_times),
      synced_(written.output_times.size()) {
  copy_case(scene, directory);
  remove_vtu_files_from(synced_);
  for (std::size_t body = 0; body <= scene.tools.size(); ++body) {
    std::vector<core::PvdCollection::Entry> entries;
    for (std::size_t i = 0; i < synced_; ++i) entries.push_back({output_times_[i], vtu_file(body, i)});
    const std::string path = directory + '/' + body_file(scene, body) + ".pvd";
    collections_.emplace_back(path);
    if (!entries.empty() || fs::exists(path)) collections_.back().set(entries);
  }
}

std::string ResultFiles::vtu_file(std::size_t body, std::size_t output) const {
  return fmt::format("vtu/{}_{:04}.vtu", body_file(scene_, body), output);
}

void ResultFiles::remove_vtu_files_from(std::size_t output) const {
  for (bool found = true; found; ++output) {
    found = false;
    for (std::size_t body = 0; body <= scene_.tools.size(); ++body)
      found = remove_file(directory_ + '/' + vtu_file(body, output)) || found;
  }
}

void ResultFiles::row(const HistoryRow& row, const std::string& tools) {
  history_.append(history_line(row));
  tools_.append(tools);
}

void ResultFiles::fields(const State& state, const std::vector<core::InterfacePoint>& interface) {
  if (!output_times_.empty() && state.time == output_times_.back()) return;
  const auto bodies = static_cast<std::size_t>(body_count(state));
  for (std::size_t body = 0; body < bodies; ++body)
    core::write_vtu(directory_ + '/' + vtu_file(body, output_times_.size()), mesh_of(state, static_cast<Index>(body)),
                    body == 0 ? glass_output(scene_, state) : tool_output(scene_, state, static_cast<Index>(body) - 1));
  for (std::size_t body = 0; body < bodies; ++body)
    collections_[body].add(state.time, vtu_file(body, output_times_.size()));
  interface_.append(interface_lines(scene_, state, interface));
  output_times_.push_back(state.time);
  const bool busy = syncing_.valid() && syncing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  if (busy) return;
  if (syncing_.valid()) syncing_.get();
  start_sync();
}

void ResultFiles::start_sync() {
  if (synced_ == output_times_.size()) return;
  std::vector<std::string> files{directory_ + "/vtu/" + core::manifest_name};
  for (; synced_ < output_times_.size(); ++synced_)
    for (std::size_t body = 0; body <= scene_.tools.size(); ++body)
      files.push_back(directory_ + '/' + vtu_file(body, synced_));
  syncing_ = std::async(std::launch::async, [files] {
    for (const std::string& path : files) core::sync_to_disk(path);
  });
}

WrittenFiles ResultFiles::sync() {
  if (syncing_.valid()) syncing_.get();
  start_sync();
  if (syncing_.valid()) syncing_.get();
  for (const auto* file : {&history_, &tools_, &interface_}) core::sync_to_disk(file->path());
  return {history_.size(), tools_.size(), interface_.size(), output_times_};
}

}  // namespace parison::forming
