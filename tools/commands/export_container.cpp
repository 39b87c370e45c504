// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/export_container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>

#include "core/case/case_error.hpp"
#include "core/io/json_read.hpp"
#include "core/io/written_files.hpp"
#include "core/math/numbers.hpp"
#include "forming/report/files/case_copy.hpp"
#include "forming/report/solid/shell_stress.hpp"
#include "forming/report/solid/solid_files.hpp"
#include "forming/report/solid/space_files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/scene/scene.hpp"

namespace parison::tools {
namespace {

/// Refuses a name that the program which is to read the file would not take.
void check_name(const char* option, const std::string& path, std::initializer_list<const char*> endings) {
  if (path.empty()) return;
  const std::string ending = std::filesystem::path(path).extension().string();
  if (std::find(endings.begin(), endings.end(), ending) == endings.end())
    throw core::CaseError(
        fmt::format("{}: \"{}\" was found, allowed is a file named {}", option, path, fmt::join(endings, " or ")));
}

void tell(const std::string& path, const std::string& what, double volume, double glass) {
  fmt::print("  {:<28} {:<34}{:>10.3f} cm3  {:+.4f} %\n", path, what, volume / core::millilitre,
             100 * (volume / glass - 1));
}

void tell_shell(const ExportRequest& request, const forming::ShellMesh& shell, double glass) {
  tell(request.shell, fmt::format("{} shells, {} nodes", shell.elements, shell.nodes), shell.volume, glass);
  fmt::print("  the shell has no rim, no bead and no foot: its volume differs from that of the glass by these\n");
  fmt::print("  ready for \"ccx {}\": 1 kN of top load, 1 bar inside, 1 kN between the sides\n",
             std::filesystem::path(request.shell).replace_extension("").string());
}

/// The largest residual tension on each side, as the run has told it; nothing where the glass was not cooled.
void tell_residual(const std::string& results, bool is_in_file) {
  const auto summary = core::read_json_file(results + "/summary.json");
  const core::JsonValue* cooling = summary ? summary->find("cooling") : nullptr;
  if (!cooling) return;
  const auto tension = [&](const char* side) {
    const core::JsonValue* of_side = cooling->find(side);
    return of_side ? of_side->number_of("MPa") : 0;
  };
  fmt::print("  {}, at most {:.2f} MPa outside and {:.2f} MPa inside\n",
             is_in_file ? "step 1 has the tension of cooling alone, the loads have it added"
                        : "to the tension of a load comes that of cooling",
             tension("residual_outer"), tension("residual_inner"));
}

void tell_glass(const std::string& results, double glass) {
  fmt::print("glass of {}: {:.3f} cm3; all files in mm\n", results, glass / core::millilitre);
}

forming::Scene scene_of(const std::string& results, const std::string& checkpoint) {
  const forming::CaseOrigin origin = forming::read_origin(checkpoint);
  return forming::read_scene(forming::case_copy_folder(results), origin.accuracy, origin.overrides);
}

void export_round_shell(const ExportRequest& request, const forming::ContainerShape& shape, double volume) {
  const std::string checkpoint = forming::find_checkpoint(request.results);
  const forming::Scene scene = scene_of(request.results, checkpoint);
  forming::ShellGlass glass = forming::shell_glass(scene);
  const bool has_cooled =
      std::any_of(scene.stages.begin(), scene.stages.end(), [](const auto& one) { return one.cools; });
  if (has_cooled)
    glass.residual = forming::section_stress(forming::read_checkpoint(checkpoint, scene).outcome.state.glass);
  tell_shell(request, forming::write_shell(request.shell, shape, glass), volume);
  tell_residual(request.results, bool(glass.residual));
}

int export_round(const ExportRequest& request) {
  const forming::ContainerShape shape = forming::read_container_shape(request.results);
  const double glass = forming::revolved_volume(shape);
  tell_glass(request.results, glass);
  if (!request.step.empty()) tell(request.step, "solid of revolution", forming::write_step(request.step, shape), glass);
  if (!request.stl.empty()) tell(request.stl, "triangles", forming::write_stl(request.stl, shape), glass);
  if (!request.shell.empty()) export_round_shell(request, shape, glass);
  return 0;
}

/// The glass in space of a finished run is that of its last checkpoint.
int export_space(const ExportRequest& request) {
  const std::string checkpoint = forming::find_checkpoint(request.results);
  const forming::Scene scene = scene_of(request.results, checkpoint);
  const auto solid = forming::read_checkpoint(checkpoint, scene).outcome.solid;
  if (!solid)
    throw core::CaseError(
        fmt::format("{}: a run that has not come into space was found, allowed are later ones", request.results));
  const double glass = forming::whole_volume(*solid);
  tell_glass(request.results, glass);
  if (!request.step.empty()) {
    const forming::SmoothSolid smooth = forming::write_step(request.step, *solid);
    tell(request.step, "solid of smooth surfaces", smooth.volume, glass);
    constexpr double rounding = 1e-9;  // m, of the coordinates
    fmt::print("  its surface is within {:.1g} mm of all nodes of the glass, and within {:.2g} mm between them\n",
               std::max(rounding, smooth.from_nodes) / core::millimetre, smooth.from_faces / core::millimetre);
  }
  if (!request.stl.empty()) tell(request.stl, "triangles", forming::write_stl(request.stl, *solid), glass);
  if (!request.shell.empty()) {
    tell_shell(request, forming::write_shell(request.shell, *solid, forming::shell_glass(scene)), glass);
    tell_residual(request.results, false);
  }
  return 0;
}

}  // namespace

int export_container(const ExportRequest& request) {
  if (request.step.empty() && request.stl.empty() && request.shell.empty())
    throw core::CaseError("export: no file was asked for, allowed are --step FILE, --stl FILE and --shell FILE");
  check_name("--step", request.step, {".step", ".stp"});
  check_name("--stl", request.stl, {".stl"});
  check_name("--shell", request.shell, {".inp"});
  for (const std::string& path : {request.step, request.stl, request.shell}) core::require_own(path);
  const bool is_in_space = std::filesystem::exists(request.results + "/solid/summary.json");
  return is_in_space ? export_space(request) : export_round(request);
}

}  // namespace parison::tools
