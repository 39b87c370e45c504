#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>

#include "forming/study/search/goal.hpp"

namespace parison::forming {

/// Reads a goal file; `find_case` says where the case is that it names, from its folder. Throws core::CaseError with
/// file, line and key where it is wrong, where it names what the case does not have, or where no run can reach it.
Goal read_goal(const std::string& path,
               const std::function<std::string(const std::string& directory, const std::string& given)>& find_case);

}  // namespace parison::forming
