#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "tools/new_container/new_container.hpp"

namespace parison::tools {

/// What `parison new` is asked for.
struct NewRequest {
  std::string folder;        ///< whose last name is that of the case
  std::string like = "jar";  ///< a bundled case
  ContainerWish wish = {};   ///< in its place, where it names a process
};

/// Writes a case like a bundled one, or by its process, into a new folder and reads it; returns its file and what was
/// left out of it, a line each.
std::string write_new_case(const NewRequest& request);

/// Does so and prints that.
int new_case(const NewRequest& request);

}  // namespace parison::tools
