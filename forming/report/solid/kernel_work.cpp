// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/kernel_work.hpp"

#include <fmt/format.h>

#include "core/process/child_work.hpp"
#include "core/process/gmsh_module.hpp"
#include "core/process/run_error.hpp"

namespace parison::forming {

std::string told_by_kernel(const std::string& path, const std::function<void(std::string& told)>& work) {
  core::ChildWork done;
  const auto text = [&] {
    std::string told;
    work(told);
    return told;
  };
  core::in_gmsh_session([&] { done = core::in_child(text, {120, 2'000'000'000}); });
  if (!done.death.empty()) throw core::RunError(fmt::format("{}: the CAD kernel failed: {}", path, done.death));
  return done.text;
}

}  // namespace parison::forming
