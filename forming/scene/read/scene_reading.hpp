#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of read_scene; private to the files that read and check a scene.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "forming/scene/materials/material_library.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Internal radiation of a material; nothing for the model "none".
std::optional<thermal::Radiation> read_radiation(const core::CaseNode& node);

/// How a glass anneals whose viscosity is no constant; `material` is its whole table, with its expansion.
cooling::GlassLaw read_annealing(const core::CaseNode& node, const core::CaseTable& material,
                                 const flow::Viscosity& viscosity);

/// Puts a model into the place of `auto` in the radiation of the glass's material: the cheapest that keeps the model
/// error asked for, by `within` or else by the accuracy, among those that the case has the keys of. Nothing where the
/// case names its model.
std::optional<RadiationChoice> choose_radiation(core::CaseFile& file, const AccuracyChoice& accuracy);

/// What is needed to read a body.
struct BodyContext {
  std::string directory;  ///< of the case file
  core::Geometry geometry;
  std::vector<NamedMaterial> materials;
  bool with_heat = true, with_flow = true;  ///< whether the glass carries heat and flows, once known
  bool with_light = false;                  ///< whether light of the glass reaches the tools, once known
};
Glass read_glass(const core::CaseNode& node, const BodyContext& context);
Tool read_tool(const core::CaseNode& node, const BodyContext& context);

/// The sections of a tool that is not round; `tool` has its outline, and gets notes about a drawing.
core::SectionFamily read_sections(const core::CaseNode& node, const BodyContext& context, Tool& tool);
/// The part of a stage from which on the glass is followed in space. `scene` has the stages before it.
void read_solid(const core::CaseNode& node, const Stage& stage, Scene& scene);
/// Refuses sections whose stages follow the glass as a round body, and what is not computed in space yet.
void check_solid(const Scene& scene, const core::CaseTable& root);

/// The temperature of a body at the start, uniform or a field; `body` has its outline.
void read_start_temperature(const core::CaseNode& node, const BodyContext& context, Body& body);

/// Mean by volume of a function of the temperature, K, that a body has at its start.
double start_mean(const Body& body, core::Geometry geometry, const std::function<double(double)>& f);
/// Digits that change with the field, for the fingerprint of a case.
std::string start_field_text(const StartField& field, const core::Profile& profile);

/// The keys of the table of the glass, and of that of its gob.
std::vector<std::string> glass_keys();
std::vector<std::string> gob_keys();
/// Draws the glass as a capsule of a given mass, or scales its outline to the mass.
void read_gob(const core::CaseNode& node, core::Geometry geometry, Glass& glass);
/// A cylinder between two half spheres that has a volume, m3, its lower pole on the axis at `pole`, m; the axis is its
/// last segment.
std::vector<core::Segment> capsule(double volume, double diameter, double pole);
/// Makes an outline larger or smaller about a point of the axis, so that it has a volume, m3.
void scale_to(core::Profile& profile, double volume, const core::Point& fixed);
/// Moves a gob that a tool takes in (`in`) along gravity until it touches the tools of the first stage, and reads its
/// temperature there; one without a diameter gets the shape of its room before. Refuses one that finds no room. Nothing
/// for glass that has its place.
void lay_down_gob(const core::CaseTable& root, const BodyContext& context, Scene& scene);
/// The temperature of the glass, uniform or a field, with a skin or without.
void read_glass_temperature(const core::CaseTable& glass, const BodyContext& context, Glass& body);
GobSkin read_skin(const core::CaseNode& node, const Glass& glass);
/// Refuses a gob given by its mass that does not fit the cavity of its press or mould.
void check_gob(const Scene& scene, const core::CaseNode& glass);

/// A table of a body's list of boundaries, with the keys that it may have.
core::CaseTable boundary_table(const core::CaseNode& node);
/// A point such as "(31, 14) mm".
core::Point read_point(const core::CaseNode& node);
/// The closed outline of a list of boundaries, each with its path or CSV file, in the order and sense of the file.
/// `notes` gets sentences about what was not taken just as it was drawn.
core::Profile read_outline(const core::CaseNode& boundaries, const std::string& directory,
                           std::vector<std::string>& notes);
/// Refuses an outline that crosses itself or leaves the half-plane of an axisymmetric scene.
void check_outline(const core::Profile& profile, core::Geometry geometry, const core::CaseNode& boundaries);

/// Refuses a table over temperature with more than a thousand pairs: it is asked at every point of every step.
void require_few_pairs(const core::CaseNode& table);

/// The interfaces of one [[interface]] entry, one for each tool it names.
std::vector<Interface> read_interfaces(const core::CaseNode& node, const Scene& scene);
/// The top-level tables of air that a stage may replace, null where the case has none.
struct CommonAir {
  const core::CaseNode *air, *inner, *trapped;
};
/// A stage. `scene` contains everything read before it; a stage read before gets the name of the inner side where this
/// one loads it.
Stage read_stage(const core::CaseNode& node, const CommonAir& common, Scene& scene);
/// The machine's timing; every text of the case may name its events, as times, and the cycle.
std::optional<Timing> read_timing(core::CaseFile& file, const std::vector<core::NamedDimension>& dimensions);
/// Whether a stage forms or cools the glass, and what only one of them can have.
void read_kind(const core::CaseTable& table, const Scene& scene, Stage& stage);
/// Duration and air of a stage from the zones of a lehr and the speed of its belt.
void read_lehr(const core::CaseNode& node, const core::CaseTable& table, Stage& stage);
/// How long a stage lasts: its duration, or from one event of the timing until another.
void read_times(const core::CaseTable& table, const Scene& scene, Stage& stage);
/// The boundaries that a stage names.
void read_named_boundaries(const core::CaseTable& table, const Scene& scene, Stage& stage);
/// The air around a stage's surfaces and in its cavities, and what cools its tools.
void read_surroundings(const core::CaseTable& table, const CommonAir& common, Scene& scene, Stage& stage);
/// Refuses what acts on an inner side that the glass does not have.
void refuse_unknown_inner_side(const core::CaseNode& node, const Scene& scene, const Stage& stage);
/// Names the inner side, unless something in the case does, by the tool that has made it: the one moved tool that has
/// left the glass, or else the one tool that has. `load` is the entry that loads it.
void name_inner_side(const core::CaseNode& load, Scene& scene, Stage& stage);
Probe read_probe(const core::CaseNode& node, const Scene& scene);
Output read_output(const core::CaseNode& node);
void read_numerics(const core::CaseNode& node, Scene& scene);
/// Makes every edge and step of a scene `factor` times as long, those of its bodies' own meshes too.
void coarsen(Scene& scene, double factor);

/// Names of the scene's tools, in their order.
std::vector<std::string> tool_names(const Scene& scene);
/// Refuses a list of tables two of which have the same name, and one of more than a thousand.
void refuse_repeated_names(const std::vector<const core::CaseNode*>& tables);

/// Refuses edge lengths that would give a body more cells than a run can handle.
void check_sizes(const Scene& scene, const core::CaseTable& root);
/// Refuses tools that overlap the glass at the start.
void check_no_overlap(const Scene& scene, const std::vector<const core::CaseNode*>& tools);
/// Refuses flows without a unique answer: glass that nothing constrains along the axis, and glass enclosed on all
/// sides.
void check_support(const Scene& scene, const core::CaseTable& root);
/// Refuses a container that would fall over where it is put down to cool.
void check_standing(const Scene& scene, const core::CaseTable& root);
/// Refuses a motion that does not start where the stages before leave its tool, where that is known.
void check_motions(const Scene& scene, const std::vector<const core::CaseNode*>& stages);
/// Refuses stages in which hot bodies can touch without an interface between them.
void check_interfaces(const Scene& scene, const std::vector<const core::CaseNode*>& stages);

}  // namespace parison::forming
