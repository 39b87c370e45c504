// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/io/files.hpp"
#include "core/solid/section_table.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/preset_scales.hpp"
#include "forming/scene/read/read_density.hpp"
#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {

namespace {

using core::CaseTable;

BodyContext read_context(const CaseTable& root, const std::string& directory) {
  constexpr core::Geometry geometries[] = {core::Geometry::axisymmetric, core::Geometry::planar};
  return {directory, geometries[core::choice(root.get("geometry"), {"axisymmetric", "planar"})],
          root.find("material") ? read_materials(*root.find("material")) : std::vector<NamedMaterial>{}};
}

/// Whether open surfaces see each other.
bool read_enclosure(const core::CaseNode& node, const Scene& scene) {
  if (!core::flag(node)) return false;
  using Model = thermal::Radiation::Model;
  if (!scene.has_heat()) core::refuse(node, "true was found, allowed only where the glass carries heat");
  if (const auto& radiation = scene.glass.thermal->radiation;
      radiation && (radiation->model == Model::p1 || radiation->model == Model::p1_cones))
    core::refuse(
        node,
        "true was found with the radiation of the glass by P1, allowed with the models transfer, rosseland and "
        "none");
  if (!(scene.glass.emissivity > 0) && !scene.has_light())
    core::refuse(node, "true was found with a glass that has no emissivity, allowed is a material with one");
  return true;
}

/// How many planes of symmetry there are where they show more images of the bodies than those of one mirror or of two
/// at right angles; 0 otherwise.
std::size_t too_many_mirrors(const Scene& scene) {
  constexpr double same = 1e-6;  // of the size of the glass, and of an angle
  struct Line {
    core::Point at, along;
  };
  std::vector<Line> lines;
  const auto add = [&](const Body& body, double offset) {
    for (const core::Segment& segment : body.profile.segments) {
      if (body.boundaries[segment.boundary_id].kind != BoundaryKind::symmetry) continue;
      const core::Point at = segment.start + offset * core::axis_direction();
      const core::Point along = (segment.end - segment.start).normalized(), normal(-along[1], along[0]);
      if (scene.geometry == core::Geometry::axisymmetric && std::abs(normal[0]) > std::abs(normal[1])) continue;
      const auto is_same = [&](const Line& other) {
        return std::abs(normal.dot(other.along)) < same &&
               std::abs(normal.dot(other.at - at)) < same * core::size(scene.glass.profile);
      };
      if (std::none_of(lines.begin(), lines.end(), is_same)) lines.push_back({at, along});
    }
  };
  add(scene.glass, 0);
  for (const Tool& tool : scene.tools) add(tool, tool.position);
  const bool many = lines.size() > 2 || (lines.size() == 2 && std::abs(lines[0].along.dot(lines[1].along)) > same);
  return many ? lines.size() : 0;
}

/// Surfaces see each other by default where the glass has its light by rays and its mirrors are few.
void settle_enclosure(const core::CaseNode* given, Scene& scene) {
  const std::size_t many = scene.enclosure ? too_many_mirrors(scene) : 0;
  if (many == 0) return;
  if (given)
    core::refuse(*given,
                 fmt::format("true was found with {} planes of symmetry{}, allowed are one, or two at right angles",
                             many, scene.geometry == core::Geometry::planar ? "" : " across the axis"));
  scene.enclosure = false;
}

void read_bodies(const CaseTable& root, BodyContext context, Scene& scene) {
  scene.geometry = context.geometry;
  scene.glass = read_glass(root.get("glass"), context);
  context.with_heat = scene.has_heat();
  context.with_flow = scene.has_flow();
  const auto* enclosure = root.find("enclosure");
  scene.enclosure =
      enclosure ? read_enclosure(*enclosure, scene)
                : scene.has_light() && scene.glass.thermal->radiation->model == thermal::Radiation::Model::transfer;
  context.with_light = scene.has_light() || scene.enclosure || scene.radiation_choice;
  refuse_repeated_names(root.tables("tool"));
  for (const auto* tool : root.tables("tool")) scene.tools.push_back(read_tool(*tool, context));
  settle_enclosure(enclosure, scene);
  for (const auto* node : root.tables("interface"))
    for (auto& interface : read_interfaces(*node, scene)) scene.interfaces.push_back(std::move(interface));
}

void read_stages(const CaseTable& root, Scene& scene) {
  const auto& stages = root.get("stage");
  refuse_repeated_names(root.tables("stage"));
  const CommonAir air{root.find("air"), root.find("inner_air"), root.find("trapped_air")};
  if (air.trapped && !scene.has_flow())
    core::refuse(*air.trapped, "the glass does not flow, this key is allowed only where its material has a viscosity");
  for (const auto* stage : root.tables("stage")) scene.stages.push_back(read_stage(*stage, air, scene));
  if (scene.stages.empty()) core::refuse(stages, "no stage was found, allowed is at least one");
  if (!air.inner) return;
  Stage last = std::move(scene.stages.back());
  scene.stages.pop_back();
  name_inner_side(*air.inner, scene, last);
  refuse_unknown_inner_side(*air.inner, scene, last);
  scene.stages.push_back(std::move(last));
}

/// The case file, what was set, the bundled materials that it uses, and the model of radiation that was chosen.
std::string text_of(const Scene& scene, const std::vector<std::string>& library) {
  std::string text = fmt::format("{}{}", scene.files->front().content, fmt::join(scene.overrides, "\n"));
  for (const auto& name : library) text += library_entry(name);
  if (scene.radiation_choice) text += scene.radiation_choice->model.name;
  return text;
}

/// Digits that change with sections that were measured on a solid.
std::string text_of(const core::MeasuredSections& sections) {
  std::string text;
  const auto add = [&](const core::ReachTable& border) {
    for (const double height : border.heights())
      text += fmt::format("{} {} {}\n", height, border.mean_square(height), border.at(height, M_PI_4).reach);
  };
  add(sections.outer);
  if (sections.inner) add(*sections.inner);
  return text;
}

/// Of the text of the case and of all outlines and sections, which may be in other files.
std::uint64_t fingerprint_of(std::string text, const Scene& scene) {
  const auto add = [&](const Body& body) {
    if (body.start_field) text += start_field_text(*body.start_field, body.profile);
    for (const core::Segment& s : body.profile.segments)
      text += fmt::format("{} {} {} {} {} {}\n", s.end[0], s.end[1], s.centre[0], s.centre[1], s.from, s.to);
  };
  add(scene.glass);
  for (const Tool& tool : scene.tools) {
    add(tool);
    if (tool.section.measured) text += text_of(*tool.section.measured);
  }
  return core::fingerprint(text);
}

}  // namespace

bool Stage::uses(Index tool) const {
  return std::any_of(tools.begin(), tools.end(), [&](const StageTool& one) { return one.tool == tool; });
}

bool Stage::has_driven_tool() const {
  return std::any_of(tools.begin(), tools.end(), [](const StageTool& one) { return one.is_driven(); });
}

bool Stage::blows() const {
  return std::any_of(pressure.begin(), pressure.end(), [](const auto& one) { return one.second.max() > 0; });
}

const Body& body_of(const Scene& scene, Index body) {
  return body == 0 ? static_cast<const Body&>(scene.glass) : scene.tools[body - 1];
}

Index first_use(const Scene& scene, Index tool) {
  const auto uses = [&](const Stage& stage) { return stage.uses(tool); };
  return static_cast<Index>(std::find_if(scene.stages.begin(), scene.stages.end(), uses) - scene.stages.begin());
}

bool has_moved_before(const Scene& scene, Index stage, Index tool) {
  const auto moves = [&](const StageTool& entry) { return entry.tool == tool && entry.moves(); };
  return std::any_of(scene.stages.begin(), scene.stages.begin() + stage,
                     [&](const Stage& one) { return std::any_of(one.tools.begin(), one.tools.end(), moves); });
}

bool is_waiting(const Scene& scene, Index stage, Index tool) {
  return scene.tools[static_cast<std::size_t>(tool)].waits && stage < first_use(scene, tool);
}

bool Scene::has_gap_law() const {
  return std::any_of(interfaces.begin(), interfaces.end(), [](const Interface& interface) {
    return std::holds_alternative<contact::GapConductance>(interface.law);
  });
}

std::vector<bool> contact_boundaries(const Body& body) {
  std::vector<bool> flags;
  for (const auto& boundary : body.boundaries) flags.push_back(boundary.kind == BoundaryKind::contact);
  return flags;
}

std::pair<double, double> contact_range(const Body& body) {
  const auto contact = contact_boundaries(body);
  std::pair<double, double> range{HUGE_VAL, -HUGE_VAL};
  for (const auto& segment : body.profile.segments) {
    if (!contact[segment.boundary_id]) continue;
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double height = core::point_at(segment, t)[1];
      range = {std::min(range.first, height), std::max(range.second, height)};
    }
  }
  return range;
}

std::vector<const Air*> airs_of(const Stage& stage) {
  if (stage.inner_air) return {&stage.air, &*stage.inner_air};
  return {&stage.air};
}

namespace {

/// Calls include(temperature) for what surrounds the bodies in a stage.
template <typename Include>
void include_surroundings(const Stage& stage, bool emits, const Include& include) {
  for (const Air* air : airs_of(stage)) {
    if (air->h.max() > 0) include(air->air_temperature);
    if (emits) include(air->ambient_temperature);
  }
  for (const StageCooling& cooling : stage.cooling)
    if (cooling.h.max() > 0) include(cooling.air_temperature);
}

}  // namespace

TemperatureRange temperature_range(const Scene& scene) {
  TemperatureRange range{scene.glass.initial_temperature, scene.glass.initial_temperature};
  const auto include = [&](const core::TimeFunction& temperature) {
    range = {std::min(range.min_temperature, temperature.min()), std::max(range.max_temperature, temperature.max())};
  };
  const auto include_body = [&](const Body& body) {
    if (!body.thermal) return;
    include(body.initial_temperature);
    if (body.start_field) {
      include(body.start_field->min);
      include(body.start_field->max);
    }
    for (const Boundary& boundary : body.boundaries) {
      if (boundary.kind == BoundaryKind::cooled) include(boundary.cooling.air_temperature);
      if (boundary.kind == BoundaryKind::temperature) include(boundary.temperature);
    }
  };
  include_body(scene.glass);
  if (scene.glass.skin) include(scene.glass.skin->temperature);
  for (const Tool& tool : scene.tools) include_body(tool);
  for (const Stage& stage : scene.stages)
    include_surroundings(stage, scene.glass.emissivity > 0 || scene.has_light(), include);
  return range;
}

std::vector<std::string> tool_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& tool : scene.tools) names.push_back(tool.name);
  return names;
}

Scene read_scene(const std::string& path, const std::string& accuracy, const std::vector<std::string>& overrides) {
  core::ReadRecord record;
  std::vector<std::string> library;
  auto file = read_case(path, overrides, &library);
  auto tolerances = core::take_tolerances(file);
  const auto dimensions = core::read_dimensions(file);
  auto timing = read_timing(file, dimensions);
  const AccuracyChoice accuracy_choice = read_accuracy(accuracy);
  auto radiation_choice = choose_radiation(file, accuracy_choice);
  const CaseTable root(file.root,
                       {"case", "geometry", "material", "glass", "tool", "interface", "air", "inner_air", "trapped_air",
                        "enclosure", "stage", "timing", "probe", "output", "numerics", "dimension"});
  Scene scene;
  scene.dimensions = dimensions;
  scene.tolerances = std::move(tolerances);
  scene.timing = std::move(timing);
  scene.radiation_choice = std::move(radiation_choice);
  scene.name = core::identifier(root.get("case"));
  scene.directory = file.directory;
  scene.file = file.path;
  scene.overrides = file.overrides;
  scene.accuracy_name = accuracy;
  scene.accuracy_choice = accuracy_choice;
  scene.accuracy = accuracy_at(scene.accuracy_choice.level);
  const BodyContext context = read_context(root, file.directory);
  read_bodies(root, context, scene);
  fit_preset_lengths(scene);
  read_stages(root, scene);
  lay_down_gob(root, context, scene);
  refuse_repeated_names(root.tables("probe"));
  for (const auto* probe : root.tables("probe")) scene.probes.push_back(read_probe(*probe, scene));
  if (const auto* output = root.find("output")) scene.output = read_output(*output);
  if (scene.output.interval == 0) scene.output.interval = usual_output_interval(scene);
  if (const auto* numerics = root.find("numerics")) read_numerics(*numerics, scene);
  if (scene.accuracy_choice.coarsening_factor != 1) coarsen(scene, scene.accuracy_choice.coarsening_factor);
  check_sizes(scene, root);
  if (auto plan = plan_container(scene)) scene.container = std::make_shared<const ContainerPlan>(*std::move(plan));
  check_gob(scene, root.get("glass"));
  check_density(scene, root.get("glass"));
  check_no_overlap(scene, root.tables("tool"));
  check_interfaces(scene, root.tables("stage"));
  check_support(scene, root);
  check_standing(scene, root);
  check_motions(scene, root.tables("stage"));
  check_solid(scene, root);
  scene.files = std::make_shared<const std::vector<core::ReadFile>>(std::move(record.files));
  scene.fingerprint = fingerprint_of(text_of(scene, library), scene);
  return scene;
}

namespace {

void coarsen(MeshSpec& mesh, double factor) {
  if (mesh.size) *mesh.size *= factor;
  if (mesh.contact_size) *mesh.contact_size *= factor;
  if (!mesh.mapped) return;
  for (Index* divisions : {&mesh.mapped->along_first, &mesh.mapped->along_second})
    *divisions = std::max(Index{1}, static_cast<Index>(std::lround(*divisions / factor)));
}

}  // namespace

void coarsen(Scene& scene, double factor) {
  scene.accuracy = coarsened(scene.accuracy, factor);
  coarsen(scene.glass.mesh, factor);
  for (Tool& tool : scene.tools) coarsen(tool.mesh, factor);
}

}  // namespace parison::forming
