#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "thermal/system.hpp"
#include "thermal/time/couplings.hpp"
#include "thermal/time/substeps.hpp"

namespace parison::thermal {

/// Derivatives of content and power with respect to temperature at the quadrature points of a batch of cells.
struct BatchDerivatives {
  PointValues capacity;        ///< J/K
  PointValues conductivity;    ///< W/m/K
  PointValues flow_a, flow_b;  ///< of the heat flow along the reference coordinates through dk/dT alone, W/K
};
/// Full derivative of the heat equations at a time and temperatures, including those of conductivity and conductance.
struct Linearisation {
  std::vector<BatchDerivatives> batches;
  std::vector<std::array<double, 3>> edges;  ///< of the exchange with the air at the points of edge_rule(3), W/K
  ContactDerivatives contacts;
  std::vector<LightDerivatives> light;  ///< of each body in HeatSystem::light
  Eigen::ArrayXd enclosure;             ///< of the emissive power at the points of the enclosure, W/m2/K
};
Linearisation linearise(const HeatSystem& system, double time, const Eigen::VectorXd& temperature);

/// Product of the derivative of content - step power with a change of the temperatures, K: J by unknown.
Eigen::VectorXd apply(const HeatSystem& system, const Linearisation& linearisation, double step,
                      const Eigen::VectorXd& change);

/// Matrix of the stages, the upper triangle with the unknowns in the elimination order. Of the derivatives of
/// conductivity and conductance K contains only the symmetric positive part: a conductance that rises with the slave's
/// temperature, in the slave's own block. Newton's method with this matrix is a modified one; solve_stage also uses the
/// full derivative.
struct StepMatrix : HeatMatrix {
  std::vector<Index> topology;      ///< unknowns of all cells and boundary edges
  std::vector<Coupling> couplings;  ///< wanted in the pattern; `prepare` replaces them where the interface asks
  std::vector<Coupling> analysed_couplings;  ///< present in the pattern
  Index first_coupling = 0;                  ///< clique of the first coupling
  std::vector<Index> segment_clique;         ///< of each segment of the interface
  std::vector<Index> order;                  ///< elimination order: order[k] is the unknown eliminated as the k-th
  std::vector<KeptCells> kept;               ///< by body
};

/// Adds a dense symmetric matrix of the given unknowns, row-major count x count, J/K, except for the rows and columns
/// of prescribed unknowns.
void add_clique(StepMatrix& matrix, const HeatSystem& system, Index clique, Index count, const Index* unknowns,
                double* local);
/// The same of a boundary edge, counted through all bodies: the sum over the points of edge_rule(3) of a factor times
/// the shapes of two unknowns.
void add_edge(StepMatrix& matrix, const HeatSystem& system, Index edge, const std::array<Index, 3>& unknowns,
              const std::array<double, 3>& factor, const EdgeShapes& shape);
/// Prepares sparsity pattern and symbolic analysis for the system. Both depend on the system and on
/// `matrix.couplings` only; where those lack a coupling of the interface they are replaced by a wider set. The factor
/// is dropped when the pattern or the set of prescribed unknowns changes.
void prepare(StepMatrix& matrix, const HeatSystem& system);
/// Assembles C + step K at a time and temperatures and factorises it; false when it is not positive definite.
[[nodiscard]] bool factorise(StepMatrix& matrix, const HeatSystem& system, double time,
                             const Eigen::VectorXd& temperature, double step);

/// Elimination order of a heat system's unknowns: approximate minimum degree (Amestoy, Davis and Duff 1996) on the
/// graph of the vertices, each mid-side node right before the first vertex of its edge.
std::vector<Index> elimination_order(const HeatSystem& system, const std::vector<Coupling>& couplings);

}  // namespace parison::thermal
