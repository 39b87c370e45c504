// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/fingerprint.hpp"

#include <string>
#include <type_traits>

#include "core/io/files.hpp"
#include "forming/state/visit_state.hpp"

namespace parison::forming {
namespace {

/// Every bit of what it visits, in order.
struct Bits {
  std::string& bits;
  void add(const void* data, std::size_t size) { bits.append(static_cast<const char*>(data), size); }
  template <typename Value>
  std::enable_if_t<std::is_arithmetic_v<Value>> operator()(const char*, const Value& value) {
    add(&value, sizeof value);
  }
  template <typename Value>
  std::enable_if_t<!std::is_arithmetic_v<Value>> operator()(const char*, const Value& values) {
    add(values.data(), static_cast<std::size_t>(values.size()) * sizeof *values.data());
  }
  void operator()(const char*, const core::Mesh& mesh) {
    (*this)("nodes", mesh.nodes);
    (*this)("cells", mesh.cells());
    (*this)("boundary", mesh.boundary_edges());
    for (const core::MeshBoundary& boundary : mesh.boundaries()) {
      (*this)("boundary", boundary.name);
      (*this)("kind", static_cast<int>(boundary.kind));
    }
  }
  Bits part(const std::string&) { return *this; }
};

}  // namespace

std::uint64_t fingerprint(const State& state) {
  std::string bits;
  visit_state(Bits{bits}, state);
  return core::fingerprint(bits);
}

}  // namespace parison::forming
