#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "contact/conductance/conductance.hpp"
#include "core/case/arithmetic/named_dimensions.hpp"
#include "core/case/table.hpp"
#include "core/case/tolerance.hpp"
#include "core/case/units.hpp"
#include "core/io/input_file.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/profile.hpp"
#include "core/solid/section_family.hpp"
#include "forming/cooling/glass_law.hpp"
#include "forming/flow/material.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/radiation_choice.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

using core::BoundaryKind;
using core::Index;

/// A named part of a body's outline.
struct Boundary {
  std::string name;
  BoundaryKind kind;
  thermal::SurfaceExchange cooling;  ///< cooled
  core::TimeFunction temperature;    ///< temperature, K over the time of the run, s
};

/// How a body is meshed at the start.
struct MeshSpec {
  std::optional<double> size;          ///< largest edge, m
  std::optional<double> contact_size;  ///< edge on contact boundaries, m
  std::optional<double> growth;        ///< size per distance from the contact boundaries
  /// Mapped mesh of a body with four boundaries: divisions along the first and second boundary, and the ratio of the
  /// last division to the first along each (in the direction of the boundary).
  struct Mapped {
    Index along_first, along_second;
    double ratio_first = 1, ratio_second = 1;
  };
  std::optional<Mapped> mapped;
};

/// Temperatures of a body at the start that differ from place to place: a function, or those of another result, whose
/// heat is handed over.
struct StartField {
  std::string source;                            ///< what it is, in words
  std::function<double(const core::Point&)> at;  ///< K at a place in the body's frame; empty for a result
  core::Mesh mesh;                               ///< of the result, in the body's frame
  Eigen::VectorXd temperature;                   ///< at its nodes, K
  double min = 0, max = 0;                       ///< K
};

struct Body {
  std::string name;
  core::Profile profile;             ///< in the body's own frame, m
  std::vector<Boundary> boundaries;  ///< one for each of profile.boundaries
  MeshSpec mesh;
  double initial_temperature = 0;            ///< K; the mean of a field
  std::optional<StartField> start_field;     ///< none: the temperature is uniform, or has a skin
  std::optional<thermal::Material> thermal;  ///< none: the body carries no heat in this scene
  double emissivity = 0;                     ///< of its open surfaces; of glass with light in bands where it is opaque
  double position = 0;                     ///< offset along the axis at the start, m (the profile is given at offset 0)
  std::vector<std::string> drawing_notes;  ///< sentences about what was not taken just as it was drawn
};

/// What becomes of glass between tools that gets thinner than the mesh can follow.
struct FilmLimit {
  double min_thickness = 0.3e-3;                       ///< m
  enum class Then { stop, freeze } then = Then::stop;  ///< the run ends, or the film flows no more
};

/// A colder skin of the gob: the temperature at a distance d from its open surface is core + (surface - core)
/// exp(-d/depth).
struct GobSkin {
  double temperature;  ///< at the surface, K
  double depth;        ///< m
};

/// The body that flows; always body 0. Without `flow` it does not move.
struct Glass : Body {
  std::optional<flow::Material> flow;
  std::optional<cooling::GlassLaw> annealing;  ///< none: it cannot cool
  FilmLimit film;
  std::optional<GobSkin> skin;  ///< at the start; initial_temperature is that of the core

  /// kg/m3; of glass that expands, at its initial temperature.
  double density() const { return thermal ? thermal->density : flow ? flow->density : 0; }
  /// Density over that, by temperature, K; empty where it does not depend on temperature.
  core::Table relative_density() const {
    return thermal ? thermal->relative_density : flow ? flow->relative_density : core::Table();
  }
};

/// Lubricant that is brought onto the contact surfaces of a tool between two containers, now and then.
struct Swab {
  int every;           ///< cycles of the machine from one to the next
  double heat;         ///< that it takes from the surface, J/m2
  double seconds = 1;  ///< in which it does
};

struct Tool : Body {
  flow::Friction friction;
  core::SectionFamily section;  ///< of a tool that is not round, by heights in its own frame
  double swabbing = 1;          ///< multiplies the conductance of its contact with the glass
  /// Whether it has its temperature at its first use, and keeps it until then: before that it serves another container.
  bool waits = false;
  std::optional<Swab> swab;  ///< in production
};

/// Thermal interface between the glass (slave) and a tool (master).
struct Interface {
  Index tool;  ///< index into Scene::tools
  contact::ConductanceLaw law;
  double transition_gap;  ///< gap over which the exchange changes from contact to air, m
};

/// A tool's motion during a stage.
struct PositionMotion {
  core::Table offset;  ///< offset along the axis, m, over time since the stage's start, s
};
struct ForceMotion {
  core::TimeFunction force;        ///< N along +axis, over time since the stage's start, s
  core::TimeFunction speed_limit;  ///< m/s, positive, likewise
};
using Motion = std::variant<std::monostate, PositionMotion, ForceMotion>;

struct StageTool {
  Index tool;     ///< index into Scene::tools
  Motion motion;  ///< monostate: stays at its present offset

  bool moves() const { return !std::holds_alternative<std::monostate>(motion); }
  bool is_driven() const { return std::holds_alternative<ForceMotion>(motion); }  ///< by a force
};

/// Names a part of the glass surface at the stage's start: what a tool touched at the end of the stage before, or from
/// the surface point nearest `from` to the one nearest `to`, walked with the glass on the left.
struct NamedBoundary {
  std::string name;
  core::Point from = core::Point::Zero(), to = core::Point::Zero();
  std::optional<Index> touched = std::nullopt;  ///< index into Scene::tools
};

/// The name of the glass boundary that a plunger, a pin or a counter-blow has made.
inline constexpr const char* inner_side = "inner";

/// Air around open surfaces.
struct Air : thermal::SurfaceExchange {
  bool of_stage = false;  ///< its times count from the start of the stage, not from that of the run
};

/// Exchange of a tool's boundary in one stage, in place of its cooling or of the air.
struct StageCooling {
  Index tool;                          ///< index into Scene::tools
  std::size_t boundary;                ///< index into the tool's boundaries
  core::TimeFunction h;                ///< W/m2/K over time since the stage's start, s
  core::TimeFunction air_temperature;  ///< K, likewise
};

/// What becomes of air that glass and tools seal.
struct TrappedAirLaw {
  double exponent;          ///< n of p V^n: 1 isothermal, 1.4 adiabatic
  double temperature;       ///< of the air, K
  double ambient = 101325;  ///< absolute pressure outside, Pa
  double vent_area = 0;     ///< effective flow area of the vent of each cavity, m2
  double seal_gap = 1e-4;   ///< narrower gaps between tools are closed, m
};

/// What ends a stage before its duration has passed.
struct EndCondition {
  enum class Kind {
    force,          ///< N: the force between the glass and any tool of the stage
    filled,         ///< share of the surface without pressure that is within `within` of the tools of the stage
    surface_below,  ///< K: mean temperature of the surface
    surface_above,  ///< K
    lowest          ///< m along the axis: the lowest point of the glass has come there, as gravity has it
  } kind;
  double value;
  double within = 0;  ///< m
};

/// When a section of the machine does what, in each of its cycles.
struct Timing {
  double cuts;   ///< of the shears, 1/s
  int sections;  ///< of the machine; each gets one of so many cuts
  double cycle;  ///< of a section, s: 360 deg
  struct Event {
    std::string name;
    double angle;  ///< deg from 0 to 360
  };
  std::vector<Event> events;  ///< by angle
};

/// A stage in the machine's timing.
struct TimedStage {
  double from;              ///< deg since the start of the first stage's cycle; beyond 360 in the next cycle
  std::string until_event;  ///< empty where the stage ends at none
};

struct Stage {
  std::string name;
  bool cools = false;  ///< the glass remembers its stress, and keeps its mesh
  double duration;     ///< s; the longest when an end condition is given
  /// The event that ends the stage, s since the start of the run, wherever the stages before have ended.
  std::optional<double> end_time;
  std::optional<TimedStage> timed;
  std::optional<double>
      end_speed;  ///< the stage also ends when every force-driven tool is slower than this, m/s, having been faster
  std::vector<EndCondition> ends;  ///< the stage also ends when any of these holds
  double gravity = 0;              ///< along +axis, m/s2
  std::vector<StageTool> tools;    ///< active tools; the others are absent
  /// Over-pressure on open glass boundaries by boundary name, Pa over time since the stage's start, s.
  std::map<std::string, core::TimeFunction> pressure;
  Air air;                            ///< of open surfaces; emissivity is the body's own
  std::optional<Air> inner_air;       ///< of the glass boundary `inner_side`, where it is other air
  std::vector<StageCooling> cooling;  ///< replaces that of tools
  std::vector<NamedBoundary> named_boundaries;
  std::optional<TrappedAirLaw> trapped_air;  ///< none: cavities are vented

  bool may_end_early() const { return end_speed || !ends.empty(); }
  bool uses(Index tool) const;
  bool has_driven_tool() const;
  /// Whether a pressure above zero acts on the glass.
  bool blows() const;
};

struct Probe {
  std::string name;
  Index body;         ///< 0 glass, 1 + i tool i
  core::Point point;  ///< in the body's frame at the start, m; a glass probe moves with the glass
};

/// Limits of the process that a run tells of when it goes beyond them.
struct Flags {
  double tool_surface_above = 645 + core::zero_celsius;  ///< K: glass sticks to a hotter tool
  std::optional<double> glass_below;                     ///< K
  std::optional<double> wall_below;                      ///< m, of the finished wall
};

struct Output {
  std::optional<double> fill_level;       ///< of the finished container below its rim, m
  double interval = 0;                    ///< between field outputs, s
  std::vector<double> times;              ///< further output times, s
  double checkpoint_interval = 300;       ///< between checkpoints, s of wall time
  std::optional<Index> checkpoint_steps;  ///< between checkpoints as well, steps
  Flags flags;
};

struct ContainerPlan;

/// From a stage on the glass is followed in space: a sector about the axis between two planes of symmetry, the first of
/// them y = 0.
struct SolidPart {
  Index from_stage;
  double sector;  ///< rad
};

/// A whole case in SI units, validated; nothing changes it during a run.
struct Scene {
  std::string name;
  std::string file, directory;                               ///< the case file and its folder
  std::shared_ptr<const std::vector<core::ReadFile>> files;  ///< what was read, as it was read: the case file first
  std::uint64_t fingerprint = 0;  ///< of the case file's text, the overrides and all outlines
  std::vector<core::NamedDimension> dimensions;
  std::vector<core::Tolerance> tolerances;  ///< of its values, in the order of the keys
  std::vector<std::string> overrides;       ///< values that replace those of the case file, "path=value"
  core::Geometry geometry;
  Glass glass;
  std::vector<Tool> tools;
  std::vector<Interface> interfaces;
  bool enclosure = false;                           ///< open surfaces of glass and tools see each other by radiation
  std::optional<RadiationChoice> radiation_choice;  ///< the model that `auto` took; none: the case names it
  std::vector<Stage> stages;
  std::optional<SolidPart> solid;  ///< none: the glass is round to the end
  std::vector<Probe> probes;
  Output output;
  std::optional<Timing> timing;
  std::string accuracy_name;  ///< the text that was asked for
  AccuracyChoice accuracy_choice;
  Accuracy accuracy;
  std::shared_ptr<const ContainerPlan> container;  ///< what drawings and mass say of it; null where they say nothing
  std::map<std::string, std::string>
      accuracy_origin;  ///< "case" or "--set" for each setting that the accuracy level did not choose

  bool has_flow() const { return glass.flow.has_value(); }
  bool has_heat() const { return glass.thermal.has_value(); }
  /// Whether the density of the glass depends on its temperature.
  bool expands() const { return !glass.relative_density().x.empty(); }
  /// Whether the light in the glass is computed in bands.
  bool has_light() const { return has_heat() && thermal::has_light(*glass.thermal); }
  /// Whether the gap of any contact is a quantity that evolves.
  bool has_gap_law() const;
};

/// Body 0 is the glass, body 1 + i tool i.
const Body& body_of(const Scene& scene, Index body);
/// The first stage that uses a tool; the number of stages where none does.
Index first_use(const Scene& scene, Index tool);
/// Whether a tool moves in a stage before this one.
bool has_moved_before(const Scene& scene, Index stage, Index tool);
/// Whether a tool, in a stage, still has the temperatures that it is to have at its first use.
bool is_waiting(const Scene& scene, Index stage, Index tool);
/// Flags of the boundaries of a body's outline that may touch other bodies.
std::vector<bool> contact_boundaries(const Body& body);

/// Lowest and highest place of those boundaries in the body's own frame, m.
std::pair<double, double> contact_range(const Body& body);

/// The air of a stage outside and, where it is other air, inside.
std::vector<const Air*> airs_of(const Stage& stage);

/// The coldest and the hottest of the bodies at the start, their cooling and the air, K.
struct TemperatureRange {
  double min_temperature, max_temperature;
  double span() const { return max_temperature - min_temperature; }
};
TemperatureRange temperature_range(const Scene& scene);

/// Reads and validates a case file; `accuracy` is a text for read_accuracy; `overrides` as core::override_value takes
/// them. Throws core::CaseError with `file:line: key: what was found, what is allowed`.
Scene read_scene(const std::string& path, const std::string& accuracy, const std::vector<std::string>& overrides = {});

}  // namespace parison::forming
