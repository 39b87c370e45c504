// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/case_error.hpp"
#include "core/vtu.hpp"
#include "forming/history.hpp"
#include "forming/interface_rows.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

/// A body's name as part of a file name.
std::string file_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

void make_folder(const std::string& directory) {
  if (fs::exists(directory) && (!fs::is_directory(directory) || !fs::is_empty(directory)))
    throw core::CaseError(fmt::format(
        "{}: a file or a folder that holds something was found, allowed is a new or an empty folder for the results",
        directory));
  std::error_code error;
  fs::create_directories(fs::path(directory) / "vtu", error);
  if (error)
    throw core::CaseError(fmt::format("{}: the folder for the results cannot be made: {}", directory, error.message()));
}

void add_temperature(const Body& body, const Eigen::VectorXd& temperature, core::VtuFields& fields) {
  if (body.thermal)
    fields.nodal.push_back({"temperature_C", (temperature.array() - thermal::content_reference).matrix()});
}

Eigen::VectorXd viscosity_field(const Scene& scene, const BodyState& glass) {
  return glass.temperature.unaryExpr([&](double temperature) { return scene.glass.flow->viscosity(temperature); });
}

core::VtuFields glass_fields(const Scene& scene, const State& state) {
  const BodyState& glass = state.bodies[0];
  core::VtuFields fields;
  fields.time = state.time;
  add_temperature(scene.glass, glass.temperature, fields);
  if (!scene.has_flow()) return fields;
  if (state.velocity.size() > 0) fields.nodal.push_back({"velocity", state.velocity});
  fields.nodal.push_back({"viscosity_Pa_s", viscosity_field(scene, glass)});
  if (state.contact.tool.empty()) return fields;
  fields.nodal.push_back({"contact_pressure_Pa", state.contact.pressure});
  const Eigen::Map<const Eigen::VectorXi> tool(state.contact.tool.data(), glass.mesh.node_count());
  fields.nodal.push_back({"tool_in_contact", tool.cast<double>()});
  return fields;
}

core::VtuFields tool_fields(const Scene& scene, const State& state, Index tool) {
  const BodyState& body = state.bodies.at(tool + 1);
  const auto& present = scene.stages.at(state.stage).tools;
  const bool in_place = std::any_of(present.begin(), present.end(), [&](const StageTool& t) { return t.tool == tool; });
  core::VtuFields fields;
  fields.time = state.time;
  fields.displacement = body.offset * core::axis_direction();
  add_temperature(scene.tools[tool], body.temperature, fields);
  fields.cell.push_back({"in_place", in_place ? 1.0 : 0.0});
  return fields;
}

}  // namespace

ResultFiles::ResultFiles(const Scene& scene, const std::string& directory) : scene_(scene), directory_(directory) {
  make_folder(directory);
  const fs::path folder(directory);
  history_.exceptions(std::ios::badbit | std::ios::failbit);
  interface_.exceptions(std::ios::badbit | std::ios::failbit);
  history_.open(folder / "history.csv");
  history_ << history_header(scene) << std::flush;
  interface_.open(folder / "interface.csv");
  interface_ << interface_header() << std::flush;
  collections_.emplace_back(folder / "glass.pvd");
  for (const Tool& tool : scene.tools) collections_.emplace_back(folder / (file_name(tool.name) + ".pvd"));
}

void ResultFiles::row(const HistoryRow& row) { history_ << history_line(row) << std::flush; }

void ResultFiles::fields(const State& state, const StepReport& report) {
  if (written_ > 0 && state.time == last_time_) return;
  for (std::size_t body = 0; body < state.bodies.size(); ++body) {
    const std::string name = body == 0 ? "glass" : file_name(scene_.tools[body - 1].name);
    const std::string piece = fmt::format("vtu/{}_{:04}.vtu", name, written_);
    const Index tool = static_cast<Index>(body) - 1;
    core::write_vtu(directory_ + '/' + piece, state.bodies[body].mesh,
                    body == 0 ? glass_fields(scene_, state) : tool_fields(scene_, state, tool));
    collections_[body].add(state.time, piece);
  }
  interface_ << interface_lines(scene_, state, report.interface) << std::flush;
  last_time_ = state.time;
  ++written_;
}

}  // namespace parison::forming
