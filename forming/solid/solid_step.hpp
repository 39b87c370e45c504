#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include "forming/solid/solid_heat.hpp"

namespace parison::forming {

/// What steps of one solid keep. The pattern and the factor of heat come from earlier steps: a run that is taken up
/// again has the same bits only where they are made anew.
struct SolidWorkspace {
  std::unique_ptr<flow::FlowMatrix> flow;
  thermal::SolidStepMatrix heat;
};

/// What became of a step.
struct SolidStepOutcome {
  bool accepted = false;
  std::string reason;  ///< why not, a sentence
  flow::SolidStep flow;
  double temperature_change = 0;  ///< of glass that cools: the largest, K, with its weight (cooling::weighted_change)
};

/// Moves the glass over dt, s, from the time of `clock`, which has the stage and the places of tools at the start of
/// the step, and conducts heat over the same time. A step that is not accepted leaves the solid as it was.
SolidStepOutcome step_solid(const Scene& scene, const State& clock, double dt, SolidState& solid,
                            SolidWorkspace& workspace);

/// The length, s, of the next step after one that might have had the length `allowed`, s.
double propose_solid_step(const Scene& scene, const State& clock, const SolidState& solid, double allowed);

/// The place along the axis of a tool at a time since the present stage's start, m.
double tool_offset(const Scene& scene, const State& clock, Index tool, double stage_time);

/// All tools of a stage, or those that it brings to their places.
enum class SolidTools { all, coming };
/// The deepest place of the glass in such a tool.
struct SolidOverlap {
  double depth = 0;                          ///< m
  Index tool = -1;                           ///< index into Scene::tools; -1: none overlaps
  core::Vector3 at = core::Vector3::Zero();  ///< m
  bool is_end = false;                       ///< the tool faces along the axis there: the glass is too long
};
SolidOverlap deepest_overlap(const Scene& scene, const State& clock, const SolidState& solid, Index stage,
                             SolidTools tools);

}  // namespace parison::forming
