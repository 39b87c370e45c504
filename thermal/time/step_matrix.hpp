#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/linear/cholesky.hpp"
#include "thermal/system.hpp"
#include "thermal/time/couplings.hpp"

namespace parison::thermal {

/// Slopes of content and power with temperature at the points of a group of cells.
struct BatchDerivatives {
  PointValues capacity;        ///< J/K
  PointValues conductivity;    ///< W/m/K
  PointValues flow_a, flow_b;  ///< of the heat flow along the reference coordinates, by dk/dT alone, W/K
};
/// Derivative of the heat equations at a temperature, with the slopes of conductivity and conductance.
struct Linearisation {
  std::vector<BatchDerivatives> batches;
  std::vector<std::array<double, 3>> edges;  ///< of surface exchange at the points of edge_rule(3), W/K
  ContactDerivatives contacts;
};
Linearisation linearise(const HeatSystem& system, const Eigen::VectorXd& temperature);

/// What a change of the temperatures, K, does to content - step power, J.
Eigen::VectorXd apply(const HeatSystem& system, const Linearisation& linearisation, double step,
                      const Eigen::VectorXd& change);

/// Factor of C + step K, kept from step to step: C the heat capacity, K the conduction, exchange and interface at the
/// temperature of the factorisation. Of the slopes of conductivity and conductance K has only what is symmetric and
/// positive: a conductance that rises with the slave's temperature, in the slave's own block. Newton with it is a
/// modified Newton; solve_stage has the full derivative.
struct StepMatrix {
  std::vector<Index> topology;  ///< unknowns of all cells and boundary edges
  std::vector<Coupling>
      couplings;  ///< that the pattern is to have; `prepare` keeps them as long as they hold the interface's
  std::vector<Coupling> analysed_couplings;  ///< that it has
  Index first_coupling = 0;                  ///< clique of the first of them
  std::vector<Index> segment_clique;         ///< of each segment of the interface
  std::vector<char> is_prescribed;
  std::vector<Index> order;  ///< of elimination, that of the matrix's unknowns: order[k] is the k-th in the system
  core::Assembly assembly;   ///< upper triangle
  core::Cholesky cholesky;
  Eigen::VectorXd diagonal;
  std::vector<KeptCells> kept;  ///< by body
  double factored_step = 0;     ///< s; 0 when there is no factor
  Index factorisations = 0;
};

/// Adds a dense symmetric matrix, row-major count x count, without the rows and columns of prescribed unknowns.
void add_clique(StepMatrix& matrix, const HeatSystem& system, Index clique, Index count, const Index* unknowns,
                double* local);
/// Makes pattern and analysis a function of the system and of `couplings`, which are replaced by wider ones where the
/// interface has others; drops the factor where they change, and where other unknowns are prescribed.
void prepare(StepMatrix& matrix, const HeatSystem& system);
/// Assembles and factorises at a temperature; false when the matrix is not positive definite.
[[nodiscard]] bool factorise(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature,
                             double step);

/// Order in which the unknowns of a heat system are eliminated: minimum degree on the graph of the vertices, each
/// mid-side node before the first vertex of its edge.
std::vector<Index> elimination_order(const HeatSystem& system, const std::vector<Coupling>& couplings);

}  // namespace parison::thermal
