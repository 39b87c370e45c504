#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

namespace parison::core {

/// Whatever calls gmsh is in a module of its own (parison_gmsh in CMakeLists.txt), which is opened at first need: to
/// load gmsh with the CAD kernel that comes with it takes several times as long as all else of the start of a program.

/// Opens the module where it is not open. Before copies of the process (fork) that will need it, so that each does not
/// open it for itself. Throws RunError where it cannot be opened.
void open_gmsh_module();

/// The address of a function of the module, which is opened where it is not. Throws RunError where it cannot be.
void* address_in_gmsh_module(const char* name);

/// A function of the module, by its C name.
template <typename Function>
Function& gmsh_function(const char* name) {
  return *reinterpret_cast<Function*>(address_in_gmsh_module(name));
}

/// Does work while it has gmsh to itself, in a GmshSession.
void in_gmsh_session(const std::function<void()>& work);

}  // namespace parison::core
