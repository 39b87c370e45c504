// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"
#include "core/process/clock.hpp"
#include "core/solid/hex_geometry.hpp"
#include "forming/report/summary.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/report/wall/meridian.hpp"
#include "forming/study/model_variants.hpp"

namespace parison::forming {

namespace {

constexpr const char* noise_group = "noise";
/// The surface of the glass, without symmetry planes, as polylines with the nodes as corners.
std::vector<std::vector<Point>> surface_of(const core::Mesh& mesh) {
  std::vector<std::vector<Point>> lines;
  Index last = -1;
  for (const auto& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    if (edge.nodes[0] != last) lines.push_back({mesh.nodes[edge.nodes[0]]});
    lines.back().push_back(mesh.nodes[edge.nodes[2]]);
    lines.back().push_back(mesh.nodes[edge.nodes[1]]);
    last = edge.nodes[1];
  }
  return lines;
}

double wall_of(const core::Mesh& mesh, core::Geometry geometry) {
  double surface = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) != BoundaryKind::symmetry)
      for (const auto& at : core::edge_rule(2)) surface += core::map_edge_point(mesh, edge.nodes, geometry, at).area;
  return 2 * core::volume(mesh, geometry) / surface;
}

/// Of a container in space.
void add_surface(const SolidState& solid, AuditRun& run) {
  constexpr int rule_points = 3;       // along a face
  constexpr std::size_t places = 201;  // of a meridian
  double surface = 0;
  for (const core::HexFace& face : solid.faces)
    for (const auto& point : core::map_hex_face(core::face_nodes(solid.glass.mesh, face), face, rule_points))
      surface += point.area;
  run.wall = 2 * core::cell_volumes(solid.glass.mesh).sum() / surface;
  for (const EvenMeridian& meridian : even_meridians(solid, solid_wall(solid), places)) {
    run.planes.push_back({{}});
    for (const MeridianPoint& point : meridian.points) run.planes.back().front().emplace_back(point.r, point.z);
  }
}

double distance_to(const std::vector<std::vector<Point>>& lines, const Point& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Point along = line[i] - line[i - 1];
      const double t = std::clamp((x - line[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (line[i - 1] + t * along - x).norm());
    }
  return least;
}

/// Mean distance of a surface's points from another surface, by length.
double mean_distance(const std::vector<std::vector<Point>>& from, const std::vector<std::vector<Point>>& to) {
  double sum = 0, length = 0;
  for (const auto& line : from)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double part = (line[i] - line[i - 1]).norm();
      sum += part * distance_to(to, 0.5 * (line[i] + line[i - 1]));
      length += part;
    }
  return length > 0 ? sum / length : core::none;
}

/// Finds the quantity of interest that changes most, but those that the change shows already.
void find_most_changed(const AuditRun& run, const AuditRun& base, AuditChange& change) {
  for (const Quantity& quantity : base.quantities.values) {
    if (quantity.name == "glass_mean" || quantity.name == "thickness_min_at" || quantity.name.rfind("heat_", 0) == 0)
      continue;
    const Quantity* other = run.quantities.find(quantity.name);
    const double share = other ? std::abs(other->value - quantity.value) / quantity.scale : 1;
    if (!(share > change.most_change)) continue;
    change.most_change = share;
    change.most_changed = quantity.name;
  }
}

}  // namespace

std::string harmless_change(const Scene& scene, int thousandths) {
  constexpr double warmer = 1e-3;  // K
  for (const Tool& tool : scene.tools)
    if (tool.thermal && !tool.start_field)
      return fmt::format("tool.{}.temperature={:.9g} K", tool.name, tool.initial_temperature + thousandths * warmer);
  if (scene.has_heat() && !scene.glass.start_field)
    return fmt::format("glass.temperature={:.9g} K", scene.glass.initial_temperature + thousandths * warmer);
  return fmt::format("numerics.initial_step={:.9g} s", (1 + 1e-3 * thousandths) * scene.accuracy.initial_step);
}

std::vector<Variant> audit_variants(const Scene& scene) {
  std::vector<Variant> variants{
      {"base", "base", scene.accuracy_name, {}, "the case as it is"},
      {"warmer", noise_group, scene.accuracy_name, {harmless_change(scene, 1)}, "a change that means nothing"},
      {"colder", noise_group, scene.accuracy_name, {harmless_change(scene, -1)}, "the same the other way"}};
  for (Variant& part : model_variants(scene)) variants.push_back(std::move(part));
  for (Variant& variant : variants)
    variant.overrides.insert(variant.overrides.begin(), scene.overrides.begin(), scene.overrides.end());
  return variants;
}

bool is_noise(const Variant& variant) {
  return variant.group == noise_group;
}

AuditRun audit_run(const std::string& case_path, const Variant& variant, const StopRequest& stop) {
  const double start = core::thread_cpu_seconds();
  const Scene scene = read_scene(case_path, variant.accuracy, variant.overrides);
  const RunOutcome outcome = run(scene, {}, stop);
  AuditRun result{variant, outcome.facts.completed, outcome.facts.reason, core::thread_cpu_seconds() - start, {}, 0,
                  {}};
  if (!result.completed) return result;
  const State& state = outcome.state;
  result.quantities =
      summarise(scene, state, outcome.facts, thickness_profile(scene, state), outcome.solid.get()).quantities;
  if (outcome.solid) {
    add_surface(*outcome.solid, result);
  } else {
    result.wall = wall_of(state.glass.mesh, scene.geometry);
    result.planes = {surface_of(state.glass.mesh)};
  }
  return result;
}

AuditChange audit_change(const AuditRun& run, const AuditRun& base) {
  AuditChange change{core::none,
                     compare_profiles(run.quantities.profile, base.quantities.profile).mean,
                     heat_difference(run.quantities, base.quantities),
                     core::none,
                     "",
                     0};
  change.shape = 0;
  for (std::size_t p = 0; p < base.planes.size(); ++p) {
    const double both = mean_distance(run.planes[p], base.planes[p]) + mean_distance(base.planes[p], run.planes[p]);
    change.shape += 0.5 * both / double(base.planes.size());
  }
  const Quantity *mean = run.quantities.find("glass_mean"), *known = base.quantities.find("glass_mean");
  if (mean && known) change.mean_temperature = mean->value - known->value;
  find_most_changed(run, base, change);
  return change;
}

}  // namespace parison::forming
