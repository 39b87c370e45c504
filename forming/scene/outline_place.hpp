#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <optional>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// A place on the outline of a body, in the body's frame.
struct OutlinePlace {
  Index boundary;      ///< index into its boundaries
  core::Point point;   ///< m
  core::Point normal;  ///< outward unit normal
};

/// The place on the wanted boundaries of a body that is closest to a point; nothing without such a boundary.
std::optional<OutlinePlace> closest_place(const Body& body, const core::Point& point,
                                          const std::function<bool(Index)>& wanted);

/// The same on its contact boundaries.
std::optional<OutlinePlace> closest_contact(const Body& body, const core::Point& point);

}  // namespace parison::forming
