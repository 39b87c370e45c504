#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// What is far from what container forming uses, a sentence each with the usual range and where it is from; nothing of
/// it is an error. The ranges are typical published ones and those of tests/random_containers.
std::vector<std::string> unusual_values(const Scene& scene);

/// The same of a force that drives a tool away from the glass, or presses much more or less than is usual.
std::vector<std::string> unusual_forces(const Scene& scene);

/// A tool of the first stage whose face at the glass has no contact: the glass would enter the tool there.
std::vector<std::string> faces_without_contact(const Scene& scene);

/// The same of the cavity of the press, once the glass fills it.
std::vector<std::string> cavity_without_contact(const Scene& scene, const ContainerPlan& plan);

/// The plunger on its way to its stop runs into a tool that it is free of at the start: the place, and how far. Tools
/// without a hole around the axis, as drawn guide plates, and holes that are no contact boundaries are left out: tools
/// may slide in each other.
std::vector<std::string> tools_run_into(const Scene& scene, const ContainerPlan& plan);

/// The parison that a press or air makes in its blank does not fit into a mould of a later stage: which, where and by
/// how much.
std::vector<std::string> parison_too_large(const Scene& scene, const ContainerPlan& plan);

/// How far the outside of the parison is from the moulds of later stages.
struct ParisonClearance {
  core::Point at;    ///< of the outside of the parison, m
  double clearance;  ///< to the nearest of these moulds, m; negative inside one of them
};

/// That of places over its height, in order along the axis; empty without a parison or such a mould.
std::vector<ParisonClearance> parison_clearance(const Scene& scene, const ContainerPlan& plan);

/// A tool that comes in a later stage, before anything has formed the glass, stands in the gob: which, where and how
/// deep.
std::vector<std::string> gob_in_later_tools(const Scene& scene);

/// The plunger stops where a part of the glass is thinner than films may be, so that the run would end: which and
/// where.
std::vector<std::string> films_too_thin(const Scene& scene, const ContainerPlan& plan);

/// All of it as lines for the terminal, empty where all is usual.
std::string describe_unusual(const Scene& scene);

}  // namespace parison::forming
