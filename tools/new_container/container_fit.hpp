#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

namespace parison::tools {

/// A first design of a container: the values that a template gets, as core::override_value takes them.
struct ContainerFit {
  std::vector<std::string> overrides;
  double body, blank;  ///< radii, m
};

/// The radii with which the closed mould has a volume, and the cavity of the press with the plunger at its stop that of
/// the glass, m3 and kg; `given` are the values of the wish. Throws core::CaseError where the reader refuses all near
/// them, or there are none.
ContainerFit fit_container(const std::string& file, const std::vector<std::string>& given, double capacity,
                           double mass);

}  // namespace parison::tools
