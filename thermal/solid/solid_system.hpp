#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "thermal/solid/solid_problem.hpp"
#include "thermal/solid/wall_light.hpp"
#include "thermal/unknowns.hpp"

namespace parison::thermal {

/// Laws and cells of one body.
struct SolidLaws {
  Enthalpy enthalpy;
  Conductivity conductivity;
  core::CellList cells;
  core::CellMetric metric;
  const Eigen::VectorXd* mass;  ///< by point, kg
  Eigen::MatrixXd stacked;      ///< of the table: shape, then derivative; 4 points x nodes
  Eigen::VectorXd thin_wall;    ///< factor on the radiant conductivity by point; empty: 1
  Index first_unknown;
};

/// Face that exchanges heat with its surroundings.
struct SolidHeatFace {
  std::array<Index, 9> unknowns;
  std::array<double, 9> area;  ///< at the points of `face_shapes`, m2
  Index clique;                ///< counts the faces of all bodies
  Index boundary;              ///< counted through all bodies
  Index body;
};
/// Shape functions at the 3 x 3 Gauss points of a face, [point][node].
const std::array<std::array<double, 9>, 9>& face_shapes();

/// A pair of faces with points in contact.
struct SolidHeatPair {
  std::array<Index, 18> unknowns;         ///< of the slave's face, then the master's
  Index first_point, last_point;          ///< range of the interface's points, without the last
  Index pair;                             ///< index into SolidInterface::pairs
  Index body_pair;                        ///< index into SolidSystem::pairs
  Index slave_boundary, master_boundary;  ///< counted through all bodies
};

/// Semi-discrete heat equations in space, as HeatSystem.
struct SolidSystem : HeatUnknowns {
  const SolidProblem* problem;
  std::vector<Index> first_face;  ///< of each body, counted through all; the last entry is their number
  std::vector<SolidLaws> bodies;
  std::vector<SolidHeatFace> faces;
  std::vector<SolidHeatPair> contacts;
  std::vector<WallLight> lights;  ///< of the bodies that have it in bands
};
/// Prepares the equations of a problem, which must outlive them. The glass absorbs as at the given temperatures, by
/// body, K.
SolidSystem make_solid_system(const SolidProblem& problem, const std::vector<Eigen::VectorXd>& temperature);
/// Why there are no equations to solve, a sentence; empty where there are.
std::string why_not_solvable(const SolidSystem& system);

/// Content and power at a time, s, and temperatures of the unknowns, K.
Response evaluate(const SolidSystem& system, double time, const Eigen::VectorXd& temperature);

}  // namespace parison::thermal
