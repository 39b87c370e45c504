#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "forming/study/search/case/search_case.hpp"
#include "forming/study/search/outcome.hpp"

namespace parison::forming {

/// A limit on a quantity of the results.
struct Limit {
  std::string quantity, unit;
  double value;  ///< in the unit of the quantity
  bool at_least;
};

/// What is wanted: an even wall, the thickness of a table or a number, or a value of a quantity, each by least squares;
/// or the least or the most of a quantity.
struct Target {
  enum class Kind { even_wall, wall, value, least, most } kind;
  std::string quantity;    ///< of value, least, most
  std::string unit = "%";  ///< of it
  double value = 0;        ///< of it in its unit; of a wall one thickness, mm
  WallTable wall;          ///< where a table is given
  WallPart part;
  /// Where the search ends: at an rms of a wall in %, a difference in the quantity's unit, the least or the most
  /// itself.
  std::optional<double> good_enough;

  bool is_scalar() const { return kind == Kind::least || kind == Kind::most; }
};

/// A goal file as it is written.
struct Goal : SearchCase {
  std::string directory, name;
  std::string confirm;   ///< accuracy at which the answer is run with error bars; empty: not at all
  std::size_t runs = 0;  ///< of the search at most
  /// How many times at most the search is corrected by the run of its answer at `confirm`; 0 where that is not finer.
  std::size_t corrections = 0;
  Target target;
  std::vector<Limit> limits;
};

/// What a run is worth.
struct Worth {
  Eigen::VectorXd residual;  ///< of least squares, with the weighed excess of the limits behind it; of a scalar empty
  Eigen::VectorXd excess;    ///< of each limit, positive where it does not hold, shares of its scale
  double value;              ///< what is to be as small as can be: rms in %, difference or quantity in its unit
  bool holds() const { return (excess.array() <= 1e-9).all(); }
};

/// Whether a run is worth more: of least squares by its residual, else by its value where the limits hold, and by how
/// far they are missed where they do not.
bool is_better(const Worth& a, const Worth& b);

/// Nothing where the run lacks what the goal needs.
std::optional<Worth> worth(const Goal& goal, const Outcome& outcome);

/// The worth's value at which the goal is as good as it need be; nothing where the file does not say.
std::optional<double> good_value(const Goal& goal);

/// The norm of the residual at which it is; 0 where the file does not say.
double good_norm(const Goal& goal);

/// What the value is, in words: "rms deviation of the wall from its mean, %".
std::string what_is_sought(const Goal& goal);

}  // namespace parison::forming
