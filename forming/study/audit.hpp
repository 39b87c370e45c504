#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/run/run.hpp"
#include "forming/study/convergence_study.hpp"

namespace parison::forming {

/// A run of an audit: the case as it is, with a part of its model in or out, or with a change that means nothing.
struct AuditRun {
  Variant variant;
  bool completed = false;
  std::string reason;  ///< why not
  double seconds = 0;  ///< of CPU time
  Quantities quantities;
  double wall = 0;  ///< twice the volume of the glass over its surface, m
  /// The surface of the glass at the end as polygons, m, in each plane that is looked at: one; in space the outer side
  /// in the three of its meridians.
  std::vector<std::vector<std::vector<Point>>> planes;
};

/// What a run differs by from the case as it is; NaN where the scene has nothing to compare.
struct AuditChange {
  double shape;              ///< mean distance of the surfaces at the end, m
  double thickness;          ///< of the wall in the mean, as a share of it
  double heat;               ///< into the tools, as a share of it
  double mean_temperature;   ///< of the glass at the end, K
  std::string most_changed;  ///< other quantity of interest that changes most, by its share; empty without one
  double most_change = 0;    ///< that share
};

/// An assignment that changes what cannot matter: a tool (the glass, where no tool carries heat) by so many thousandths
/// of a kelvin, or its first step by so many thousandths where there is no heat.
std::string harmless_change(const Scene& scene, int thousandths);

/// The runs of an audit at an accuracy: the case as it is, the same with a harmless change of one thousandth up and
/// down, and a variant for each part of the model.
std::vector<Variant> audit_variants(const Scene& scene);
/// Whether a variant changes what cannot matter, so that it shows the noise.
bool is_noise(const Variant& variant);

/// Runs a variant of a case without files.
AuditRun audit_run(const std::string& case_path, const Variant& variant, const StopRequest& stop);

/// Compares two runs that have completed.
AuditChange audit_change(const AuditRun& run, const AuditRun& base);

}  // namespace parison::forming
