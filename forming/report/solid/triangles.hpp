#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string>

#include "core/solid/hex_mesh.hpp"

namespace parison::forming {

/// Triangles as a binary STL file has them, and the volume they enclose, in the unit of the corners.
class Triangles {
 public:
  /// Its normal is on the side from which a, b, c go against the clock. One without an area is left out.
  void add(const core::Vector3& a, const core::Vector3& b, const core::Vector3& c);
  double volume() const { return volume_; }
  std::string file() const;

 private:
  std::uint32_t count_ = 0;
  std::string bytes_;
  double volume_ = 0;
};

}  // namespace parison::forming
