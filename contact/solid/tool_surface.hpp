#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/hex_mesh.hpp"

namespace parison::contact {

/// How far a point is from the surface of a tool.
struct SurfaceGap {
  double distance;       ///< m, negative inside the tool
  core::Vector3 normal;  ///< unit, from the tool into the cavity
};

/// The surface of a tool as glass in space meets it. Threads may ask at the same time.
class ToolSurface {
 public:
  ToolSurface() = default;
  ToolSurface(const ToolSurface&) = delete;
  ToolSurface& operator=(const ToolSurface&) = delete;
  virtual ~ToolSurface() = default;
  virtual SurfaceGap gap(const core::Vector3& at) const = 0;
};

}  // namespace parison::contact
