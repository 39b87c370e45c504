// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/QR>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "forming/study/uncertainty/effects.hpp"

namespace parison::forming {

namespace {

using core::Distribution;

constexpr int rule_points = 4000;

/// Midpoints of the range with weights of sum 1.
struct Rule {
  std::vector<double> place, weight;
};

Rule midpoint_rule(const StandardScatter& scatter) {
  Rule rule;
  double sum = 0;
  for (int i = 0; i < rule_points; ++i) {
    const double at = scatter.low + (scatter.high - scatter.low) * (i + 0.5) / rule_points;
    rule.place.push_back(at);
    rule.weight.push_back(scatter.distribution == Distribution::uniform ? 1.0 : std::exp(-0.5 * at * at));
    sum += rule.weight.back();
  }
  for (double& weight : rule.weight) weight /= sum;
  return rule;
}

}  // namespace

StandardScatter full_range(Distribution distribution) {
  const double end = distribution == Distribution::uniform ? std::sqrt(3.0) : 4;
  return {distribution, -end, end};
}

double quantile(const StandardScatter& scatter, double share) {
  if (scatter.distribution == Distribution::uniform)
    return std::min(scatter.high, scatter.low + share * (scatter.high - scatter.low));
  const boost::math::normal normal;
  const double below = cdf(normal, scatter.low), within = cdf(normal, scatter.high) - below;
  if (share <= 0) return scatter.low;
  return std::min(scatter.high, std::max(scatter.low, boost::math::quantile(normal, below + share * within)));
}

OrthonormalPolynomials::OrthonormalPolynomials(const StandardScatter& scatter, int highest_degree) {
  const Rule rule = midpoint_rule(scatter);
  std::vector<double> before(rule.place.size(), 0), now(rule.place.size(), 1);
  for (int degree = 0; degree <= highest_degree; ++degree) {
    double alpha = 0, norm = 0;
    for (std::size_t i = 0; i < now.size(); ++i) alpha += rule.weight[i] * rule.place[i] * now[i] * now[i];
    std::vector<double> next(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
      next[i] = (rule.place[i] - alpha) * now[i] - (degree > 0 ? root_beta_.back() * before[i] : 0);
      norm += rule.weight[i] * next[i] * next[i];
    }
    alpha_.push_back(alpha);
    root_beta_.push_back(std::sqrt(norm));
    for (double& value : next) value /= root_beta_.back();
    before = std::move(now);
    now = std::move(next);
  }
}

std::vector<double> OrthonormalPolynomials::operator()(double at) const {
  std::vector<double> values{1};
  for (std::size_t degree = 0; degree + 1 < alpha_.size(); ++degree) {
    const double before = degree > 0 ? root_beta_[degree - 1] * values[degree - 1] : 0;
    values.push_back(((at - alpha_[degree]) * values[degree] - before) / root_beta_[degree]);
  }
  return values;
}

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int highest_order = 12, most_variables = 3, folds = 10;
constexpr double hyperbola = 0.75;

double order_of(const ChaosTerm& term) {
  double sum = 0;
  for (const int degree : term) sum += std::pow(degree, hyperbola);
  return std::pow(sum, 1 / hyperbola);
}

/// Adds all terms of an order up to `limit` that begin like `term` in its first variables.
void add_terms(ChaosTerm& term, std::size_t variable, double limit, std::vector<ChaosTerm>& terms) {
  if (variable == term.size()) {
    terms.push_back(term);
    return;
  }
  const auto used = std::count_if(term.begin(), term.begin() + std::ptrdiff_t(variable), [](int k) { return k > 0; });
  for (int degree = 0; degree == 0 || used < most_variables; ++degree) {
    term[variable] = degree;
    if (order_of(term) > limit + 1e-9) break;
    add_terms(term, variable + 1, limit, terms);
  }
  term[variable] = 0;
}

/// The terms of the highest order of which there are no more than `most`, but at least those of the first order.
std::vector<ChaosTerm> terms_up_to(std::size_t variables, std::size_t most, std::vector<std::size_t>& levels) {
  std::vector<ChaosTerm> kept;
  for (int order = 1; order <= highest_order; ++order) {
    std::vector<ChaosTerm> terms;
    ChaosTerm none(variables, 0);
    add_terms(none, 0, order, terms);
    if (order > 1 && terms.size() > most) break;
    std::stable_sort(terms.begin(), terms.end(),
                     [](const ChaosTerm& a, const ChaosTerm& b) { return order_of(a) < order_of(b) - 1e-9; });
    kept = std::move(terms);
    levels.push_back(kept.size());
  }
  return kept;
}

/// Steps of the choice of terms on some of the rows: `chosen` terms in their order, and the mean square error at the
/// other rows after each number of them.
struct Path {
  std::vector<std::size_t> chosen;
  std::vector<double> unseen;
};

/// `seen` and `held` hold the basis without its constant; both are orthogonalised as `seen` asks for.
Path choose_terms(MatrixXd seen, VectorXd y, MatrixXd held, VectorXd z, Index most) {
  Path path;
  const double mean = y.mean();
  const Eigen::RowVectorXd means = seen.colwise().mean();
  y.array() -= mean, z.array() -= mean;
  seen.rowwise() -= means, held.rowwise() -= means;
  const VectorXd first = seen.colwise().squaredNorm();
  const auto note = [&] { path.unseen.push_back(z.size() > 0 ? z.squaredNorm() / double(z.size()) : 0); };
  note();
  for (Index step = 0; step < most; ++step) {
    const VectorXd norms = seen.colwise().squaredNorm(), products = seen.transpose() * y;
    Index best = -1;
    double most_explained = 0;
    for (Index j = 0; j < norms.size(); ++j)  // a term that those before nearly make up would be noise
      if (norms[j] > 1e-6 * first[j] && products[j] * products[j] > most_explained * norms[j]) {
        most_explained = products[j] * products[j] / norms[j];
        best = j;
      }
    if (best < 0) break;
    const double norm = std::sqrt(norms[best]);
    const VectorXd q = seen.col(best) / norm, q_held = held.col(best) / norm;
    const double share = q.dot(y);
    y -= share * q, z -= share * q_held;
    const Eigen::RowVectorXd along = q.transpose() * seen;
    seen.noalias() -= q * along;
    held.noalias() -= q_held * along;
    seen.col(best).setZero();
    path.chosen.push_back(static_cast<std::size_t>(best) + 1);
    note();
  }
  return path;
}

MatrixXd rows_of(const MatrixXd& all, const std::vector<Index>& rows, Index columns) {
  MatrixXd some(Index(rows.size()), columns - 1);
  for (std::size_t i = 0; i < rows.size(); ++i) some.row(Index(i)) = all.row(rows[i]).segment(1, columns - 1);
  return some;
}

VectorXd members(const VectorXd& all, const std::vector<Index>& rows) {
  VectorXd some(Index(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) some[Index(i)] = all[rows[i]];
  return some;
}

/// Squares of the errors at unseen rows over the number of terms, with the first `columns` of the basis.
std::vector<double> cross_validate(const MatrixXd& values, const VectorXd& y, Index columns, Index most) {
  std::vector<double> sums;
  const Index parts = std::min<Index>(folds, y.size());
  for (Index fold = 0; fold < parts; ++fold) {
    std::vector<Index> seen, held;
    for (Index i = 0; i < y.size(); ++i) (i % parts == fold ? held : seen).push_back(i);
    const Path path = choose_terms(rows_of(values, seen, columns), members(y, seen), rows_of(values, held, columns),
                                   members(y, held), most);
    sums.resize(std::max(sums.size(), path.unseen.size()), 0);
    for (std::size_t i = 0; i < sums.size(); ++i)  // a fold that ran out of terms stays where it is
      sums[i] += path.unseen[std::min(i, path.unseen.size() - 1)] * double(held.size());
  }
  for (double& sum : sums) sum /= double(y.size());
  return sums;
}

struct Choice {
  Index columns = 1;
  std::size_t terms = 0;
  double unseen = std::numeric_limits<double>::infinity();
};

/// The order and the number of terms with the least error at unseen rows; orders end after two that gain nothing.
Choice best_choice(const ChaosBasis& basis, const MatrixXd& values, const VectorXd& y) {
  Choice best;
  int without_gain = 0;
  for (const std::size_t level : basis.levels) {
    const Index columns = Index(level), most = std::min<Index>({columns - 1, y.size() / 2, 60});
    const std::vector<double> errors = cross_validate(values, y, columns, most);
    const auto least = std::min_element(errors.begin(), errors.end());
    without_gain = *least < best.unseen ? 0 : without_gain + 1;
    if (*least < best.unseen) best = {columns, std::size_t(least - errors.begin()), *least};
    if (without_gain == 2) break;
  }
  return best;
}

void solve(const MatrixXd& values, const VectorXd& y, Surrogate& surrogate) {
  MatrixXd matrix(y.size(), Index(surrogate.terms.size()));
  for (std::size_t i = 0; i < surrogate.terms.size(); ++i) matrix.col(Index(i)) = values.col(Index(surrogate.terms[i]));
  surrogate.solution = matrix.householderQr().solve(MatrixXd::Identity(y.size(), y.size()));
  surrogate.coefficients = surrogate.solution * y;
  const VectorXd rest = y - matrix * surrogate.coefficients;
  surrogate.residuals.resize(y.size());
  for (Index i = 0; i < y.size(); ++i)
    surrogate.residuals[i] = rest[i] / std::max(1e-6, 1 - matrix.row(i).dot(surrogate.solution.col(i)));
  surrogate.variance = rest.squaredNorm() / double(std::max<Index>(1, y.size() - matrix.cols()));
}

}  // namespace

ChaosBasis chaos_basis(const std::vector<StandardScatter>& scatters, const MatrixXd& places) {
  ChaosBasis basis;
  basis.terms = terms_up_to(scatters.size(), 3 * std::size_t(places.rows()), basis.levels);
  for (const StandardScatter& scatter : scatters) basis.polynomials.emplace_back(scatter, highest_order);
  basis.values.resize(places.rows(), Index(basis.terms.size()));
  for (Index run = 0; run < places.rows(); ++run) {
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < scatters.size(); ++i) values.push_back(basis.polynomials[i](places(run, Index(i))));
    for (std::size_t term = 0; term < basis.terms.size(); ++term) {
      double product = 1;
      for (std::size_t i = 0; i < scatters.size(); ++i) product *= values[i][std::size_t(basis.terms[term][i])];
      basis.values(run, Index(term)) = product;
    }
  }
  return basis;
}

Surrogate fit_surrogate(const ChaosBasis& basis, const std::vector<Index>& runs, const VectorXd& values) {
  MatrixXd rows(Index(runs.size()), basis.values.cols());
  for (std::size_t i = 0; i < runs.size(); ++i) rows.row(Index(i)) = basis.values.row(runs[i]);
  const Choice choice = best_choice(basis, rows, values);
  Surrogate surrogate;
  surrogate.terms.push_back(0);
  const MatrixXd candidates = rows.middleCols(1, choice.columns - 1);
  const Path path = choose_terms(candidates, values, MatrixXd(0, candidates.cols()), VectorXd(0), Index(choice.terms));
  surrogate.terms.insert(surrogate.terms.end(), path.chosen.begin(), path.chosen.end());
  solve(rows, values, surrogate);
  surrogate.unseen = choice.unseen;
  return surrogate;
}

}  // namespace parison::forming
