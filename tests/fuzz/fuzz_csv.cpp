// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_file.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/study/law/law_fit.hpp"
#include "fuzz_input.hpp"

using namespace parison;

/// A table: the points of an outline, and measurements of the contact law.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tests::try_bytes(data, size, "fuzz.csv", [] {
    core::CaseNode place;
    std::vector<std::string> notes;
    const auto node = core::parse_value("[{ name = \"all\", csv = \"fuzz.csv\", condition = \"air\" }]", place);
    tests::require_finite(forming::read_outline(node, tests::fuzz_folder(), notes));
  });
  return tests::try_bytes(data, size, "fuzz.csv", [] {
    for (const auto& row : contact::read_law_data(tests::fuzz_folder() + "/fuzz.csv", [](double) { return 1e3; }))
      if (!std::isfinite(row.pressure + row.viscosity + row.value + row.drive)) std::abort();
  });
}
