#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>

namespace parison::forming {

inline constexpr double cubic_millimetre = 1e-9;  ///< m3

/// What work with the CAD kernel tells. It is done in a process of its own, in a session of gmsh. Throws
/// core::RunError, which begins with `path`, where that process dies.
std::string told_by_kernel(const std::string& path, const std::function<void(std::string& told)>& work);

}  // namespace parison::forming
