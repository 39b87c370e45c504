#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "core/io/json.hpp"
#include "core/mesh/mesh.hpp"
#include "forming/scene/scene.hpp"

namespace parison::tools {

/// A case with what is set in it and its formulas as numbers.
core::CaseFile evaluated_case(const std::string& case_file, const std::vector<std::string>& assignments = {});

/// Adds, as `handles`, where each named dimension of a case that is one length moves a corner of a tool most, and which
/// way; found by reading the outlines with the dimension a little larger.
void add_dimension_handles(const std::string& case_file, const forming::Scene& scene, core::JsonWriter& json);

/// What moves a corner of a tool that its paths give by plain numbers, as assignments for core::override_value.
struct CornerHandle {
  std::string tool;
  core::Point at;  ///< m, as the tool stands
  double position;
  struct Place {
    std::string key, path;  ///< of the path, and its text
    std::size_t point;      ///< of those in the text
  };
  std::vector<Place> places;  ///< all that name this corner
};

/// The corners of the tools of a case that can be moved so.
std::vector<CornerHandle> corner_handles(const std::string& case_file, const forming::Scene& scene);

/// The assignments that put one to another place, m; throws core::CaseError where the number is that of none, or the
/// place is none.
std::vector<std::string> moved_corner(const std::vector<CornerHandle>& handles, double number, const core::Point& to);

}  // namespace parison::tools
