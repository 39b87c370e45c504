// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_file.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "fuzz_input.hpp"

using namespace parison;

/// A DXF drawing, walked from its origin all round or to its other end.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return tests::try_bytes(data, size, "fuzz.dxf", [] {
    core::CaseNode place;
    std::vector<std::string> notes;
    const auto node = core::parse_value("{ file = \"fuzz.dxf\", unit = \"mm\", from = \"(0, 0) mm\" }", place);
    tests::require_finite({forming::read_section(node, tests::fuzz_folder(), notes), {}});
  });
}
