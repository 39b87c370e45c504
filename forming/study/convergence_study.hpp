#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// A run of a study: a case at an accuracy with some values replaced.
struct Variant {
  std::string name;   ///< also of its folder
  std::string group;  ///< reference, accuracy, mesh, time, coupling, order, or model
  std::string accuracy;
  std::vector<std::string> overrides;
  std::string what;  ///< which part a variant of the group model neglects
};

/// The accuracy of the reference: where the case maps its mesh the presets alone would all compute the
/// same.
std::string usual_reference(const Scene& scene);

/// The variants that a scene calls for. Those of the accuracy level are the presets and what lies between, as far as
/// they are coarser than the reference; the others change one thing each at `scene`, which was read at the base
/// accuracy.
std::vector<Variant> standard_study(const Scene& scene, const std::string& reference);

/// A study from a TOML file of [[variant]] tables with name, group, [accuracy], [set] and [what].
std::vector<Variant> read_study(const std::string& path, const std::string& base);

/// The variant that runs at the base accuracy with nothing replaced; added where the study lacks one.
std::string base_variant(std::vector<Variant>& study, const std::string& base);

}  // namespace parison::forming
