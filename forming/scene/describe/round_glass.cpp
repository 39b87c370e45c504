// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/round_glass.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/case/case_error.hpp"

namespace parison::forming {

void require_round_glass(const Scene& scene, const char* question) {
  if (!scene.solid) return;
  throw core::CaseError(
      fmt::format("{}: the glass is a body in space from stage \"{}\" on, allowed for {} are cases "
                  "whose glass stays round",
                  scene.file, scene.stages[scene.solid->from_stage].name, question));
}

bool is_in_space(const std::string& directory) {
  return std::filesystem::exists(directory + "/solid/summary.json");
}

}  // namespace parison::forming
