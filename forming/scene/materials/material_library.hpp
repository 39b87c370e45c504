#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "forming/cooling/glass_law.hpp"
#include "forming/flow/material.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

/// Bands made one that ends where the last of them does; it absorbs, 1/m, what they do in the mean over their emission
/// at a temperature, K.
thermal::Band merged_bands(const std::vector<thermal::Band>& bands, double temperature);

/// A value of a material that has no source.
struct AssumedValue {
  std::string key;
  std::string range;  ///< in which it is assumed, and why; empty where that is not said
};

/// A material by its name; properties that are missing are not computed.
struct NamedMaterial {
  std::string name;
  std::optional<thermal::Material> thermal;
  std::optional<flow::Material> flow;
  std::optional<cooling::GlassLaw> annealing;
  core::Table emissivity =
      core::constant(0);        ///< over temperature, K; by itself that of an opaque surface of its glass
  bool has_emissivity = false;  ///< whether the case gives it
  std::string about, source;    ///< what it is; where its values come from
  std::vector<AssumedValue> assumed;
};

/// Materials of a table of materials, in its order.
std::vector<NamedMaterial> read_materials(const core::CaseNode& node);

/// The bundled materials, cases/materials.toml.
const std::vector<NamedMaterial>& library_materials();
/// Their names.
std::vector<std::string> library_names();
/// The lines of a bundled material in its file, with its heading.
std::string library_entry(const std::string& name);

/// Gives a case the bundled materials that its glass and tools name and it has not itself, and the values that a
/// material `like` one of them does not give. Returns the names of those used.
std::vector<std::string> add_library_materials(core::CaseFile& file);

/// Puts the stages of a usual end of cooling, and the plate that it stands on, behind those of a case whose key
/// `cooling` is "standard"; nothing without the key.
void add_standard_cooling(core::CaseFile& file);

/// A case with what is set in it, also in the bundled materials that it then names. `used` gets their names.
core::CaseFile read_case(const std::string& path, const std::vector<std::string>& overrides,
                         std::vector<std::string>* used = nullptr);

/// Gives each of two cases the bundled materials that only the other names: they then differ in what is set alone.
void share_materials(core::CaseFile& one, core::CaseFile& other);

}  // namespace parison::forming
