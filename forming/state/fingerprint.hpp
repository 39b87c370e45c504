#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include "forming/state/state.hpp"

namespace parison::forming {

/// Hash of a state's every bit.
std::uint64_t fingerprint(const State& state);

}  // namespace parison::forming
