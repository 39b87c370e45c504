#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// What the CAD kernel does with a container, in the module of gmsh and in the session that is open; private to this
// folder.
#include <string>

#include "forming/report/solid/container_shape.hpp"

namespace parison::forming {

/// Writes the solid and gives its volume as a text, mm3.
extern "C" void parison_write_solid(const std::string& path, const ContainerShape& shape, std::string& volume_text);

}  // namespace parison::forming
