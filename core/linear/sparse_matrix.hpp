#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::core {

/// Cliques of the matrix graph: groups of unknowns that all couple with one another, as those of an element or of an
/// interface point.
struct Cliques {
  std::vector<Index> start{0};  ///< clique c holds unknowns[start[c]] ... unknowns[start[c+1]-1]
  std::vector<Index> unknowns;

  void add(const Index* begin, Index count);
  Index count() const { return static_cast<Index>(start.size()) - 1; }
};

enum class Triangle { lower, upper };

/// A triangle of a symmetric sparse matrix, compressed columns with sorted rows, every diagonal entry present.
/// The pattern is made once and kept; only the values change.
struct SymmetricMatrix {
  Index size = 0;
  std::vector<Index> column_start, row;
  std::vector<double> value;
};

/// Position in SymmetricMatrix::value of the entries of each clique's dense matrix: for clique c, the packed lower
/// triangle by rows
/// ((0,0) (1,0) (1,1) (2,0) ...) from offset[c].
struct Scatter {
  std::vector<Index> offset, position;
};

/// A matrix and where the cliques are added to it.
struct Assembly {
  SymmetricMatrix matrix;  ///< values zero
  Scatter scatter;
};
/// Symbolic assembly: the pattern of the sum over all cliques, size x size.
Assembly make_assembly(Index size, const Cliques& cliques, Triangle triangle = Triangle::lower);

/// Adds the dense symmetric matrix of a clique; `local` is row-major count x count, its lower triangle is read.
void add_clique(SymmetricMatrix& matrix, const Scatter& scatter, Index clique, Index count, const double* local);

/// Full symmetric product A x.
Eigen::VectorXd multiply(const SymmetricMatrix& matrix, const Eigen::VectorXd& x);

}  // namespace parison::core
