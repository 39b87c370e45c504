#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/report/quantities.hpp"
#include "forming/scene/calibration.hpp"
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

/// A variant that has run, and the variant that it is compared with.
struct VariantResult {
  Variant variant;
  bool completed = false;
  std::string reason;
  double cpu = 0;  ///< s
  long steps = 0;
  double reynolds = 0;
  Quantities quantities;
  ProfileDifference profile{};  ///< to the reference, of a model variant to the base
  double heat = 0;              ///< likewise, a share
  bool on_front = false;

  /// The larger one of the mean thickness error and that of the heat; NaN where the scene has neither.
  double error() const;
};

/// Fills in the differences; the first result is the reference, `base` names the base variant.
void compare_variants(std::vector<VariantResult>& results, const std::string& base);

/// Marks the variants no other is both faster and closer than; reference and model variants take no part.
void mark_front(std::vector<VariantResult>& results);

/// CPU time of a variant over that of the best line at the same error; the line runs straight in the logarithms between
/// the variants on the front. NaN off the line's ends.
double over_front(const std::vector<VariantResult>& results, const VariantResult& variant);

/// The accuracy level's measured errors E as a law A*(2^(-p level) - 2^(-p reference)), the reference's own error taken
/// off; at_draft is NaN where fewer than two variants of the accuracy level tell.
ErrorLaw fit_error_law(const std::vector<VariantResult>& results, double (*error)(const VariantResult&));

}  // namespace parison::forming
