// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "fuzz_input.hpp"

using namespace parison;

/// A case file.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return tests::try_bytes(data, size, "case.toml", [] {
    const forming::Scene scene = forming::read_scene(tests::fuzz_folder(), "draft");
    tests::require_finite(scene.glass.profile);
    for (const forming::Tool& tool : scene.tools) tests::require_finite(tool.profile);
  });
}
