#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::forming {

/// The folder beside a copy of a case that holds what the copy needs of the results that its text, or an assignment,
/// names: the copy then reads back wherever those results go.
std::string kept_results(const std::string& directory, const std::string& named);

}  // namespace parison::forming
