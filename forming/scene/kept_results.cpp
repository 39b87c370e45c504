// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/kept_results.hpp"

#include <filesystem>

#include "core/io/files.hpp"

namespace parison::forming {

std::string kept_results(const std::string& directory, const std::string& named) {
  const std::string name = "results_" + core::fingerprint_text(core::fingerprint(named));
  return (std::filesystem::path(directory) / name).string();
}

}  // namespace parison::forming
