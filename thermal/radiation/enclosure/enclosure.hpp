#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/case/time_function.hpp"
#include "thermal/radiation/enclosure/views.hpp"
#include "thermal/radiation/traced_places.hpp"

namespace parison::thermal {

struct BodyView;
struct HeatSystem;
struct Flows;

/// Boundary edge of a body that sees others.
struct OpenEdge {
  Index body, edge;  ///< of the body's mesh
  Index patch;       ///< -1: it sees nothing but the surroundings
};

/// Areas of boundary edges, m2, by body and edge.
using EdgeAreas = std::vector<std::vector<double>>;

/// Views as traced, and where the bodies were then.
struct TracedViews {
  std::vector<std::vector<Point>> nodes;  ///< by body, shifted to its place
  std::vector<std::vector<std::array<Index, 6>>> cells;
  EdgeAreas edge_open, edge_full;  ///< open then, and with what tools covered
  std::vector<OpenEdge> edges;
  Views views;
  Eigen::ArrayXd area, full;  ///< of the patches: open then, and with what tools covered, m2
  double unseen = 0;          ///< area open then of edges without a patch, m2
  double patch_length = 0;    ///< in the section, m
  double patch_area = 0;      ///< of a mean patch, m2
  std::string failure;        ///< why the views cannot be closed, with the place; empty where they can
};

/// Point of the surface of a patch. Where a body is in contact the points of the interface take the covered area off.
struct EnclosurePoint {
  std::array<Index, 3> unknowns;
  std::array<double, 3> shape;
  double area;  ///< m2; negative at the interface
  Index patch;
  Index edge;  ///< boundary edge of the body's mesh
};

/// Part of the surface with one radiosity.
struct EnclosurePatch {
  Index body;
  Index boundary;                          ///< of the body
  double emissivity;                       ///< of the grey surface, or of the opaque bands of glass with light
  const core::TimeFunction* surroundings;  ///< their temperature, K
};

/// Surfaces that see each other through the air. Everything else of the heat equations lets them see the surroundings
/// alone; what an enclosure adds is the excess, the irradiation less the emissive power of the surroundings.
struct Enclosure {
  std::shared_ptr<const TracedViews> traced;
  std::vector<EnclosurePatch> patches;
  std::vector<EnclosurePoint> points;
  Views views;  ///< closed, on the present meshes
  Eigen::ArrayXd emissivity, area;
  Eigen::PartialPivLU<Eigen::MatrixXd> grey;  ///< A - K (1 - emissivity)
};

/// Prepares the enclosure of a problem that asks for one; traces anew where the bodies or the contacts have changed too
/// much since it was done last.
std::shared_ptr<const Enclosure> make_enclosure(const HeatSystem& system, KeptTraces<TracedViews>& traced);

/// Emissive power of the surroundings of each patch at a time, s, by that of a black body, W/m2.
Eigen::ArrayXd surroundings_of(const Enclosure& enclosure, double time, const std::function<double(double)>& emission);

/// Excess irradiation of the patches, W/m2, times the areas: K J - (A - open) E_s for radiosities J, both W/m2.
Eigen::VectorXd excess_source(const Enclosure& enclosure, const Eigen::ArrayXd& radiosity,
                              const Eigen::ArrayXd& surroundings);

/// Means over the patches of a value at the points.
template <typename Value>
Eigen::ArrayXd patch_means(const Enclosure& enclosure, const Value& value_at) {
  Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(enclosure.patches.size()));
  for (std::size_t i = 0; i < enclosure.points.size(); ++i)
    mean[enclosure.points[i].patch] += enclosure.points[i].area * value_at(i);
  return mean / enclosure.area;
}

/// Adds the share `absorbed` of the excess, by patch, to the flows and, unless null, to the power into the unknowns of
/// all bodies but one; light takes what enters that one.
void add_excess(const Enclosure& enclosure, const HeatSystem& system, const Eigen::ArrayXd& absorbed, Flows& flows,
                Eigen::VectorXd* power, Index but = -1);

/// Adds the excess of the grey surfaces, of glass with light that of its opaque bands, at a time, s, and temperatures,
/// K, to the flows and, unless null, the power, W.
void add_enclosure(const HeatSystem& system, double time, const Eigen::VectorXd& temperature, Flows& flows,
                   Eigen::VectorXd* power);
/// Derivatives of the emissive power at the points, W/m2/K.
Eigen::ArrayXd linearise_enclosure(const HeatSystem& system, const Eigen::VectorXd& temperature);
/// Adds to `result`, J, the step, s, times the change of the heat flowing out by the excess when the temperatures
/// change by `change`, K.
void apply_enclosure(const HeatSystem& system, const Eigen::ArrayXd& derivatives, double step,
                     const Eigen::VectorXd& change, Eigen::VectorXd& result);

}  // namespace parison::thermal
