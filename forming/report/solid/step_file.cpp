// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdlib>
#include <functional>

#include "core/io/written_files.hpp"
#include "core/process/child_work.hpp"
#include "core/process/gmsh_module.hpp"
#include "core/process/run_error.hpp"
#include "forming/report/solid/solid_files.hpp"
#include "forming/report/solid/step_solid.hpp"

namespace parison::forming {
namespace {

constexpr double cubic_millimetre = 1e-9;

/// The CAD kernel works in a process of its own; the number that it gives, m3.
double volume_from_kernel(const std::string& path, const std::function<void(std::string&)>& work) {
  core::ChildWork done;
  const auto text = [&] {
    std::string volume;
    work(volume);
    return volume;
  };
  core::in_gmsh_session([&] { done = core::in_child(text, {120, 2'000'000'000}); });
  if (!done.death.empty()) throw core::RunError(fmt::format("{}: the CAD kernel failed: {}", path, done.death));
  return cubic_millimetre * std::strtod(done.text.c_str(), nullptr);
}

}  // namespace

double write_step(const std::string& path, const ContainerShape& shape) {
  static auto& write = core::gmsh_function<decltype(parison_write_solid)>("parison_write_solid");
  const double volume =
      volume_from_kernel(path, [&](std::string& text) { write(core::unfinished_name(path), shape, text); });
  if (!(volume > 0)) throw core::RunError(fmt::format("{}: the CAD kernel made no solid of the outline", path));
  core::take_made(path);
  return volume;
}

double volume_of_step(const std::string& path) {
  static auto& read = core::gmsh_function<decltype(parison_read_volume)>("parison_read_volume");
  return volume_from_kernel(path, [&](std::string& text) { read(path, text); });
}

}  // namespace parison::forming
