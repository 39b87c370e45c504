#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "remesh/mesher/triangulate.hpp"

namespace parison::remesh {

/// Wanted length of edges at a place, m.
using SizeAt = std::function<double(const core::Point&)>;

/// Triangulates by an algorithm of gmsh; in the module of gmsh.
extern "C" void parison_triangulate(const Outline& outline, const SizeAt& size, int algorithm, Triangulation& result);

}  // namespace parison::remesh
