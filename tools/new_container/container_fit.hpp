#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::tools {

/// Whether a template has no blank: what its mould and plunger make is the ware.
bool is_pressed(const forming::Scene& scene);

/// A first design of a container: the values that a template gets, as core::override_value takes them.
struct ContainerFit {
  std::vector<std::string> overrides;
  double body;    ///< radius, m
  double second;  ///< radius of the blank, or the wall of pressed ware, m
};

/// The lengths with which the mould has the volume of capacity and glass, and the room of the parison, with a plunger
/// at its stop, that of the glass over the template's `parison_share`, m3 and kg; `given` are the values of the wish.
/// Throws core::CaseError where the reader refuses all near them, or there are none.
ContainerFit fit_container(const std::string& file, const std::vector<std::string>& given, double capacity,
                           double mass);

}  // namespace parison::tools
