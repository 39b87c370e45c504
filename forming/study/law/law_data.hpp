#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>
#include <vector>

#include "forming/study/law/law_fit.hpp"

namespace parison::contact {

/// Reads measurements from a CSV file whose headings are names with units as in a case file (`p_kPa`): `p`; `h`, or `q`
/// with `T_glass` and `T_tool`; `eta`, or `T_glass` of which `viscosity` (Pa.s, of K; may be empty) makes it; `t` is
/// read over. Throws CaseError `file:line: column "p": what was found, what is allowed`.
std::vector<LawMeasurement> read_law_data(const std::string& path, const std::function<double(double)>& viscosity);

}  // namespace parison::contact
