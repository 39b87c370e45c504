#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::forming {

inline Scene bundled(const std::string& name, const std::string& accuracy,
                     const std::vector<std::string>& overrides = {}) {
  return read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/" + name, accuracy, overrides);
}

}  // namespace parison::forming
