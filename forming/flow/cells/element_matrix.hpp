#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "forming/flow/cells/cell_geometry.hpp"
#include "forming/flow/problem.hpp"

namespace parison::flow {

/// Unknowns of a cell: the velocity of its 6 nodes, then the pressure at its 3 vertices.
inline constexpr int cell_velocities = 6 * core::dim;
inline constexpr int cell_unknowns = cell_velocities + 3;
using CellMatrix = Eigen::Matrix<double, cell_unknowns, cell_unknowns, Eigen::RowMajor>;

/// Entries of a cell's lower triangle, packed by rows, and the index of one of them, column <= row.
inline constexpr int cell_entries = cell_unknowns * (cell_unknowns + 1) / 2;
constexpr int packed(int row, int column) {
  return row * (row + 1) / 2 + column;
}

/// Symmetric saddle-point matrices of the cells of a batch, with the load of gravity.
struct BatchMatrix {
  BatchMatrix() {}                       // left unset: all of it is written once
  VectorizedArray matrix[cell_entries];  ///< packed lower triangle
  VectorizedArray load[cell_unknowns];   ///< N
};
/// The matrices of all cells.
struct CellMatrices {
  std::vector<BatchMatrix> batches;

  /// Entries of the packed lower triangle, a lane for each cell of the batch.
  const VectorizedArray* batch(Index batch) const { return batches[batch].matrix; }
  double load_at(Index cell, int unknown) const { return batches[cell / batch_size].load[unknown][cell % batch_size]; }
  /// One cell's matrix, whole.
  CellMatrix of(Index cell) const;
};

/// Viscosity at each quadrature point (cells x cell_points), Pa.s; `velocity` feeds the Carreau factor and may be
/// empty.
std::vector<double> viscosity_field(const Problem& problem, const CellGeometry& geometry,
                                    const Eigen::VectorXd& velocity);

/// Taylor-Hood P2-P1 cells. The pressure block -1/bulk, local, keeps a full cavity regular; it is far below any volume
/// drift that counts.
CellMatrices cell_matrices(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity);

/// The rate of deformation is singular at corners of tools; `high_rate` is what this share of the volume exceeds.
inline constexpr double high_rate_fraction = 0.02;

/// Viscous dissipation and rates of deformation sqrt(2 D:D) of a flow.
struct Dissipation {
  std::vector<double> power;  ///< 2 eta D:D dV at each quadrature point, W, cells x cell_points
  double mean_rate = 0;       ///< root mean square over the volume, 1/s
  double high_rate = 0;       ///< exceeded in `high_rate_fraction` of the volume, 1/s
};
Dissipation dissipation(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                        const Eigen::VectorXd& velocity);

/// Adds to the cells' matrices what the viscous forces change by through the Carreau factor, at a velocity that gives
/// `viscosity`: 8 d eta/d(rate^2) (D:dD)(D:dD'). The matrices stay symmetric, and positive where the law's exponent is.
void add_thinning_derivative(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                             const Eigen::VectorXd& velocity, CellMatrices& cells);

/// Chooses between Newton's steps and those with the viscosity as it is (Kacanov's), which are slow but always approach
/// the answer: a Newton step that moves the flow further than the step before is followed by ever more of the latter.
class NewtonGuard {
 public:
  /// Whether the next step may be Newton's after one that changed the velocities by `moved`, relative.
  bool accepts(double moved);

 private:
  double last_moved_ = std::numeric_limits<double>::infinity();
  int penalty_ = 0, left_ = 0;
};

}  // namespace parison::flow
