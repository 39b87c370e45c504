// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/fixed_point.hpp"

#include <kinsol/kinsol.h>
#include <nvector/nvector_serial.h>

#include <limits>
#include <utility>

namespace parison::forming {
namespace {

Eigen::Map<Eigen::VectorXd> view(N_Vector vector) {
  return {N_VGetArrayPointer(vector), static_cast<Eigen::Index>(N_VGetLength(vector))};
}

/// What the callback of KINSOL works with.
struct Search {
  const VectorMap& map;
  const FixedPointOptions& options;
  FixedPointOutcome outcome;
  double least = std::numeric_limits<double>::infinity();  ///< change so far
  Eigen::VectorXd best = {};                               ///< value of the map that belongs to it
  bool again = false;                                      ///< whether KINSOL is to begin anew from there
};

/// The map at `at`. What is negative ends KINSOL: the tolerance is met, nothing more can be evaluated, or the
/// acceleration leads away: close to the end the changes it goes by are nearly parallel.
int evaluate(N_Vector at, N_Vector image, void* data) {
  constexpr int enough = -1;
  constexpr double away = 10;  // times the least change so far
  auto& search = *static_cast<Search*>(data);
  search.again = false;
  if (search.outcome.evaluations == search.options.max_evaluations) return enough;
  const Eigen::VectorXd x = view(at);
  auto value = search.map(x);
  if (!value) return enough;
  ++search.outcome.evaluations;
  view(image) = *value;
  search.outcome.change = search.options.size(*value - x);
  search.outcome.value = std::move(*value);
  search.outcome.converged = search.outcome.change <= search.options.tolerance;
  search.again = !search.outcome.converged && search.outcome.change > away * search.least;
  if (search.outcome.change < search.least) search.least = search.outcome.change, search.best = search.outcome.value;
  return search.outcome.converged || search.again ? enough : 0;
}

void say_nothing(int, const char*, const char*, char*, void*) {}

}  // namespace

FixedPointOutcome find_fixed_point(const Eigen::VectorXd& start, const VectorMap& map,
                                   const FixedPointOptions& options) {
  Search search{map, options, {}};
  search.outcome.value = start;
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  N_Vector x = N_VNew_Serial(start.size(), context), scale = N_VClone(x);
  view(x) = start;
  N_VConst(1, scale);
  void* solver = KINCreate(context);
  KINSetErrHandlerFn(solver, say_nothing, nullptr);
  KINSetMAA(solver, options.depth);
  KINSetDelayAA(solver, options.delay);
  KINSetNumMaxIters(solver, options.max_evaluations + 1);
  KINInit(solver, evaluate, x);
  KINSetUserData(solver, &search);
  KINSetFuncNormTol(solver, std::numeric_limits<double>::min());  // the callback says when it is enough
  KINSol(solver, x, KIN_FP, scale, scale);
  while (search.again) {
    view(x) = search.best;
    KINSol(solver, x, KIN_FP, scale, scale);
  }
  KINFree(&solver);
  N_VDestroy(scale);
  N_VDestroy(x);
  SUNContext_Free(&context);
  return std::move(search.outcome);
}

}  // namespace parison::forming
