#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::forming {

/// What a quantity of interest is called in tables and reports for people: "wall thickness, least" of thickness_min,
/// "heat into blow mould" of heat_blow_mould. Files and options have the name itself.
std::string quantity_label(const std::string& name);

}  // namespace parison::forming
