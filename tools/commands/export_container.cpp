// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/export_container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>

#include "core/case/case_error.hpp"
#include "core/io/written_files.hpp"
#include "forming/report/solid/solid_files.hpp"

namespace parison::tools {
namespace {

constexpr double cubic_centimetre = 1e-6;

/// Refuses a name that the program which is to read the file would not take.
void check_name(const char* option, const std::string& path, std::initializer_list<const char*> endings) {
  if (path.empty()) return;
  const std::string ending = std::filesystem::path(path).extension().string();
  if (std::find(endings.begin(), endings.end(), ending) == endings.end())
    throw core::CaseError(
        fmt::format("{}: \"{}\" was found, allowed is a file named {}", option, path, fmt::join(endings, " or ")));
}

void tell(const std::string& path, const std::string& what, double volume, double glass) {
  fmt::print("  {:<28} {:<34}{:>10.3f} cm3  {:+.4f} %\n", path, what, volume / cubic_centimetre,
             100 * (volume / glass - 1));
}

}  // namespace

int export_container(const ExportRequest& request) {
  if (request.step.empty() && request.stl.empty() && request.shell.empty())
    throw core::CaseError("export: no file was asked for, allowed are --step FILE, --stl FILE and --shell FILE");
  check_name("--step", request.step, {".step", ".stp"});
  check_name("--stl", request.stl, {".stl"});
  check_name("--shell", request.shell, {".inp"});
  for (const std::string& path : {request.step, request.stl, request.shell}) core::require_own(path);
  const forming::ContainerShape shape = forming::read_container_shape(request.results);
  const double glass = forming::revolved_volume(shape);
  fmt::print("glass of {}: {:.3f} cm3; all files in mm\n", request.results, glass / cubic_centimetre);
  if (!request.step.empty()) tell(request.step, "solid of revolution", forming::write_step(request.step, shape), glass);
  if (!request.stl.empty()) tell(request.stl, "triangles", forming::write_stl(request.stl, shape), glass);
  if (!request.shell.empty()) {
    const forming::ShellMesh shell = forming::write_shell(request.shell, shape);
    tell(request.shell, fmt::format("{} shells S8, S6, {} nodes", shell.elements, shell.nodes), shell.volume, glass);
    fmt::print("  the shell has no rim, no bead and no foot: its volume differs from that of the glass by these\n");
  }
  return 0;
}

}  // namespace parison::tools
