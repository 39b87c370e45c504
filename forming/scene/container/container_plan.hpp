#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "forming/scene/container/free_space.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// The press as its drawings have it: the cavity that tools and plunger close.
struct PressPlan {
  Index stage, tool;                           ///< indices into Scene::stages and tools
  bool is_driven;                              ///< by a force: the plunger stops where the glass fills the cavity
  double stop;                                 ///< offset of the plunger then, or at the end of its given motion, m
  double cavity;                               ///< volume with the plunger there, m3
  double low, high;                            ///< of the cavity then, m along the axis
  std::vector<Slice> glass;                    ///< the cavity then, on lines across the axis
  std::vector<std::optional<double>> offsets;  ///< of all tools then, as far as known, m
};

/// The parison as its drawings have it: what tools of a stage close around it.
struct ParisonPlan {
  Index stage;                   ///< index into Scene::stages
  std::optional<Index> plunger;  ///< that the press moves; none where air forms the parison
  double low, high;              ///< of the cavity, m along the axis
  double cavity;                 ///< its volume, m3
};

/// What drawings and mass say about the container before anything is run.
struct ContainerPlan {
  double mass, glass_volume;       ///< kg, m3
  std::optional<PressPlan> press;  ///< none where no tools and plunger close a cavity
  std::string misfit;              ///< why the glass does not fit its cavity, a sentence; empty where it does
  std::string remedy;              ///< what is allowed then
  std::optional<double> outside;   ///< volume of the closed mould of the last stage, m3
  std::optional<double> rim;       ///< place of the rim along the axis, m
  std::optional<double> capacity;  ///< to the rim, m3; none where the glass would hold nothing
  std::optional<double> filled;    ///< to the fill level, m3, the inside of the finish as the plunger made it
  std::optional<std::pair<double, double>> mould_range;  ///< lowest and highest place of that mould, m
  std::optional<ParisonPlan> parison;  ///< none where no tools close a cavity before those of the last stage
  double doubt = 0;        ///< share by which the volumes differ from those within chords of the same outlines
  std::string falls = {};  ///< why it cannot stand, a sentence; empty where it can or no mould is closed
};

/// Beyond it two ways to one volume contradict each other.
inline constexpr double most_doubt = 0.01;

/// Height inside which a fill level can lie, m: of the closed mould, or of the press cavity; none without either.
std::optional<double> inside_height(const ContainerPlan& plan);

/// Nothing in a planar scene, without flow or without tools. The container stands upright in the last stage: its rim is
/// at the end of its mould against gravity; without a closed mould, where the glass of the press cavity runs over.
/// `read_scene` leaves it in Scene::container.
std::optional<ContainerPlan> plan_container(const Scene& scene);

/// The offset at which a tool that a force drives has filled the cavity it closes with the others of its stage, with
/// that volume of glass, m3, and all tools at the offsets given, m: its own one where the cavity is full already.
/// Nothing where it closes none.
std::optional<double> full_offset(const Scene& scene, const std::vector<double>& offset, Index stage, Index tool,
                                  double volume);

/// Whether +z points up in a stage: against its gravity, or that of the last stage before that has some.
bool is_upright(const Scene& scene, std::size_t stage);

/// The plan as lines for the terminal, empty without one.
std::string describe_container(const Scene& scene);

/// The last stage that does not cool the glass, in which the container stands as drawn; the last one where all do.
const Stage& last_forming_stage(const Scene& scene);

/// A place on the axis, m, in mm to a hundredth: no longer than a person would write it, and never "-0".
std::string place_in_mm(double place);

}  // namespace parison::forming
