// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/materials/merged_bands.hpp"

#include "thermal/radiation/planck.hpp"

namespace parison::forming {

thermal::Band merged_bands(const std::vector<thermal::Band>& bands, double temperature) {
  double emitted = 0, absorbed = 0, from = 0;
  for (const thermal::Band& band : bands) {
    const double power = thermal::emission_between(from, band.up_to, temperature).value;
    emitted += power;
    absorbed += power * band.absorption * (band.relative.x.empty() ? 1 : band.relative(temperature));
    from = band.up_to;
  }
  return {from, absorbed / emitted};
}

}  // namespace parison::forming
