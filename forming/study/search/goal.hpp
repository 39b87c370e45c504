#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>
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

/// What a finer accuracy adds to the results of a coarser one, from a place of the variables that was run at both.
/// Added to the runs at other places it makes of the coarser model one that agrees with the finer at that place (N. M.
/// Alexandrov, R. M. Lewis, C. R. Gumbert, L. L. Green and P. A. Newman, J. Aircraft 38 (2001) 1093-1101; J. W. Bandler
/// et al., IEEE Trans. Microwave Theory Tech. 52 (2004) 337-361).
struct Correction {
  Wall wall;                         ///< differences place by place over the outer arc; empty where one has no wall
  std::vector<Quantity> quantities;  ///< differences of those that both have
};

Correction correction_from(const Outcome& coarse, const Outcome& fine);

/// A run with the difference added; `wall_rms` and `wall_min` are those of the corrected wall. What the correction does
/// not have is left out, and a run without results stays as it is.
Outcome corrected(const Outcome& run, const Correction& correction, const WallPart& part);

/// Whether the finer accuracy misses `good_enough` or a limit which the coarser one held or came nearer to.
bool is_misled(const Goal& goal, const Worth& coarse, const Worth& fine);

/// Reads a goal file; `find_case` says where the case is that it names, from its folder. Throws core::CaseError with
/// file, line and key where it is wrong, where it names what the case does not have, or where no run can reach it.
Goal read_goal(const std::string& path,
               const std::function<std::string(const std::string& directory, const std::string& given)>& find_case);

}  // namespace parison::forming
