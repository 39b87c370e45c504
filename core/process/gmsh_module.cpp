// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/gmsh_module.hpp"

#include <dlfcn.h>

#include <string>

#include "core/process/gmsh_session.hpp"
#include "core/process/run_error.hpp"

namespace parison::core {
namespace {

constexpr const char* file = "libparison_gmsh.so";  // found by the run path of the program or library that asks

/// Whether memory comes from the C library: not where another allocator or a sanitizer is loaded in front of it.
bool memory_is_of_c_library() {
  void* const c_library = dlopen("libc.so.6", RTLD_LAZY | RTLD_NOLOAD);
  if (!c_library) return false;
  const bool same = dlsym(c_library, "malloc") == dlsym(RTLD_DEFAULT, "malloc");
  dlclose(c_library);
  return same;
}

/// The module, which stays open. Its libraries look for their symbols among themselves first and then in the program,
/// where a hundred thousand of them would be sought in vain: that halves the start of a program. Not with an allocator
/// of its own, which they would pass by.
void* gmsh_module() {
  static void* const handle = [] {
    void* const opened = dlopen(file, RTLD_LAZY | RTLD_LOCAL | (memory_is_of_c_library() ? RTLD_DEEPBIND : 0));
    if (!opened) throw RunError(std::string("the mesher cannot be loaded: ") + dlerror());
    return opened;
  }();
  return handle;
}

}  // namespace

void open_gmsh_module() {
  gmsh_module();
}

void* address_in_gmsh_module(const char* name) {
  void* const address = dlsym(gmsh_module(), name);
  if (!address) throw RunError(std::string("the mesher is not the one of this program: ") + dlerror());
  return address;
}

void in_gmsh_session(const std::function<void()>& work) {
  static auto& session = gmsh_function<decltype(parison_in_gmsh_session)>("parison_in_gmsh_session");
  session(work);
}

}  // namespace parison::core
