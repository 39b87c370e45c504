#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include "forming/solid/solid_state.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Glass that moves faster than any forming does.
struct FastGlass {
  std::string at;  ///< coordinates, mm
  double speed;    ///< m/s
};
/// The fastest node; none where it is no faster than glass is formed.
std::optional<FastGlass> fast_glass(const State& state);
std::optional<FastGlass> fast_glass(const SolidState& solid);

/// That it falls by its weight alone, or that the air blows up a film, with what to do: sentences.
std::string falls(const FastGlass& glass);
std::string bursts(const FastGlass& glass);

}  // namespace parison::forming
