#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/cooling/glass_law.hpp"

namespace parison::forming {

using core::Index;

/// The fields of the glass. Each is declared once in `glass_fields` below; checkpoint, hash, transfer to a new mesh, a
/// stage's start, interpolation in time, output and tests walk that list. A field that exists only where the scene has
/// what it needs is empty elsewhere.
struct GlassFields {
  Eigen::VectorXd temperature;
  Eigen::VectorXd velocity;             ///< over the last step
  Eigen::VectorXd acceleration;         ///< between the last two steps
  Eigen::VectorXd dilatation_mode;      ///< velocities that change the volume at 1/s everywhere; zero where unknown
  Eigen::VectorXd temperature_rate;     ///< over the last step
  Eigen::VectorXd temperature_slowing;  ///< growth of the reciprocal of that rate over it; 0 where it does not fall
  Eigen::VectorXd contact_pressure;  ///< zero where nothing presses; after a new mesh, what edges had between nodes too
  std::vector<Index> contact_tool;   ///< index into Scene::tools of the tool that presses on the node, -1 where none
  std::vector<Index> previous_contact_tool;  ///< the same a step earlier
  Eigen::VectorXd branch_stress;             ///< of glass that cools: cooling::GlassMemory
  Eigen::VectorXd fictive_temperature;       ///< likewise, of each branch
  Eigen::VectorXd mean_pressure;             ///< likewise
  Eigen::VectorXd contact_opening;  ///< of the gap to a tool beyond that at first touch; zero where nothing touches
};

/// Where the values of a field belong.
enum class Location { node, quadrature_point };
/// What a scene must have for the field to exist.
enum class Needs { nothing, heat_or_flow, flow, gap_law, cooling };
/// How the field gets to a new mesh: with the heat content kept, by interpolation, by interpolation or projection along
/// the surface, from the nearest surface node in contact, or not at all.
enum class TransferRule {
  conserve_heat,
  interpolate,
  interpolate_along_surface,
  project_along_surface,
  nearest_contact,
  reset
};
/// What a stage's start does to it: keep it, reset it to its value at rest, or reset it where its tool is no longer
/// active.
enum class StageStart { keep, reset, reset_without_tool };
/// Its value at a time within a step: between those of both ends, that of the step, or carried on to that time from the
/// middles of this step and the one before.
enum class WithinStep { linear, of_step, of_middle };
/// How it is written to the result files: as it is, in mm where it is in m, in degC where it is in K.
enum class FieldOutput { none, value, millimetre, celsius };

/// One declaration. The constructor wants every rule: a field without one does not compile.
template <typename FieldValues>
struct FieldDeclaration {
  using Values = FieldValues;
  const char *name, *unit;
  Location location;
  int components;  ///< numbers at each node or point
  Needs needs;
  TransferRule transfer;
  StageStart stage_start;
  WithinStep within_step;
  FieldOutput output;
  const char* output_name;  ///< in the result files; empty where it is not written
  Values GlassFields::*values;

  constexpr FieldDeclaration(const char* its_name, const char* its_unit, Location where, int its_components,
                             Needs its_needs, TransferRule its_transfer, StageStart its_stage_start,
                             WithinStep its_within_step, FieldOutput its_output, const char* its_output_name,
                             Values GlassFields::*its_values)
      : name(its_name),
        unit(its_unit),
        location(where),
        components(its_components),
        needs(its_needs),
        transfer(its_transfer),
        stage_start(its_stage_start),
        within_step(its_within_step),
        output(its_output),
        output_name(its_output_name),
        values(its_values) {}

  /// The value at rest: no tool, or zero.
  static constexpr typename Values::value_type at_rest() {
    return std::is_same_v<typename Values::value_type, Index> ? -1 : 0;
  }
};

inline constexpr auto glass_fields = std::make_tuple(
    FieldDeclaration("temperature", "K", Location::node, 1, Needs::heat_or_flow, TransferRule::conserve_heat,
                     StageStart::keep, WithinStep::linear, FieldOutput::celsius, "temperature_degC",
                     &GlassFields::temperature),
    FieldDeclaration("velocity", "m/s", Location::node, core::dim, Needs::flow, TransferRule::interpolate,
                     StageStart::reset, WithinStep::of_step, FieldOutput::millimetre, "velocity_mm_s",
                     &GlassFields::velocity),
    FieldDeclaration("acceleration", "m/s2", Location::node, core::dim, Needs::flow, TransferRule::interpolate,
                     StageStart::reset, WithinStep::of_step, FieldOutput::none, "", &GlassFields::acceleration),
    FieldDeclaration("dilatation_mode", "m/s", Location::node, core::dim, Needs::flow, TransferRule::interpolate,
                     StageStart::reset, WithinStep::of_step, FieldOutput::none, "", &GlassFields::dilatation_mode),
    FieldDeclaration("temperature_rate", "K/s", Location::node, 1, Needs::flow, TransferRule::interpolate,
                     StageStart::reset, WithinStep::of_step, FieldOutput::none, "", &GlassFields::temperature_rate),
    FieldDeclaration("temperature_slowing", "1/s", Location::node, 1, Needs::flow, TransferRule::interpolate,
                     StageStart::reset, WithinStep::of_step, FieldOutput::none, "", &GlassFields::temperature_slowing),
    FieldDeclaration("contact_tool", "", Location::node, 1, Needs::nothing, TransferRule::nearest_contact,
                     StageStart::reset_without_tool, WithinStep::of_step, FieldOutput::value, "tool_in_contact",
                     &GlassFields::contact_tool),
    FieldDeclaration("previous_contact_tool", "", Location::node, 1, Needs::nothing, TransferRule::nearest_contact,
                     StageStart::keep, WithinStep::of_step, FieldOutput::none, "", &GlassFields::previous_contact_tool),
    FieldDeclaration("contact_pressure", "Pa", Location::node, 1, Needs::nothing, TransferRule::project_along_surface,
                     StageStart::reset_without_tool, WithinStep::of_middle, FieldOutput::value, "contact_pressure_Pa",
                     &GlassFields::contact_pressure),
    FieldDeclaration("branch_stress", "Pa", Location::quadrature_point, 4 * cooling::branches, Needs::cooling,
                     TransferRule::reset, StageStart::keep, WithinStep::of_step, FieldOutput::none, "",
                     &GlassFields::branch_stress),
    FieldDeclaration("fictive_temperature", "K", Location::quadrature_point, cooling::branches, Needs::cooling,
                     TransferRule::reset, StageStart::keep, WithinStep::of_step, FieldOutput::none, "",
                     &GlassFields::fictive_temperature),
    FieldDeclaration("mean_pressure", "Pa", Location::node, 1, Needs::cooling, TransferRule::reset, StageStart::keep,
                     WithinStep::of_step, FieldOutput::none, "", &GlassFields::mean_pressure),
    FieldDeclaration("contact_opening", "m", Location::node, 1, Needs::gap_law, TransferRule::interpolate_along_surface,
                     StageStart::reset_without_tool, WithinStep::linear, FieldOutput::millimetre, "contact_opening_mm",
                     &GlassFields::contact_opening));

/// Calls work(declaration) for each field, in the order of the list.
template <typename Work>
constexpr void for_each_glass_field(Work&& work) {
  std::apply([&](const auto&... field) { (work(field), ...); }, glass_fields);
}

namespace detail {
template <typename... Fields>
constexpr std::size_t size_of_values(const std::tuple<Fields...>&) {
  return (sizeof(typename Fields::Values) + ...);
}
template <typename... Fields>
constexpr bool can_be_transferred(const std::tuple<Fields...>& fields) {
  return std::apply(
      [](const auto&... field) {
        return ((field.location == Location::node || field.transfer == TransferRule::reset) && ...);
      },
      fields);
}
}  // namespace detail
static_assert(detail::size_of_values(glass_fields) == sizeof(GlassFields),
              "a member of GlassFields has no declaration");
static_assert(detail::can_be_transferred(glass_fields), "fields at quadrature points have no transfer but reset yet");

/// Places of a field on a mesh.
inline Index place_count(Location location, const core::Mesh& mesh) {
  constexpr Index points_per_cell = 6;  // of core::triangle_rule(4)
  return location == Location::node ? mesh.node_count() : points_per_cell * mesh.cell_count();
}

}  // namespace parison::forming
