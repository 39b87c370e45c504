// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/checkpoint.hpp"
#include "fuzz_input.hpp"

using namespace parison;

/// The checkpoint of a result folder.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return tests::try_bytes(data, size, "checkpoint.h5",
                          [] { forming::read_origin(forming::find_checkpoint(tests::fuzz_folder())); });
}
