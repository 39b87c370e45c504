#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// A run of a ladder: a case at an accuracy with some values replaced.
struct Rung {
  std::string name;   ///< also of its folder
  std::string group;  ///< reference, dial, mesh, time, coupling, order, or model
  std::string accuracy;
  std::vector<std::string> overrides;
  std::string what;  ///< what a rung of the group model leaves out
};

/// The accuracy that the others are held against: where the case maps its mesh the presets alone would all compute the
/// same.
std::string usual_reference(const Scene& scene);

/// The rungs that a scene calls for. Those of the dial are the presets and what lies between, as far as they are
/// coarser than the reference; the others change one thing each at `scene`, which was read at the base accuracy.
std::vector<Rung> standard_ladder(const Scene& scene, const std::string& reference);

/// A ladder from a TOML file of [[rung]] tables with name, group, [accuracy], [set] and [what].
std::vector<Rung> read_ladder(const std::string& path, const std::string& base);

/// The rung that runs at the base accuracy with nothing replaced; added where the ladder lacks one.
std::string base_rung(std::vector<Rung>& ladder, const std::string& base);

}  // namespace parison::forming
