#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "thermal/heat_balance.hpp"
#include "thermal/solid/solid_problem.hpp"
#include "thermal/solid/wall_light.hpp"
#include "thermal/system.hpp"

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

/// Unknown whose temperature is prescribed.
struct SolidPrescribed {
  Index unknown, body;
  const core::TimeFunction* temperature;  ///< K
  Index boundary;                         ///< counted through all bodies
};

/// Semi-discrete heat equations in space, as HeatSystem: d/dt content(T) = power(t, T). The unknowns are the nodal
/// temperatures, body after body.
struct SolidSystem {
  const SolidProblem* problem;
  std::vector<Index> first_unknown;   ///< of each body; the last entry is the number of unknowns
  std::vector<Index> first_boundary;  ///< of each body, counted through all; the last entry is their number
  std::vector<Index> first_face;      ///< of each body, counted through all; the last entry is their number
  std::vector<SolidLaws> bodies;
  Eigen::VectorXd source;       ///< into each unknown at a source factor of 1, W
  Eigen::VectorXd body_source;  ///< the same by body, W
  std::vector<SolidHeatFace> faces;
  std::vector<SolidHeatPair> contacts;
  std::vector<std::pair<Index, Index>> pairs;  ///< slave and master body of each pair of bodies
  std::vector<SolidPrescribed> prescribed;
  std::vector<char> is_prescribed;  ///< by unknown
  std::vector<WallLight> lights;    ///< of the bodies that have it in bands

  Index size() const { return first_unknown.back(); }
};
/// Prepares the equations of a problem, which must outlive them. The glass absorbs as at the given temperatures, by
/// body, K.
SolidSystem make_solid_system(const SolidProblem& problem, const std::vector<Eigen::VectorXd>& temperature);
/// Why there are no equations to solve, a sentence; empty where there are.
std::string why_not_solvable(const SolidSystem& system);

/// Content and power at a time, s, and temperatures of the unknowns, K.
Response evaluate(const SolidSystem& system, double time, const Eigen::VectorXd& temperature);

/// Sets the prescribed unknowns, K, to their values at a time; false where none changes.
bool impose_prescribed(const SolidSystem& system, double time, Eigen::VectorXd& temperature);

/// A balance with the system's bodies and pairs and all entries zero.
HeatBalance zero_balance(const SolidSystem& system);

/// The unknowns of all bodies in one vector, and back, K.
Eigen::VectorXd join(const std::vector<Eigen::VectorXd>& temperature);
std::vector<Eigen::VectorXd> split(const SolidSystem& system, const Eigen::VectorXd& joined);

}  // namespace parison::thermal
