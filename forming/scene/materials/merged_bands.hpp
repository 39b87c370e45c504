#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "thermal/properties.hpp"

namespace parison::forming {

/// Bands made one that ends where the last of them does; it absorbs, 1/m, what they do in the mean over their emission
/// at a temperature, K.
thermal::Band merged_bands(const std::vector<thermal::Band>& bands, double temperature);

}  // namespace parison::forming
