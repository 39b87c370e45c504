// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/files/solid_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/io/json.hpp"
#include "core/io/written_files.hpp"
#include "forming/report/wall/meridian.hpp"
#include "forming/report/wall/solid_picture.hpp"
#include "forming/solid/solid_memory.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

namespace {

constexpr const char* folder_name = "/solid";

double celsius(double kelvin) {
  return kelvin - thermal::content_reference;
}

std::vector<std::string> body_names(const Scene& scene, const SolidState& solid) {
  std::vector<std::string> names{"glass"};
  for (const SolidTool& tool : solid.tools) names.push_back(scene.tools[tool.tool].name);
  return names;
}

/// Makes the folder, without the fields of an earlier run but for the first `kept`.
std::string own_folder(const std::string& result, const std::vector<std::string>& bodies, std::size_t kept) {
  const std::string directory = result + folder_name;
  core::claim_folder(directory, "run", {"history.csv", "wall.csv", "meridians.csv", "wall.svg", "summary.json"});
  for (const std::string& body : bodies)
    for (std::size_t output = kept;; ++output) {
      const std::string path = fmt::format("{}/{}_{:04}.vtu", directory, body, output);
      if (!std::filesystem::exists(path)) break;
      core::remove_own(path);
    }
  return directory;
}

/// What touches at each node of the glass: the share of the points around it, and their mean pressure, Pa.
struct NodalContact {
  Eigen::VectorXd share, pressure;
};
NodalContact nodal_contact(const SolidState& solid) {
  const Index nodes = solid.glass.mesh.node_count();
  NodalContact contact{Eigen::VectorXd::Zero(nodes), Eigen::VectorXd::Zero(nodes)};
  if (solid.glass.contact.empty()) return contact;
  Eigen::VectorXd around = Eigen::VectorXd::Zero(nodes);
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    double touching = 0, pressure = 0;
    for (std::size_t p = 0; p < flow::contact_points_per_face; ++p) {
      const flow::SolidContact& point = solid.glass.contact[f * flow::contact_points_per_face + p];
      touching += point.touches;
      pressure += point.touches ? point.pressure : 0;
    }
    for (const Index node : solid.heat_faces[f].nodes) {
      around[node] += flow::contact_points_per_face;
      contact.share[node] += touching;
      contact.pressure[node] += pressure;
    }
  }
  for (Index n = 0; n < nodes; ++n)
    if (around[n] > 0) contact.share[n] /= around[n], contact.pressure[n] /= around[n];
  return contact;
}

core::VtuFields glass_fields_of(const State& clock, const SolidState& solid) {
  core::VtuFields fields;
  fields.time = clock.time;
  fields.nodal.push_back({"temperature_degC", (solid.glass.temperature.array() - thermal::content_reference).matrix()});
  Eigen::VectorXd wall = Eigen::VectorXd::Zero(solid.glass.mesh.node_count());
  for (const SolidWallPoint& point : solid_wall(solid).points) wall[point.outer] = 1e3 * point.thickness;
  for (const auto& column : solid.columns)
    for (const Index node : column) wall[node] = wall[column.back()];
  fields.nodal.push_back({"wall_thickness_mm", wall});
  if (solid.glass.velocity.size() > 0) fields.nodal.push_back({"velocity_mm_s", 1e3 * solid.glass.velocity});
  const NodalContact contact = nodal_contact(solid);
  fields.nodal.push_back({"share_in_contact", contact.share});
  fields.nodal.push_back({"contact_pressure_Pa", contact.pressure});
  if (remembers(solid)) {
    const NodalTensors stress = nodal_stress(solid);
    Eigen::VectorXd principal(stress.cols());
    for (Index n = 0; n < stress.cols(); ++n) principal[n] = 1e-6 * largest_principal(stress.col(n));
    fields.nodal.push_back({"stress_principal_MPa", principal});
  }
  return fields;
}

/// What light meets at open surfaces in space.
std::string surroundings_text(const Scene& scene) {
  return scene.enclosure ? "inside themselves and through the mouth the ambient temperature, outside it alone"
                         : "the ambient temperature";
}

}  // namespace

SolidFiles::SolidFiles(const Scene& scene, const std::string& result, const SolidState& solid,
                       const WrittenFiles& written)
    : scene_(scene),
      directory_(own_folder(result, body_names(scene, solid), written.solid_output_times.size())),
      names_(body_names(scene, solid)),
      history_(directory_ + "/history.csv", written.solid_history_size),
      output_times_(written.solid_output_times) {
  for (std::size_t body = 0; body < names_.size(); ++body) {
    std::vector<core::PvdCollection::Entry> entries;
    for (std::size_t output = 0; output < output_times_.size(); ++output)
      entries.push_back({output_times_[output], file(body, output)});
    collections_.emplace_back(directory_ + '/' + names_[body] + ".pvd");
    collections_.back().set(entries);
  }
  if (history_.size() > 0) return;
  history_.append(
      "time_s,stage,dt_s,steps,glass_mean_degC,glass_min_degC,glass_max_degC,largest_volume_error,heat_to_tools_J,heat_"
      "to_"
      "air_J\n");
}

std::string SolidFiles::file(std::size_t body, std::size_t output) const {
  return fmt::format("{}_{:04}.vtu", names_[body], output);
}

void SolidFiles::row(const State& clock, const SolidState& solid) {
  const double mean = mean_temperature(solid);
  history_.append(fmt::format("{:.12g},{},{:.6g},{},{:.3f},{:.3f},{:.3f},{:.3g},{:.8g},{:.8g}\n", clock.time,
                              scene_.stages[clock.stage].name, solid.last_step, solid.totals.steps, celsius(mean),
                              celsius(solid.glass.temperature.minCoeff()), celsius(solid.glass.temperature.maxCoeff()),
                              solid.totals.volume_error, solid.totals.to_tools / solid.share,
                              solid.totals.to_air / solid.share));
}

void SolidFiles::fields(const State& clock, const SolidState& solid) {
  if (!output_times_.empty() && clock.time == output_times_.back()) return;
  const std::size_t output = output_times_.size();
  core::write_vtu(directory_ + '/' + file(0, output), solid.glass.mesh, glass_fields_of(clock, solid));
  for (std::size_t t = 0; t < solid.tools.size(); ++t) {
    const SolidTool& tool = solid.tools[t];
    core::VtuFields fields;
    fields.time = clock.time;
    fields.displacement = clock.tools[tool.tool].offset * core::axis_direction();
    fields.nodal.push_back({"temperature_degC", (tool.temperature.array() - thermal::content_reference).matrix()});
    core::write_vtu(directory_ + '/' + file(1 + t, output), tool.mesh, fields);
  }
  for (std::size_t body = 0; body < names_.size(); ++body) collections_[body].add(clock.time, file(body, output));
  output_times_.push_back(clock.time);
}

void SolidFiles::note(WrittenFiles& written) const {
  for (std::size_t body = 0; body < names_.size(); ++body)
    for (std::size_t output = 0; output < output_times_.size(); ++output)
      core::sync_to_disk(directory_ + '/' + file(body, output));
  core::sync_to_disk(history_.path());
  written.solid_history_size = history_.size();
  written.solid_output_times = output_times_;
}

void write_solid_summary(const Scene& scene, const std::string& result, const SolidState& solid,
                         const SolidWall& wall) {
  const std::string directory = result + folder_name;
  core::replace_file(directory + "/wall.csv", solid_wall_csv(wall));
  core::replace_file(directory + "/meridians.csv", meridians_csv(solid, wall));
  core::replace_file(directory + "/wall.svg", solid_picture(scene, solid, wall));
  core::JsonWriter json;
  json.add("case", scene.name);
  json.add("sector_deg", scene.solid->sector * 180 / M_PI);
  json.add("cells", static_cast<long>(solid.glass.mesh.cell_count()));
  json.add("steps", static_cast<long>(solid.totals.steps));
  json.add("rejected_steps", static_cast<long>(solid.totals.rejected));
  json.add("factorisations", static_cast<long>(solid.totals.factors));
  json.add("glass_mass_kg", solid.point_mass.sum() / solid.share);
  const auto place = [&](const char* name, const SolidWallPoint& point) {
    json.open_object(name);
    json.add("thickness_mm", 1e3 * point.thickness);
    for (const auto& [key, axis] : {std::pair{"x_mm", 0}, {"y_mm", 1}, {"z_mm", 2}})
      json.add(key, 1e3 * point.at[axis]);
    json.close();
  };
  place("thinnest", wall.points[wall.thinnest]);
  place("thickest", wall.points[wall.thickest]);
  json.add("mean_thickness_mm", 1e3 * wall.mean);
  json.add("capacity_ml", 1e6 * wall.capacity);
  json.add("outer_within_0.2mm_of_tools", wall.near_tools);
  json.add("largest_volume_error", solid.totals.volume_error);
  json.add("heat_to_tools_J", solid.totals.to_tools / solid.share);
  json.add("heat_to_air_J", solid.totals.to_air / solid.share);
  if (scene.has_light()) {
    json.add("light_model", "bands through the wall");
    json.add("open_surfaces_see", surroundings_text(scene));
    json.add("light_to_tools_J", solid.totals.light_to_tools / solid.share);
    json.add("light_to_air_J", solid.totals.light_to_air / solid.share);
  }
  json.add("heat_imbalance", solid.totals.heat_imbalance / std::abs(solid.totals.start_heat));
  json.open_object("tools");
  for (const SolidTool& tool : solid.tools) {
    json.open_object(scene.tools[tool.tool].name);
    json.add("heat_received_J", tool.heat_received / solid.share);
    json.add("temperature_max_degC", celsius(tool.temperature.maxCoeff()));
    json.close();
  }
  json.close();
  core::replace_file(directory + "/summary.json", json.finish());
}

std::string solid_table(const Scene& scene, const SolidState& solid, const SolidWall& wall) {
  const auto place = [&](std::size_t point) {
    const SolidWallPoint& at = wall.points[point];
    return fmt::format("{:.2f} mm at x {:.1f}, y {:.1f}, z {:.1f} mm", 1e3 * at.thickness, 1e3 * at.at[0],
                       1e3 * at.at[1], 1e3 * at.at[2]);
  };
  std::string text = fmt::format("  the glass in space, a sector of {:.0f} deg\n", scene.solid->sector * 180 / M_PI);
  text += fmt::format("  {:<22}{} cells, {} steps, {} rejected\n", "mesh", solid.glass.mesh.cell_count(),
                      solid.totals.steps, solid.totals.rejected);
  text += fmt::format("  {:<22}{}\n", "thinnest", place(wall.thinnest));
  text += fmt::format("  {:<22}{}\n", "thickest", place(wall.thickest));
  text += fmt::format("  {:<22}{:.4g} kJ to tools, {:.3g} kJ to air\n", "heat",
                      1e-3 * solid.totals.to_tools / solid.share, 1e-3 * solid.totals.to_air / solid.share);
  if (scene.has_light()) {
    text +=
        fmt::format("  {:<22}{:.4g} kJ to tools, {:.3g} kJ to air\n", "of it light",
                    1e-3 * solid.totals.light_to_tools / solid.share, 1e-3 * solid.totals.light_to_air / solid.share);
    text += fmt::format("  {:<22}in bands through the wall, none along it; before it was by {}\n", "light in the glass",
                        model_name(scene.glass.thermal->radiation));
    text += fmt::format("  {:<22}{}\n", "open surfaces see", surroundings_text(scene));
  }
  return text;
}

}  // namespace parison::forming
