// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/camera/camera.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/case/case_error.hpp"
#include "core/case/units.hpp"
#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "core/math/numbers.hpp"
#include "core/mesh/mesh.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "thermal/radiation/camera/line_of_sight.hpp"
#include "tools/report/data/result_folder.hpp"
#include "tools/report/data/scene_text.hpp"
#include "tools/report/film/vtu_file.hpp"

namespace parison::tools {

namespace {

/// The glass at an output of a run.
struct HotSection {
  double time;  ///< s
  core::Mesh mesh;
  Eigen::VectorXd temperature;  ///< K
};

constexpr int corners_of_cell = 3;

/// The mesh of a file, its nodes renumbered with the corners first; `node` becomes the file's number of each.
core::Mesh mesh_of(const VtuFile& file, std::vector<std::size_t>& node) {
  const auto place = [&](std::size_t n) {
    return core::Point(core::millimetre * file.points[n][0], core::millimetre * file.points[n][1]);
  };
  std::map<std::size_t, core::Index> corner;
  std::vector<core::Point> vertices;
  std::vector<std::array<core::Index, 3>> triangles(file.cells.size() / nodes_of_cell);
  for (std::size_t c = 0; c < triangles.size(); ++c)
    for (int k = 0; k < corners_of_cell; ++k) {
      const std::size_t n = file.cells[nodes_of_cell * c + k];
      const auto [at, is_new] = corner.try_emplace(n, static_cast<core::Index>(vertices.size()));
      if (is_new) vertices.push_back(place(n));
      triangles[c][k] = at->second;
    }
  core::Mesh mesh = core::make_quadratic_mesh(vertices, triangles);
  node.resize(mesh.nodes.size());
  for (std::size_t c = 0; c < triangles.size(); ++c)
    for (int k = 0; k < nodes_of_cell; ++k) node[mesh.cells()[c][k]] = file.cells[nodes_of_cell * c + k];
  for (std::size_t n = 0; n < node.size(); ++n) mesh.nodes[n] = place(node[n]);
  return mesh;
}

/// Reads the output of a result folder that is nearest to a time, s, the last one without a time. Throws
/// core::CaseError where there is none, or where the glass carries no heat.
HotSection read_hot_section(const std::string& folder, std::optional<double> time) {
  const auto entries = read_pvd(folder + "/glass.pvd");
  if (entries.empty())
    throw core::CaseError(
        fmt::format("{}: no glass.pvd with outputs was found, allowed is the folder of a run", folder));
  const double wanted = time.value_or(entries.back().time);
  const auto nearest = std::min_element(entries.begin(), entries.end(), [&](const PvdEntry& a, const PvdEntry& b) {
    return std::abs(a.time - wanted) < std::abs(b.time - wanted);
  });
  const VtuFile file = read_vtu(nearest->path);
  const auto field = file.nodal.find("temperature_degC");
  if (field == file.nodal.end())
    throw core::CaseError(
        fmt::format("{}: the glass has no temperatures, allowed is a run of glass that carries heat", folder));
  std::vector<std::size_t> node;
  HotSection section{nearest->time, mesh_of(file, node), {}};
  section.temperature.resize(section.mesh.node_count());
  for (std::size_t n = 0; n < node.size(); ++n)
    section.temperature[static_cast<core::Index>(n)] = field->second[node[n]] + core::zero_celsius;
  return section;
}

using thermal::CameraBand;
using thermal::LineOfSight;

constexpr double micrometre = 1e-6;
constexpr std::size_t most_pixels = 400000;
constexpr double shortest_wave = 0.3e-6, longest_wave = 50e-6;  // m: what thermal cameras see, with a margin

double read(const char* option, const std::string& text, const core::Dimension& dimension) {
  const auto parsed = core::parse_quantity(text, dimension);
  if (!parsed.problem.empty()) throw core::CaseError(fmt::format("{}: {}", option, parsed.problem));
  return parsed.value;
}

std::vector<CameraBand> bands_of(const CameraRequest& request) {
  if (request.bands.empty()) return {{3e-6, 5e-6}, {0.9e-6, 1.1e-6}};
  std::vector<CameraBand> bands;
  for (std::size_t i = 0; i + 1 < request.bands.size(); i += 2) {
    const CameraBand band{read("--band", request.bands[i], core::dimension::length),
                          read("--band", request.bands[i + 1], core::dimension::length)};
    if (!(band.from >= shortest_wave && band.to > band.from && band.to <= longest_wave))
      throw core::CaseError(
          fmt::format("--band: \"{}\" to \"{}\" was found, allowed are wavelengths that rise, from 0.3 um to 50 um",
                      request.bands[i], request.bands[i + 1]));
    bands.push_back(band);
  }
  return bands;
}

std::string name_of(const CameraBand& band) {
  return fmt::format("{:g} to {:g} um", band.from / micrometre, band.to / micrometre);
}

/// The stage that a run was in at a time, as an index into the scene's.
std::size_t stage_at(const forming::Scene& scene, const std::string& results, double time) {
  std::string name = scene.stages.front().name;
  for (const StageSpan& span : read_folder(results).stages)
    if (time > span.start + 1e-9) name = span.name;
  const auto named = [&](const forming::Stage& stage) { return stage.name == name; };
  const auto found = std::find_if(scene.stages.begin(), scene.stages.end(), named);
  return found == scene.stages.end() ? 0 : static_cast<std::size_t>(found - scene.stages.begin());
}

/// Pixels over the right half of what is seen, from the axis outwards, in rows from the lowest up.
struct Raster {
  double pixel, low;  ///< m; height of the lowest row's middle
  std::size_t columns, rows;

  thermal::Ray line(std::size_t column, std::size_t row, double away) const {
    return {{away, (static_cast<double>(column) + 0.5) * pixel, low + static_cast<double>(row) * pixel}, {-1, 0, 0}};
  }
};

Raster raster_of(const core::Mesh& mesh, double pixel) {
  double radius = 0, low = std::numeric_limits<double>::infinity(), high = -low;
  for (const core::Point& x : mesh.nodes) {
    radius = std::max(radius, x[0]);
    low = std::min(low, x[1]);
    high = std::max(high, x[1]);
  }
  const double columns = std::ceil(radius / pixel), rows = std::floor((high - low) / pixel);
  if (!(rows >= 1) || columns * rows > most_pixels)
    throw core::CaseError(fmt::format("--pixel: {:g} mm was found, allowed are 1 to {} pixels on half of the container",
                                      pixel / core::millimetre, most_pixels));
  return {pixel, low + 0.5 * (high - low - (rows - 1) * pixel), static_cast<std::size_t>(columns),
          static_cast<std::size_t>(rows)};
}

InfraredImage image_of(const LineOfSight& view, const Raster& raster, const std::string& title, bool upright) {
  InfraredImage image{title, raster.pixel / core::millimetre, raster.low / core::millimetre, {}, upright};
  const double away = 10 * raster.pixel * static_cast<double>(raster.columns + raster.rows);
  for (std::size_t row = 0; row < raster.rows; ++row) {
    auto& values = image.rows.emplace_back();
    for (std::size_t column = 0; column < raster.columns; ++column) {
      const thermal::Ray ray = raster.line(column, row, away);
      values.push_back(view.meets(ray) ? view.apparent_temperature(view.radiance(ray)) - core::zero_celsius
                                       : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return image;
}

/// The line along the axis of each image, beside the temperature of the surface that it meets first.
std::string profile_text(const std::vector<InfraredImage>& images, const LineOfSight& view, const Raster& raster) {
  std::string text = "z_mm,surface_degC";
  for (const InfraredImage& image : images) {
    std::string name = image.title;
    std::replace(name.begin(), name.end(), ' ', '_');
    text += fmt::format(",apparent_{}_degC", name);
  }
  text += "\n";
  const double away = 10 * raster.pixel * static_cast<double>(raster.columns + raster.rows);
  for (std::size_t row = 0; row < raster.rows; ++row) {
    const double surface = view.surface_temperature(raster.line(0, row, away)) - core::zero_celsius;
    text += fmt::format("{:.4g},{:.6g}", images[0].low + images[0].pixel * static_cast<double>(row), surface);
    for (const InfraredImage& image : images) text += fmt::format(",{:.6g}", image.rows[row][0]);
    text += "\n";
  }
  return text;
}

void tell(const InfraredImage& image) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& row : image.rows)
    if (!std::isnan(row[0])) {
      low = std::min(low, row[0]);
      high = std::max(high, row[0]);
    }
  fmt::print("  {:<20} apparent {:.0f} to {:.0f} degC along the axis\n", image.title, low, high);
}

}  // namespace

int camera(const CameraRequest& request) {
  const auto bands = bands_of(request);
  std::optional<double> time;
  if (!request.time.empty()) time = read("--time", request.time, core::dimension::time);
  const double pixel = read("--pixel", request.pixel, core::dimension::length);
  const SceneOfRun of = read_scene_of(request.results);
  if (!of.scene) throw core::CaseError(of.problem);
  if (of.scene->geometry != core::Geometry::axisymmetric || !of.scene->has_heat())
    throw core::CaseError(
        fmt::format("{}: a camera needs a round container that carries heat, allowed are axisymmetric cases with heat",
                    request.results));
  const HotSection hot = read_hot_section(request.results, time);
  const std::size_t stage = stage_at(*of.scene, request.results, hot.time);
  const double surroundings = request.surroundings.empty()
                                  ? of.scene->stages[stage].air.ambient_temperature(0)
                                  : read("--surroundings", request.surroundings, core::dimension::temperature);
  const thermal::Optics optics = thermal::optics_of(*of.scene->glass.thermal);
  const Raster raster = raster_of(hot.mesh, pixel);
  std::vector<InfraredImage> images;
  std::string profile;
  const std::string name = request.output.empty() ? request.results + "/camera" : request.output;
  for (const char* ending : {".csv", ".svg"}) core::require_own(name + ending);
  fmt::print("{} at {:.4g} s, surroundings {:.0f} degC\n", request.results, hot.time,
             surroundings - core::zero_celsius);
  for (const CameraBand& band : bands) {
    const LineOfSight view(hot.mesh, core::Geometry::axisymmetric, hot.temperature, optics, band, surroundings);
    images.push_back(image_of(view, raster, name_of(band), forming::is_upright(*of.scene, stage)));
    tell(images.back());
    if (images.size() == bands.size()) profile = profile_text(images, view, raster);
  }
  core::replace_file(name + ".csv", profile);
  core::replace_file(name + ".svg",
                     infrared_picture(images, fmt::format("apparent temperature at {:.4g} s", hot.time)));
  fmt::print("written: {0}.csv, {0}.svg\n", name);
  return 0;
}

}  // namespace parison::tools
