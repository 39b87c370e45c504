#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

/// What `parison new` is asked for.
struct NewRequest {
  std::string folder;        ///< whose last name is that of the case
  std::string like = "jar";  ///< a bundled case
};

/// Writes such a case into a new folder and reads it; returns its file and what was left out of it, a line each.
std::string write_new_case(const NewRequest& request);

/// Writes a case like a bundled one into a new folder, with its gob given by mass where it is a capsule.
int new_case(const NewRequest& request);

}  // namespace parison::tools
