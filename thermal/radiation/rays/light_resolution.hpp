#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

namespace parison::thermal {

/// Which rays are sent: all, or one of several parts, each ray with so many times the weight. What the parts differ by
/// tells how wrong all rays together are.
struct RayPart {
  int parts = 1, part = 0;

  /// The weight of the ray with a running number: 0 where it is not sent.
  int weight(long ray) const { return ray % parts == part ? parts : 0; }
};

/// How finely light is resolved: by the number of rays that find the exchange in the glass.
struct LightResolution {
  double rays = 2000;
  RayPart part = {};  ///< which of them, and of those between surfaces, are sent

  int zones() const { return scaled(80, 1); }       ///< boxes that have the area of the glass's section
  double end() const { return 0.02 / power(2); }    ///< share of its light that is left where a ray ends
  int patches() const { return scaled(64, 1); }     ///< as many have the length of the open surface in an enclosure
  int view_rays() const { return scaled(256, 2); }  ///< from each of them

 private:
  double power(int exponent) const { return std::pow(rays / 2000, exponent); }
  int scaled(double usual, int exponent) const {
    return std::max(1, static_cast<int>(std::lround(usual * power(exponent))));
  }
};

}  // namespace parison::thermal
